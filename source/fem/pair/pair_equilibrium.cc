// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "pair_equilibrium_parts.h"

#include <vfife/base/errors.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

// Displacements, forces and springs are in the axes of time zero, with three entries for each
// watched point in the order of Compliance::watched(), and six behind them for the ring of each
// bearing. Positions and all that the contact module
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
    const unsigned int driven = model.transmission->driven;
    if (!compliance.turns_freely(driven))
      throw InputError("body \"" + model.bodies[driven].name() +
                       "\" is driven and carries a torque, but something holds its turn about its "
                       "axis");
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
    bearings_ =
      std::make_unique<BearingSprings>(model, compliance.rings(), model.transmission->arm);
    std::vector<PointMotion> motions = bearings_->motions();
    Eigen::Index             n_known = 0;
    for (const StandingMotion &standing : compliance.standing_motions())
      {
        motions.push_back(standing);
        n_known += standing.stiffness.rows();
      }
    known_rows_ = Eigen::VectorXd::Zero(n_known);
    compliance_.watch({points.begin(), points.end()}, std::move(motions));
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

  std::size_t PairEquilibrium::bearing_row(const std::size_t i) const
  {
    return 3 * compliance_.watched().size() + 6 * i;
  }

  Eigen::VectorXd PairEquilibrium::bearing_rows(const Eigen::VectorXd &u) const
  {
    return u.segment(bearing_row(0), 6 * bearings_->size());
  }

  Eigen::VectorXd PairEquilibrium::apply_compliance(const Eigen::VectorXd &force)
  {
    // Forces are zero but at the few nodes under pressure and bearings: only their columns of A are
    // asked for.
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

  PairEquilibrium::Trial
  PairEquilibrium::evaluate(const Eigen::VectorXd &u, const double turn, const bool touching)
  {
    set_turn(turn);
    Trial trial;
    trial.force = Eigen::VectorXd::Zero(u.size());
    if (touching)
      add_contact(u, trial);
    trial.contact_force = trial.force.norm();
    trial.energy        = trial.contact_energy;
    trial.torque        = trial.contact_torque;
    add_bearings(u, trial);
    return trial;
  }

  void PairEquilibrium::add_bearings(const Eigen::VectorXd &u, Trial &trial) const
  {
    if (bearings_->size() > 0)
      {
        const auto response = bearings_->evaluate(bearing_rows(u), rotations_);
        trial.force.segment(bearing_row(0), response.force.size()) += response.force;
        trial.energy += response.energy;
        trial.torque += response.torque;
      }
    std::size_t row = bearing_row(bearings_->size()), i = 0;
    for (const StandingMotion &standing : compliance_.standing_motions())
      {
        const Eigen::Index    size  = standing.stiffness.rows();
        const Eigen::VectorXd since = u.segment(row, size) - known_rows_.segment(i, size);
        const Eigen::VectorXd force = -standing.stiffness * since;
        trial.force.segment(row, size) += force;
        trial.energy -= .5 * since.dot(force);
        row += size;
        i += size;
      }
  }

  void PairEquilibrium::add_contact(const Eigen::VectorXd &u, Trial &trial)
  {
    const unsigned int driven = model_.transmission->driven;
    const Axis        &axis   = model_.bodies[driven].axis;
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
          trial.contact_energy += result.energy;
        for (const Surface *surface : {&s, &m})
          for (const unsigned int i : pair->active(*surface))
            {
              const Vector3 f = Eigen::Map<const Vector3>(surface->forces.data() + 3 * i);
              trial.force.segment<3>(3 * surface->place[i]) +=
                rotations_[surface->body].transpose() * f;
              if (surface->body == driven)
                trial.contact_torque += axis.direction.dot(
                  (Eigen::Map<const Vector3>(surface->positions.data() + 3 * i) - axis.point)
                    .cross(f));
            }
      }
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

  PairEquilibrium::Iterate PairEquilibrium::find_unloaded(const Eigen::VectorXd &base)
  {
    // Bearings that are not alike all around take the body elsewhere when it has turned to the
    // touch, by far less than the way there.
    double turn = 0;
    for (unsigned int i = 0; i < largest_steps; ++i)
      {
        Iterate      now   = settle(base, turn);
        const double touch = find_touch(base + now.deflection);
        const bool   found = std::abs(touch - turn) * model_.transmission->arm <= touch_tolerance;
        now.turn = turn = touch;
        if (found || bearings_->size() == 0)
          return now;
      }
    fail("the unloaded bearings find no equilibrium", "");
  }

  PairEquilibrium::Iterate
  PairEquilibrium::press_rigid(const Eigen::VectorXd &base, const double load, Iterate guess)
  {
    // A first guess with some points under pressure: as deep as rigid bodies would need it where
    // the unloaded bearings have them.
    guess.touching              = true;
    const Eigen::VectorXd u     = base + guess.deflection;
    const double          sense = load < 0 ? -1. : 1.;
    const double          touch = find_touch(u);
    double                depth = 1e-5; // [mm]
    for (; depth < pairs_.front()->contact.depth_limit(); depth *= 2.)
      {
        // Twice as deep each time, until the contact has at least the torque: Newton's method comes
        // back from there, where all points that will carry are pressed.
        guess.turn  = touch + sense * depth / model_.transmission->arm;
        guess.trial = evaluate(u, guess.turn, true);
        if (-sense * guess.trial.contact_torque >= std::abs(load))
          return guess;
      }
    fail("the undeformed flanks cannot carry the torque", "");
  }

  std::string PairEquilibrium::find_excess(const Eigen::VectorXd &u) const
  {
    // Pairs of teeth are looked for where undeformed bodies have them. What bearings move them by
    // is the mean over a flank's nodes.
    if (bearings_->size() == 0)
      return "";
    for (const auto &pair : pairs_)
      {
        Vector3 apart = Vector3::Zero();
        for (const Surface *surface : {&pair->slave, &pair->master})
          {
            Vector3 sum = Vector3::Zero();
            for (const unsigned int i : pair->active(*surface))
              sum += u.segment<3>(3 * surface->place[i]);
            if (!pair->active(*surface).empty())
              apart += (surface == &pair->slave ? 1. : -1.) / pair->active(*surface).size() *
                       (rotations_[surface->body] * sum);
          }
        if (apart.norm() > pair->contact.depth_limit())
          {
            std::ostringstream text;
            text << "bearings let the flanks move by " << apart.norm()
                 << " mm against each other, farther than contact is looked for ("
                 << pair->contact.depth_limit() << " mm, Contact/depth limit); stiffer bearings or "
                 << "a smaller torque";
            return text.str();
          }
      }
    return "";
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
