// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/complex.h>
#include <vfife/base/types.h>
#include <vfife/study/reduced/speed_response.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vfife
{
  namespace
  {
    /** Mean, standard deviation, smallest and largest of samples. */
    struct Statistics
    {
      double mean = 0, rms = 0, least = 0, largest = 0;

      explicit Statistics(const std::vector<double> &samples)
      {
        if (samples.empty())
          return;
        mean = std::accumulate(samples.begin(), samples.end(), 0.) / samples.size();
        for (const double value : samples)
          rms += (value - mean) * (value - mean);
        rms                    = std::sqrt(rms / samples.size());
        const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
        least                  = *low;
        largest                = *high;
      }
    };
  } // namespace

  std::vector<double> cut_spectrum(const std::vector<double> &samples, const std::size_t highest)
  {
    const std::size_t n = samples.size();
    if (2 * highest + 1 >= n)
      return samples;
    std::vector<double> cut(n, 0.);
    for (std::size_t k = 0; k <= highest; ++k)
      {
        const Complex turn = std::polar(1., 2. * pi * k / n);
        Complex       part = 0, phase = 1;
        for (const double sample : samples)
          {
            part += sample * std::conj(phase);
            phase *= turn;
          }
        part *= (k > 0 ? 2. : 1.) / n;
        phase = 1;
        for (double &value : cut)
          {
            value += (part * phase).real();
            phase *= turn;
          }
      }
    return cut;
  }

  void SpeedResponse::add(SpeedSample sample)
  {
    samples_.push_back(std::move(sample));
  }

  LumpedResponse SpeedResponse::response(const double energy_error) const
  {
    std::vector<double> errors, forces;
    for (const SpeedSample &sample : samples_)
      {
        errors.push_back(sample.error);
        forces.push_back(sample.force);
      }
    const Statistics error(errors), force(cut_spectrum(forces, highest_));
    LumpedResponse   response;
    response.mean_error    = error.mean;
    response.rms_error     = error.rms;
    response.pp_error      = error.largest - error.least;
    response.mean_force    = force.mean;
    response.rms_force     = force.rms;
    response.pp_force      = force.largest - force.least;
    response.largest_force = force.largest;
    unsigned int n_apart   = 0;
    for (std::size_t i = 0; i < forces.size(); ++i)
      if (!(forces[i] > 0))
        {
          ++n_apart;
          response.losses += i > 0 && forces[i - 1] > 0 ? 1 : 0;
        }
    const auto n_coast    = std::count_if(samples_.begin(), samples_.end(), [](const auto &sample) {
      return sample.coast;
    });
    response.time_apart   = double(n_apart) / samples_.size();
    response.time_coast   = double(n_coast) / samples_.size();
    response.energy_error = energy_error;
    return response;
  }

  std::pair<double, double> SpeedResponse::wave(const unsigned int n) const
  {
    Complex mean = 0;
    for (const SpeedSample &sample : samples_)
      mean += sample.waves[n - 1];
    mean /= double(samples_.size());
    double largest = 0;
    for (const SpeedSample &sample : samples_)
      largest = std::max(largest, std::abs(sample.waves[n - 1] - mean));
    return {std::abs(mean), largest};
  }

  double SpeedResponse::largest_stress(const std::size_t place) const
  {
    std::vector<double> stresses;
    for (const SpeedSample &sample : samples_)
      stresses.push_back(sample.stresses[place]);
    const std::vector<double> cut = cut_spectrum(stresses, highest_);
    return *std::max_element(cut.begin(), cut.end());
  }
} // namespace vfife
