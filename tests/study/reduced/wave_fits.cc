// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Fits of resonance curves and build-ups against what they were made of.
#include "../../parts.h"
#include "../../refusal.h"
#include "../../tests.h"

#include <vfife/base/errors.h>
#include <vfife/base/types.h>
#include <vfife/study/waves/wave_fits.h>

using namespace vfife;

const std::vector<double> offsets = {-.03, -.01, 0., .01, .03};

void resonance()
{
  // Peak beside the middle, a background, five speeds: the fit is exact.
  const double         peak = 812., width = 31.;
  const Complex        residue = std::polar(40., 1.1), background(.3, -.7);
  std::vector<double>  speeds;
  std::vector<Complex> waves, alone;
  for (const double part : offsets)
    {
      speeds.push_back(800. * (1. + part));
      alone.push_back(residue / (speeds.back() - Complex(peak, -.5 * width)));
      waves.push_back(alone.back() + background);
    }
  const ResonanceFit fit = fit_resonance(speeds, waves);
  check_close("peak", fit.peak, peak, 1e-8);
  check_close("width", fit.width, width, 1e-8);
  check_close("amplitude at the peak", fit.amplitude, 40. / (.5 * width), 1e-9);
  check_below("background", std::abs(fit.background - background), 1e-9);
  check_below("residual", fit.residual, 1e-10);
  check_below("curve at another speed",
              std::abs(fit.value(805.) - residue / (805. - Complex(peak, -.5 * width)) -
                       background),
              1e-9);
  const ResonanceFit three =
    fit_resonance({speeds[0], speeds[2], speeds[4]}, {alone[0], alone[2], alone[4]});
  check_close("three speeds: width", three.width, width, 1e-8);

  // What is not of this form is told by the residual: another resonance near by. With its pole
  // known both are found.
  const Complex other(818., 4.);
  for (const double speed : {788., 821.})
    {
      speeds.push_back(speed);
      waves.push_back(residue / (speed - Complex(peak, -.5 * width)) + background);
    }
  for (std::size_t k = 0; k < waves.size(); ++k)
    waves[k] += 10. / (speeds[k] - other);
  check("two resonances leave a residual", fit_resonance(speeds, waves).residual > .02);
  const ResonanceFit both = fit_resonance(speeds, waves, {other});
  check_close("beside another: width", both.width, width, 1e-7);
  check_close("beside another: amplitude", both.amplitude, 40. / (.5 * width), 1e-8);
  check_below("beside another: residue of that",
              both.others.size() == 1 ? std::abs(both.others[0].first - 10.) : 1.,
              1e-7);
  check_below("beside another: background", std::abs(both.background - background), 1e-8);
  check_below("beside another: residual", both.residual, 1e-10);
}

/** A damped mode over the frequency of its force: half-power width 2 ratio, to its first order.
 */
void mode()
{
  const double         omega = 1., ratio = .01;
  std::vector<double>  frequencies;
  std::vector<Complex> waves;
  for (const double part : offsets)
    {
      frequencies.push_back(omega * (1. + part));
      const double w = frequencies.back();
      waves.push_back(1. / Complex(omega * omega - w * w, 2. * ratio * omega * w));
    }
  const ResonanceFit fit = fit_resonance(frequencies, waves);
  check_close("mode: peak", fit.peak, omega, 2e-4);
  check_ratio("mode: width over twice the damping ratio", fit.width / (2. * ratio), 1e-2);
  check_ratio("mode: amplitude", fit.amplitude * 2. * ratio, 1e-2);
}

void build_up()
{
  const double         decay = 480., beat = -900., interval = 2.6e-4;
  const Complex        end(3., 1.);
  std::vector<Complex> samples;
  for (int k = 0; k < 12; ++k)
    samples.push_back(end * (1. - std::exp(Complex(-decay, beat) * (k * interval))));
  const BuildUpFit fit = fit_build_up(samples, interval);
  check_close("decay of the build-up [1/s]", fit.decay, decay, 1e-8);
  check_close("beat [rad/s]", fit.beat, beat, 1e-8);
  // Twelve samples last 1.5 decay times: the end is not reached, and found.
  check("the end is not reached", std::abs(samples.back() - end) > .2 * std::abs(end));
  check_below("end", std::abs(fit.end - end), 1e-10);
  check_below("residual", fit.residual, 1e-12);
  // Something else that rings and decays faster is told apart.
  std::vector<Complex> both = samples;
  for (int k = 0; k < 12; ++k)
    both[k] += .4 * std::exp(Complex(-1000., 4000.) * (k * interval));
  check_close("beside another motion: decay", fit_build_up(both, interval).decay, decay, 1e-6);
  check_below("curve", std::abs(fit.value(3. * interval) - samples[3]), 1e-10);
  samples[5] *= 1.1;
  check("another sample leaves a residual", fit_build_up(samples, interval).residual > 1e-2);
}

void refusals()
{
  print_refusal<NumericalError>([] { fit_resonance({1., 2.}, {1., 1.}); });
  print_refusal<NumericalError>([] {
    fit_resonance({1., 2., 3., 4.}, {1., 1., 2., 1.}, {Complex(2., 1.)});
  });
  print_refusal<NumericalError>([] { fit_build_up({1., 2., 3., 4., 5., 6., 7.}, 1.); });
  print_refusal<NumericalError>([] { fit_line({1.}, {1.}); });
}

int main()
{
  return run_parts({resonance, mode, build_up, refusals});
}
