// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// One body of a ReducedPair.
#include "reduced_pair_parts.h"

#include <vfife/model/body_frame.h>

#include <cmath>

namespace vfife
{
  using Eigen::MatrixXcd;
  using Eigen::VectorXcd;

  namespace
  {
    /** Part of a changing speed after which the modes follow it: what spin and Coriolis forces add
     * to their eigenvalues is 1e-3 of them, and changes by twice that part. */
    constexpr double rate_part = .01;
    /** The same for their part of the flexibility, of which a step's Coriolis forces, 1e-3 of the
     * rest, are all that knows the speed. */
    constexpr double gain_part = .1;

    /** Sense of the axis of rotation about that of the sectors. */
    double find_sector_sense(const Body &body)
    {
      return body.axis.direction.dot(compute_sector_axis(body).direction) < 0 ? -1. : 1.;
    }

    std::vector<MatrixXcd> gains_of(const ModalMotion &motion, const std::size_t n)
    {
      std::vector<MatrixXcd> gains;
      for (std::size_t i = 0; i < n; ++i)
        gains.push_back(motion.gain(i));
      return gains;
    }

    bool is_near(const double rate, const double other, const double part)
    {
      return std::abs(rate - other) <= part * std::abs(other);
    }
  } // namespace

  double torque_on(const Model &model, const unsigned int body, const double time)
  {
    double sum = 0;
    for (const Torque &torque : model.torques)
      if (torque.body == body)
        sum += torque.value * torque.history.value(time);
    return sum;
  }

  ReducedPair::Member::Member(const Model              &model,
                              const unsigned int        b,
                              ReducedBody             &&reduced,
                              const ReducedPairOptions &options)
    : body(std::move(reduced))
    , rate(model.bodies[b].rate)
    , sense(find_sector_sense(model.bodies[b]))
    , axial{torque_on(model, b, 0.), 0.}
    , inertia(body.turns ? body.turn_inertia : model.bodies[b].axial_inertia())
    , motion(body, rate, {options.damping, options.mesh_damping}, options.step)
    , rows(body, gains_of(motion, body.harmonics.size()))
  {
    set_rate(rate);
    gain_rate = rate;
  }

  void ReducedPair::Member::set_rate(const double new_rate)
  {
    rate        = new_rate;
    sector_rate = sense * rate;
    spin        = body.rate != 0 ? rate * rate / (body.rate * body.rate) : 0.;
  }

  void ReducedPair::Member::set_gains()
  {
    rows.set_gains(gains_of(motion, body.harmonics.size()));
    gain_rate = motion.rate();
  }

  void ReducedPair::Member::follow_rate(const double step)
  {
    if (!is_near(rate, motion.rate(), rate_part))
      motion.change(rate, step);
    if (!is_near(rate, gain_rate, gain_part))
      set_gains();
  }

  ModalForces ReducedPair::Member::forces_of(const AxialLoad &load) const
  {
    ModalForces forces;
    for (const ReducedBody::Harmonic &harmonic : body.harmonics)
      forces.modes.push_back(harmonic.forces_of(load));
    // The turn is counted from what the body turns with.
    forces.moment = load.torque - inertia * load.acceleration;
    return forces;
  }

  std::vector<VectorXcd> ReducedPair::Member::coordinates() const
  {
    std::vector<VectorXcd> coordinates;
    for (std::size_t i = 0; i < body.harmonics.size(); ++i)
      coordinates.push_back(motion.coordinates(i));
    return coordinates;
  }

  std::vector<MatrixXcd> ReducedPair::Member::standing_gains() const
  {
    std::vector<MatrixXcd> gains;
    for (std::size_t i = 0; i < body.harmonics.size(); ++i)
      gains.push_back(motion.standing_flexibility(i, sector_rate));
    return gains;
  }
} // namespace vfife
