// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/study/waves/static_passage.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Decay rate times step: what is left of a vibration after one is exp(-...). */
    constexpr double rest = 4.;
  } // namespace

  StaticPassage::StaticPassage(const Model                    &model,
                               const std::vector<ReducedBody> &bodies,
                               const std::vector<double>      &penalties,
                               ReducedPairOptions              options,
                               const unsigned int              n_steps)
    : teeth_(model.transmission->driven_teeth)
  {
    const Transmission &t = *model.transmission;
    for (const auto &harmonic : bodies[t.driven].harmonics)
      numbers_.push_back(harmonic.number);
    options.step = 2. * rest / options.damping;
    ReducedPair pair(model, bodies, penalties, options);
    sense_ = t.driven_sense * pair.sector_sense(t.driven);
    pair.set_speed(2. * pi / (t.driver_teeth * n_steps * options.step), options.step);
    stiffness_ = pair.start().stiffness;
    State  state;
    double least = 0, largest = 0;
    // The first tooth mesh settles.
    for (unsigned int s = 1; s <= 2 * n_steps; ++s)
      {
        pair.step();
        if (s <= n_steps)
          continue;
        forces_.push_back(pair.measure_modal_forces(t.driven));
        turns_.push_back(t.driven_sense * pair.measure_turn(t.driven));
        pair.measure(state);
        const double moment = state.measured.contact_torque;
        least               = s == n_steps + 1 ? moment : std::min(least, moment);
        largest             = std::max(largest, moment);
        moment_ += moment / n_steps;
      }
    ripple_ = (largest - least) / moment_;
  }

  std::complex<double>
  StaticPassage::phase(const std::size_t step, const unsigned int h, const int p) const
  {
    // The steps end with the second tooth mesh.
    const double meshes = 1. + (step + 1.) / forces_.size();
    return std::polar(1., -sense_ * (int(h) + p * int(teeth_)) * 2. * pi * meshes / teeth_);
  }

  Eigen::VectorXcd StaticPassage::force(const std::size_t harmonic, const int p) const
  {
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(forces_.front()[harmonic].size());
    for (std::size_t s = 0; s < forces_.size(); ++s)
      sum += phase(s, numbers_[harmonic], p) * forces_[s][harmonic];
    return sum / double(forces_.size());
  }

  std::complex<double> StaticPassage::turn(const int p) const
  {
    std::complex<double> sum = 0;
    for (std::size_t s = 0; s < turns_.size(); ++s)
      sum += phase(s, 0, p) * turns_[s];
    return sum / double(turns_.size());
  }
} // namespace vfife
