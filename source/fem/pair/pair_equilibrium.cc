// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "pair_equilibrium_parts.h"

#include <vfife/base/errors.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

// Displacements, forces and springs are in the axes of time zero, with three entries for each
// watched point in the order of Compliance::watched(). Positions and all that the contact module
// sees are in the fixed frame, the bodies turned by rotations_.
namespace vfife
{
  namespace
  {
    /** Of the secant towards the first touch. */
    constexpr unsigned int largest_steps = 60;
    /** Gap at the first touch [mm]: 1e-5 arcsec at 100 mm. */
    constexpr double touch_tolerance = 5e-9;
  } // namespace

  PairEquilibrium::PairEquilibrium(const Model               &model,
                                   Compliance                &compliance,
                                   const std::vector<double> &penalties,
                                   const std::vector<double> &driver_turns)
    : model_(model)
    , compliance_(compliance)
    , rotations_(model.bodies.size(), Matrix3::Identity())
  {
    if (!model.transmission || model.contacts.empty())
      throw InputError("the equilibrium of a loaded pair needs a gear pair with contact");
    const Discretization &d = compliance.discretization();
    for (std::size_t i = 0; i < model.contacts.size(); ++i)
      pairs_.push_back(std::make_unique<Pair>(model.contacts[i], model, d, penalties[i]));

    // The nodes that may touch at any position asked for: only at them displacements by unit
    // forces are kept.
    std::set<unsigned int> points;
    for (const double turn : driver_turns)
      {
        set_position(turn);
        find_candidates();
        for (const auto &pair : pairs_)
          for (const Surface *surface : {&pair->slave, &pair->master})
            for (const unsigned int i : pair->active(*surface))
              points.insert(surface->first_point + surface->facets.nodes[i]);
      }
    compliance_.watch({points.begin(), points.end()});
    const std::vector<unsigned int> &watched = compliance_.watched();
    for (const auto &pair : pairs_)
      for (Surface *surface : {&pair->slave, &pair->master})
        for (std::size_t i = 0; i < surface->place.size(); ++i)
          {
            const unsigned int point = surface->first_point + surface->facets.nodes[i];
            const auto         found = std::lower_bound(watched.begin(), watched.end(), point);
            if (found != watched.end() && *found == point)
              surface->place[i] = found - watched.begin();
          }
  }

  PairEquilibrium::~PairEquilibrium() = default;

  void PairEquilibrium::set_position(const double driver_turn)
  {
    const Transmission &t = *model_.transmission;
    driver_turn_          = driver_turn;
    rotations_[t.driver] =
      rotation_about(model_.bodies[t.driver].axis.direction, t.driver_sense * driver_turn);
    set_turn(0.);
  }

  void PairEquilibrium::set_turn(const double turn)
  {
    const Transmission &t = *model_.transmission;
    rotations_[t.driven]  = rotation_about(model_.bodies[t.driven].axis.direction,
                                          t.driven_sense * t.ratio() * driver_turn_ + turn);
  }

  Vector3 PairEquilibrium::place(const unsigned int body, const Vector3 &x) const
  {
    const Vector3 &c = model_.bodies[body].axis.point;
    return c + rotations_[body] * (x - c);
  }

  RigidMotion PairEquilibrium::body_motion(const unsigned int body) const
  {
    const Body &b = model_.bodies[body];
    return {rotations_[body] * b.placement.rotation, place(body, b.placement.translation)};
  }

  void PairEquilibrium::find_candidates()
  {
    for (const auto &pair : pairs_)
      pair->contact.find_candidates(body_motion(pair->slave.body),
                                    body_motion(pair->master.body),
                                    pair->margin());
  }

  double PairEquilibrium::load(const double load_factor) const
  {
    double sum = 0;
    for (const Torque &torque : model_.torques)
      if (torque.body == model_.transmission->driven)
        sum += load_factor * torque.value;
    return sum;
  }

  Eigen::VectorXd PairEquilibrium::at_watched(const std::vector<double> &u) const
  {
    const std::vector<unsigned int> &watched = compliance_.watched();
    Eigen::VectorXd                  values(3 * watched.size());
    for (std::size_t k = 0; k < watched.size(); ++k)
      values.segment<3>(3 * k) = Eigen::Map<const Vector3>(u.data() + 3 * watched[k]);
    return values;
  }

  std::vector<double> PairEquilibrium::spread(const Eigen::VectorXd &force) const
  {
    const std::vector<unsigned int> &watched = compliance_.watched();
    std::vector<double>              all(compliance_.spun().size(), 0.);
    for (std::size_t k = 0; k < watched.size(); ++k)
      Eigen::Map<Vector3>(all.data() + 3 * watched[k]) = force.segment<3>(3 * k);
    return all;
  }

  Eigen::VectorXd PairEquilibrium::apply_compliance(const Eigen::VectorXd &force)
  {
    // Forces are zero but at the few nodes under pressure: only their columns of A are asked for.
    std::vector<unsigned int> rows;
    for (unsigned int k = 0; k < force.size(); ++k)
      if (force[k] != 0.)
        rows.push_back(k);
    compliance_.prepare(rows);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(force.size());
    for (const unsigned int k : rows)
      u += force[k] * compliance_.column(k);
    return u;
  }

