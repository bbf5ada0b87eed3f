// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Lines of the unloaded transmission error over a turn of a gear with pitch errors: at n f_mesh +-
// q f_shaft as the staircase of the teeth in mesh has them (doc/theory/errors.md, Sidebands).
#include "../tests.h"
#include "paper_pair.h"

#include <vfife/gear/unloaded_contact/unequal_teeth.h>

#include <complex>

using namespace vfife;

constexpr double       um    = 1e-3;
constexpr unsigned int teeth = 79, samples = 32; // a mesh cycle

/** Amplitudes of the lag over the order, per turn of the gear [rad]. */
std::vector<double> find_lines(const GearPair &pair, const std::vector<unsigned int> &orders)
{
  UnequalTeeth        contact(pair, MeshSide::drive);
  std::vector<double> lags;
  for (unsigned int i = 0; i < teeth * samples; ++i)
    lags.push_back(contact.at(double(i) / samples).lag);
  std::vector<double> amplitudes;
  for (const unsigned int m : orders)
    {
      std::complex<double> sum = 0.;
      for (unsigned int i = 0; i < lags.size(); ++i)
        sum += lags[i] * std::polar(1., -2. * pi * m * i / lags.size());
      amplitudes.push_back(2. * std::abs(sum) / lags.size());
    }
  return amplitudes;
}

void check_lines(const double amplitude, const unsigned int q, const double bound)
{
  GearPairOptions options                    = paper::options();
  options.gear_errors.convex.pitch_amplitude = amplitude;
  options.gear_errors.convex.pitch_order     = q;
  const GearPair                  pair(options);
  const double                    r      = 116.49 * std::sin(pair.gear().blank().pitch_angle);
  const std::vector<unsigned int> orders = {q, teeth - q, teeth + q, 2 * teeth - q, 2 * teeth + q};
  const std::vector<double>       lines  = find_lines(pair, orders);
  for (std::size_t i = 0; i < orders.size(); ++i)
    {
      // Each tooth lasts a mesh: the staircase of a cosine, seen at the samples.
      const double expected = amplitude / r * std::abs(std::sin(pi * q / teeth)) /
                              (samples * std::sin(pi * orders[i] / (samples * teeth)));
      check_ratio("cosine of " + std::to_string(q) + " periods, " +
                    std::to_string(int(std::lround(1e3 * amplitude / um))) + " nm: order " +
                    std::to_string(orders[i]),
                  lines[i] / expected,
                  bound);
    }
}

int main()
{
  // So small that the hand-over stays between the same samples.
  check_lines(.02 * um, 9, .01);
  return 0;
}
