// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/model.h>
#include <vfife/reduced/resonance/static_passage.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Part of the speed with which the mesh cycle passes: nothing spins. */
    constexpr double slow = 1e-3;
  } // namespace

  StaticPassage::StaticPassage(const Model &model, ReducedPair &pair, const unsigned int n_steps)
    : teeth_(model.only_transmission()->driven_teeth)
  {
    const Transmission &t = *model.only_transmission();
    for (const auto &harmonic : pair.body(t.driven).harmonics)
      numbers_.push_back(harmonic.number);
    sense_             = t.driven_sense * pair.sector_sense(t.driven);
    const double speed = slow * t.driver_rate;
    pair.set_speed(speed, 2. * pi / (t.driver_teeth * n_steps * speed));
    stiffness_ = pair.start().stiffness;
    moment_    = std::abs(pair.load());
    for (unsigned int s = 0; s < n_steps; ++s)
      {
        pair.step_standing();
        forces_.push_back(pair.reader().read_modal_forces(t.driven));
        turns_.push_back(t.driven_sense * pair.reader().read_turn(t.driven));
      }
  }

  std::complex<double>
  StaticPassage::phase(const std::size_t step, const unsigned int h, const int p) const
  {
    const double meshes = (step + 1.) / forces_.size();
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
