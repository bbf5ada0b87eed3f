// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/sample_measures.h>
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
        mean = mean_of(samples);
        for (const double value : samples)
          rms += (value - mean) * (value - mean);
        rms                    = std::sqrt(rms / samples.size());
        const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
        least                  = *low;
        largest                = *high;
      }
    };
  } // namespace

  SpeedResponse::SpeedResponse(LowPass low_pass, FindLargest find_largest)
    : low_pass_(std::move(low_pass))
    , find_largest_(std::move(find_largest))
  {
  }

  void SpeedResponse::add(SpeedSample sample)
  {
    Eigen::VectorXd all(2 + sample.vibration.size());
    all << sample.error, sample.force,
      Eigen::Map<const Eigen::VectorXd>(sample.vibration.data(), sample.vibration.size());
    waiting_.push_back(std::move(sample));
    const std::optional<Eigen::VectorXd> slow = low_pass_.add(std::move(all));
    if (waiting_.size() <= n_around())
      return;
    // Where there are not as many before it, the sample is one of those around.
    if (slow)
      count(std::move(waiting_.front()), *slow);
    waiting_.pop_front();
  }

  void SpeedResponse::count(SpeedSample sample, const Eigen::VectorXd &slow)
  {
    errors_.push_back(sample.error);
    forces_.push_back(sample.force);
    slow_errors_.push_back(slow[0]);
    slow_forces_.push_back(slow[1]);
    n_coast_ += sample.coast ? 1 : 0;
    for (std::size_t n = 0; n < sample.waves.size(); ++n)
      waves_[n].push_back(sample.waves[n]);
    Eigen::Map<Eigen::VectorXd>(sample.slow_stresses.data(), sample.slow_stresses.size()) +=
      slow.tail(slow.size() - 2);
    const std::vector<double> largest = find_largest_(sample.slow_stresses);
    largest_stresses_.resize(largest.size(), 0.);
    for (std::size_t p = 0; p < largest.size(); ++p)
      largest_stresses_[p] = std::max(largest_stresses_[p], largest[p]);
  }

  LumpedResponse SpeedResponse::response(const double energy_error) const
  {
    const Statistics error(slow_errors_), force(slow_forces_);
    LumpedResponse   response;
    response.mean_error    = error.mean;
    response.rms_error     = error.rms;
    response.pp_error      = error.largest - error.least;
    response.mean_force    = force.mean;
    response.rms_force     = force.rms;
    response.pp_force      = force.largest - force.least;
    response.largest_force = force.largest;
    unsigned int n_apart   = 0;
    for (std::size_t i = 0; i < forces_.size(); ++i)
      if (!(forces_[i] > 0))
        {
          ++n_apart;
          response.losses += i > 0 && forces_[i - 1] > 0 ? 1 : 0;
        }
    response.time_apart   = double(n_apart) / forces_.size();
    response.time_coast   = double(n_coast_) / forces_.size();
    response.energy_error = energy_error;
    return response;
  }

  std::pair<double, double> SpeedResponse::wave(const unsigned int n) const
  {
    const std::vector<Complex> &wave = waves_[n - 1];
    const Complex mean = std::accumulate(wave.begin(), wave.end(), Complex()) / double(wave.size());
    double        largest = 0;
    for (const Complex &now : wave)
      largest = std::max(largest, std::abs(now - mean));
    return {std::abs(mean), largest};
  }

  double SpeedResponse::largest_stress(const std::size_t place) const
  {
    return largest_stresses_[place];
  }
} // namespace vfife