  void PairEquilibrium::move(Pair &pair, const Eigen::VectorXd &u)
  {
    const Discretization &d = compliance_.discretization();
    for (Surface *surface : {&pair.slave, &pair.master})
      for (const unsigned int i : pair.active(*surface))
        {
          const Vector3 &X = d.points()[surface->first_point + surface->facets.nodes[i]];
          Eigen::Map<Vector3>(surface->positions.data() + 3 * i) =
            place(surface->body, X + u.segment<3>(3 * surface->place[i]));
          std::fill_n(surface->forces.data() + 3 * i, 3, 0.);
        }
  }

  PairEquilibrium::Trial PairEquilibrium::evaluate(const Eigen::VectorXd &u, const double turn)
  {
    set_turn(turn);
    const unsigned int driven = model_.transmission->driven;
    const Axis        &axis   = model_.bodies[driven].axis;
    Trial              trial;
    trial.force = Eigen::VectorXd::Zero(u.size());
    for (const auto &pair : pairs_)
      {
        // x = c + R (X + u - c) of both flanks; the contact module works in the fixed frame,
        // and its forces are turned back into the axes of time zero. At rest: velocities and
        // time step are zero.
        move(*pair, u);
        Surface &s = pair->slave, &m = pair->master;
        pair->contact.add_forces({s.positions.data(), s.velocities.data(), body_motion(s.body)},
                                 {m.positions.data(), m.velocities.data(), body_motion(m.body)},
                                 0.,
                                 0,
                                 1,
                                 s.forces.data(),
                                 m.forces.data());
        for (const GroupPairResult &result : pair->contact.results())
          trial.energy += result.energy;
        for (const Surface *surface : {&s, &m})
          for (const unsigned int i : pair->active(*surface))
            {
              const Vector3 f = Eigen::Map<const Vector3>(surface->forces.data() + 3 * i);
              trial.force.segment<3>(3 * surface->place[i]) +=
                rotations_[surface->body].transpose() * f;
              if (surface->body == driven)
                trial.torque += axis.direction.dot(
                  (Eigen::Map<const Vector3>(surface->positions.data() + 3 * i) - axis.point)
                    .cross(f));
            }
      }
    return trial;
  }

  double PairEquilibrium::find_touch(const Eigen::VectorXd &base)
  {
    // The load turns the driven body towards the driver: a turn d closes the gap by arm d, nearly,
    // whatever the flanks are. Steps with this slope end at the touch.
    const double sense = load(1.) < 0 ? -1. : 1.;
    Pair        &pair  = *pairs_.front();
    double       turn  = 0;
    for (unsigned int i = 0; i < largest_steps; ++i)
      {
        set_turn(turn);
        move(pair, base);
        const Surface &s = pair.slave, &m = pair.master;
        const double   gap =
          pair.contact
            .smallest_gap({s.positions.data(), s.velocities.data(), body_motion(s.body)},
                          {m.positions.data(), m.velocities.data(), body_motion(m.body)},
                          pair.contact.depth_limit())
            .gap;
        // Nothing of one flank is within reach of the other any more.
        if (!std::isfinite(gap))
          break;
        if (std::abs(gap) < touch_tolerance)
          return turn;
        turn += sense * gap / model_.transmission->arm;
      }
    fail("the flanks do not touch within reach", "");
  }

  double PairEquilibrium::find_touch(const double driver_turn)
  {
    set_position(driver_turn);
    find_candidates();
    return find_touch(at_watched(compliance_.spun()));
  }

  PairEquilibrium::Iterate PairEquilibrium::press_rigid(const Eigen::VectorXd &base,
                                                        const double           load)
  {
    // A first guess with some points under pressure: as deep as rigid bodies would need it.
    Iterate guess;
    guess.force = guess.deflection = Eigen::VectorXd::Zero(base.size());
    const double sense             = load < 0 ? -1. : 1.;
    const double touch             = find_touch(base);
    double       depth             = 1e-5; // [mm]
    for (; depth < pairs_.front()->contact.depth_limit(); depth *= 2.)
      {
        // Twice as deep each time, until the contact has at least the torque: Newton's method comes
        // back from there, where all points that will carry are pressed.
        guess.turn  = touch + sense * depth / model_.transmission->arm;
        guess.trial = evaluate(base, guess.turn);
        if (-sense * guess.trial.torque >= std::abs(load))
          return guess;
      }
    fail("the undeformed flanks cannot carry the torque", "");
  }

  void PairEquilibrium::fail(const std::string &what, const std::string &history) const
  {
    std::ostringstream text;
    text << "equilibrium of the pair at the position " << driver_turn_ * 180. / pi
         << " deg of the driver: " << what;
    if (!history.empty())
      text << "; residuals:" << history;
    throw NumericalError(text.str());
  }
} // namespace vfife
