// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/byte_stream.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/model/pair_measures.h>
#include <vfife/reduced/body_rings.h>
#include <vfife/reduced/pair/pair_member.h>

#include <cmath>

namespace vfife
{
  using Eigen::MatrixXcd;
  using Eigen::VectorXcd;
  using Eigen::VectorXd;

  namespace
  {
    /** Part of a changing speed after which the modes follow it: what spin and Coriolis forces add
     * to their eigenvalues is 1e-3 of them, and changes by twice that part. */
    constexpr double rate_part = .01;
    /** The same for their part of the flexibility, of which a step's Coriolis forces, 1e-3 of the
     * rest, are all that knows the speed. */
    constexpr double gain_part = .1;

    /** Body::axis in the axes of the body frame. */
    Vector3 axis_in_frame(const Body &body)
    {
      return body.placement.rotation.transpose() * body.axis.direction;
    }

    std::vector<MatrixXcd> gains_of(const ModalMotion &motion, const std::size_t n)
    {
      std::vector<MatrixXcd> gains;
      for (std::size_t i = 0; i < n; ++i)
        gains.push_back(motion.gain(i));
      return gains;
    }

    /**
     * Damping of what hangs in bearings, beside that of all modes alike. Its rigid motions are
     * damped relative to the ground, as in runs: with rho their velocities, J the inertia and a x
     * the product with the axis, zeta rho^H J (a x) rho c for each rate of the turn, of complex
     * coordinates half of it. Dampers of couplings act on their seats' twist.
     */
    ModalDamping make_damping(const Model       &model,
                              const unsigned int b,
                              const ReducedBody &body,
                              ModalDamping       damping)
    {
      if (body.rings.size() == 0)
        return damping;
      const Vector3               axis  = axis_in_frame(model.bodies[b]);
      const Eigen::Index          whole = 6 * body.rings.find(ring::whole);
      Eigen::Matrix<double, 6, 6> turns = Eigen::Matrix<double, 6, 6>::Zero();
      for (unsigned int c = 0; c < 3; ++c)
        {
          turns.block<3, 1>(0, c)     = axis.cross(Vector3::Unit(c));
          turns.block<3, 1>(3, 3 + c) = axis.cross(Vector3::Unit(c));
        }
      for (const ReducedBody::Harmonic &harmonic : body.harmonics)
        {
          if (harmonic.number > 1)
            break;
          const MatrixXcd rho = harmonic.rings.middleRows<6>(whole);
          damping.circulation.push_back((harmonic.number == 0 ? 1. : .5) * damping.modes *
                                        rho.adjoint() * (body.rings.inertia * turns) * rho);
          MatrixXcd &D = damping.more.emplace_back(MatrixXcd::Zero(rho.cols(), rho.cols()));
          if (harmonic.number == 0)
            for (const Coupling &coupling : model.couplings)
              if (coupling.body == b)
                {
                  const Eigen::Index seat = body.rings.find(ring::of_coupling(coupling.name));
                  const Eigen::RowVectorXcd twist =
                    axis.transpose() * harmonic.rings.middleRows<3>(6 * seat + 3);
                  D += coupling.damping * twist.adjoint() * twist;
                }
        }
      return damping;
    }

    bool is_near(const double rate, const double other, const double part)
    {
      return std::abs(rate - other) <= part * std::abs(other);
    }
  } // namespace

  PairMember::PairMember(const Model        &model,
                         const unsigned int  b,
                         ReducedBody       &&reduced,
                         const ModalDamping &damping,
                         const double        step)
    : body(std::move(reduced))
    , rate(model.bodies[b].rate)
    , sense(compute_sector_sense(model.bodies[b]))
    , axial{torque_on(model, b, 0.), 0.}
    , inertia(body.turns ? body.turn_inertia : model.bodies[b].axial_inertia())
    , motion(body, rate, make_damping(model, b, body, damping), step)
    , rows(body,
           gains_of(motion, body.harmonics.size()),
           {model.bodies[b].placement.rotation, model.only_transmission()->arm})
    , axis_(axis_in_frame(model.bodies[b]))
  {
    set_rate(rate);
    gain_rate = rate;
  }

  void PairMember::set_rate(const double new_rate)
  {
    rate        = new_rate;
    sector_rate = sense * rate;
    spin        = body.rate != 0 ? rate * rate / (body.rate * body.rate) : 0.;
  }

  void PairMember::set_gains()
  {
    rows.set_gains(gains_of(motion, body.harmonics.size()));
    gain_rate = motion.rate();
  }

  void PairMember::follow_rate(const double step)
  {
    if (!is_near(rate, motion.rate(), rate_part))
      motion.change(rate, step);
    if (!is_near(rate, gain_rate, gain_part))
      set_gains();
  }

  ModalForces PairMember::forces_of(const AxialLoad &load) const
  {
    ModalForces forces;
    for (const ReducedBody::Harmonic &harmonic : body.harmonics)
      forces.modes.push_back(harmonic.forces_of(load));
    // The turn is counted from what the body turns with.
    forces.moment = load.torque - inertia * load.acceleration;
    return forces;
  }

  std::vector<VectorXcd> PairMember::coordinates() const
  {
    std::vector<VectorXcd> coordinates;
    for (std::size_t i = 0; i < body.harmonics.size(); ++i)
      coordinates.push_back(motion.coordinates(i));
    return coordinates;
  }

  std::vector<VectorXcd> PairMember::standing_coordinates(const AxialLoad &load) const
  {
    std::vector<VectorXcd> own = forces_of(load).modes;
    for (std::size_t i = 0; i < own.size(); ++i)
      own[i] = motion.standing_flexibility(i, sector_rate) * own[i];
    return own;
  }

  VectorXd PairMember::part_of(const VectorXd &x) const
  {
    VectorXd own(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      own[i] = x[places[i]];
    return own;
  }

  double PairMember::read_turn(const char *const reading, const VectorXd &forces) const
  {
    return motion.turn() + rows.read_all(body.find_reading(reading), coordinates(), forces, axial);
  }

  void PairMember::serialize(const double step, ByteStream &stream)
  {
    double new_rate = rate, of_modes = motion.rate(), of_gains = gain_rate;
    stream.pass(new_rate, of_modes, of_gains, axial.torque, axial.acceleration);
    if (stream.reads())
      {
        set_rate(new_rate);
        motion.change(of_gains, step);
        set_gains();
        motion.change(of_modes, step);
      }
    motion.serialize(stream);
  }

  double PairMember::modal_rate() const
  {
    return in_bearings() ? modal_rate_of(body.rings.find(ring::whole)) : 0.;
  }

  double PairMember::modal_rate_of(const unsigned int ring) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < body.harmonics.size(); ++i)
      if (body.harmonics[i].number == 0)
        sum += axis_.dot(
          (body.harmonics[i].rings.middleRows<3>(6 * ring + 3) * motion.velocities(i)).real());
    return sum;
  }

  std::pair<double, double> PairMember::twist(const Coupling &coupling,
                                              const VectorXd &forces) const
  {
    const unsigned int seat   = body.rings.find(ring::of_coupling(coupling.name));
    const auto         placed = rows.read_ring(seat, spin, coordinates(), forces, axial);
    return {(rows.placement() * axis_).dot(placed.tail<3>()), modal_rate_of(seat)};
  }

  std::vector<MatrixXcd> PairMember::standing_gains() const
  {
    std::vector<MatrixXcd> gains;
    for (std::size_t i = 0; i < body.harmonics.size(); ++i)
      gains.push_back(motion.standing_flexibility(i, sector_rate));
    return gains;
  }
} // namespace vfife
