// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/loads/contact/contact_of_pair.h>
#include <vfife/dynamics/loads/contact/contact_report.h>
#include <vfife/dynamics/loads/contact/contact_system.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** Where a body is after @p duration, to the second order of the angle. */
    RigidMotion move_on(const RigidMotion &motion, const RigidVelocity &rate, const double duration)
    {
      const double omega = rate.omega.norm();
      if (!(omega > 0.))
        return {motion.rotation, motion.translation + duration * rate.velocity};
      const Matrix3 turn = rotation_about(rate.omega / omega, omega * duration);
      return {turn * motion.rotation, turn * motion.translation + duration * rate.velocity};
    }

    ContactPairs make_pairs(const Model &model, const Partition &partition, const double safety)
    {
      ContactPairs pairs;
      for (const ContactPair &pair : model.contacts)
        pairs.push_back(std::make_unique<ContactOfPair>(pair, model, partition, safety));
      return pairs;
    }
  } // namespace

  ContactSystem::ContactSystem(const Model        &model,
                               const Partition    &partition,
                               const Communicator &communicator,
                               const double        safety)
    : model_(model)
    , partition_(partition)
    , communicator_(communicator)
    , pairs_(make_pairs(model, partition, safety))
    , ranks_(model, pairs_, communicator)
    , implicit_(model, pairs_, ranks_)
  {
    for (const auto &pair : pairs_)
      {
        const ContactOptions &options = pair->definition.options;
        needs_velocities_ =
          needs_velocities_ || options.gap_damping_ratio() > 0. || options.friction.acts();
        is_implicit_ = is_implicit_ || pair->is_implicit();
      }
  }

  ContactSystem::~ContactSystem() = default;

  double ContactSystem::vote_on_step(const double element_step) const
  {
    // A surface node is in one pair at a time: the pairs' springs do not add up.
    double dt = element_step;
    for (const auto &pair : pairs_)
      dt = std::min(dt, pair->vote_on_step(element_step));
    return dt;
  }

  void ContactSystem::set_step(const double dt)
  {
    for (const auto &pair : pairs_)
      pair->contact.limit_tangential_penalty(pair->tangential_limit(dt));
  }

  std::vector<double> ContactSystem::penalties() const
  {
    std::vector<double> values;
    for (const auto &pair : pairs_)
      values.push_back(pair->contact.penalty() * pair->definition.mean_stiffness);
    return values;
  }

  void ContactSystem::search(const std::vector<RigidMotion>   &body_motion,
                             const std::vector<RigidVelocity> &rates,
                             const NodeField                  &positions,
                             const double                      duration)
  {
    if (pairs_.empty())
      return;
    const double start = times_ != nullptr ? processor_time() : 0.;
    // 1. Where the bodies' rigid motion is now and will be at the end of the time asked for.
    std::vector<RigidMotion> later;
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      later.push_back(move_on(body_motion[b], rates[b], duration));
    // 2. How far surfaces are from where that motion has them, over all ranks.
    std::vector<double> deformations;
    for (const auto &pair : pairs_)
      for (const ContactSurface *surface : pair->surfaces())
        deformations.push_back(surface->largest_deformation(body_motion[surface->body], positions));
    // Two entries a pair, slave and master, in the order of the pairs.
    communicator_.max(deformations);
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      {
        // 3. Candidates by motion, with what it leaves out as margin: deformation of both surfaces
        // (twice, as it changes).
        ContactOfPair &pair = *pairs_[i];
        pair.contact.find_candidates(body_motion[pair.slave.body],
                                     body_motion[pair.master.body],
                                     later[pair.slave.body],
                                     later[pair.master.body],
                                     2. * (deformations[2 * i] + deformations[2 * i + 1]) +
                                       pair.contact.search_skin());
      }
    if (ranks_.choose(pairs_))
      move_points();
    if (times_ != nullptr)
      times_->broad_search += processor_time() - start;
  }

  void ContactSystem::move_points()
  {
    // Who gets points lists them anew; where they stick is all that goes along.
    for (unsigned int p = 0; p < pairs_.size(); ++p)
      {
        Contact                   &contact = pairs_[p]->contact;
        std::vector<AnchorOfPoint> anchors;
        if (pairs_[p]->definition.options.friction.acts())
          anchors = gather_anchors(contact);
        contact.set_shares(ranks_.shares(p));
        contact.restore_anchors(anchors);
      }
  }

  std::vector<AnchorOfPoint> ContactSystem::gather_anchors(const Contact &contact) const
  {
    // Of a run that has just gone on each rank has those of all.
    const std::vector<AnchorOfPoint> anchors = contact.anchors();
    return communicator_.any(contact.has_restored_anchors()) ? anchors
                                                             : communicator_.all_gather(anchors);
  }

  void ContactSystem::serialize(ByteStream &stream)
  {
    for (const auto &pair : pairs_)
      pair->contact.serialize(stream);
    ranks_.serialize(pairs_, stream);
  }

  void ContactSystem::serialize_friction(ByteStream &stream)
  {
    for (const auto &pair : pairs_)
      {
        Contact                   &contact = pair->contact;
        std::vector<AnchorOfPoint> anchors;
        if (!stream.reads())
          anchors = gather_anchors(contact);
        stream.pass_records(anchors);
        for (const AnchorOfPoint &anchor : anchors)
          stream.require(contact.has_place(anchor), "a place of friction does not exist");
        if (stream.reads())
          contact.restore_anchors(anchors);
      }
  }

  void ContactSystem::set_friction_mode(const FrictionMode mode)
  {
    for (const auto &pair : pairs_)
      pair->contact.set_friction_mode(mode);
  }

  void ContactSystem::set_masses(const std::vector<double> &masses)
  {
    if (is_implicit_)
      implicit_.set_masses(masses, partition_, communicator_);
  }

  void ContactSystem::bring_motion(const NodeField &positions,
                                   const NodeField &velocities,
                                   const NodeField *forces,
                                   const double     dt)
  {
    // The owners' nodes; what others own comes from them.
    ContactMessages &messages        = ranks_.messages();
    const bool       with_velocities = needs_velocities_ || forces != nullptr;
    for (const auto &[surface, i] : messages.own_nodes())
      {
        const std::uint32_t node = surface->local[i];
        const auto          at   = [i = i](std::vector<double> &array) {
          return Eigen::Map<Vector3>(array.data() + 3 * static_cast<std::size_t>(i));
        };
        at(surface->positions) = positions.value(node);
        if (with_velocities)
          at(surface->velocities) = velocities.value(node);
      }
    std::vector<std::vector<double> ContactSurface::*> arrays = {&ContactSurface::positions};
    if (with_velocities)
      arrays.push_back(&ContactSurface::velocities);
    if (forces != nullptr)
      {
        implicit_.find_free_velocities(messages.own_nodes(), velocities, *forces, dt);
        arrays.push_back(&ContactSurface::free_velocities);
      }
    messages.bring(arrays);
  }

  void ContactSystem::evaluate(const std::function<void()> &work)
  {
    // Those that share points fail alike. Others wait for this rank's forces, which it sends though
    // there be none, and hear of it with the next sums of all.
    failure_.clear();
    touched_.clear();
    try
      {
        work();
      }
    catch (const NumericalError &error)
      {
        if (communicator_.size() == 1)
          throw;
        failure_ = error.what();
      }
    for (const ContactNode &node : touched_)
      node.surface->touched[node.number] = 0;
  }

  void ContactSystem::rethrow_failure() const
  {
    if (!sums_.fails())
      return;
    for (const std::string &text : communicator_.all_gather(failure_))
      if (!text.empty())
        throw NumericalError(text);
  }

  void ContactSystem::add_forces(const std::vector<RigidMotion> &body_motion,
                                 const NodeField                &positions,
                                 const NodeField                &velocities,
                                 const double                    dt,
                                 NodeField                      &forces)
  {
    if (pairs_.empty())
      return;
    press_explicitly(body_motion, positions, velocities, dt, forces);
    sums_.set(pairs_, !failure_.empty());
    sums_.sum(communicator_);
    rethrow_failure();
  }

  void ContactSystem::add_step_forces(const std::vector<RigidMotion> &body_motion,
                                      const NodeField                &positions,
                                      const NodeField                &velocities,
                                      const double                    dt,
                                      NodeField                      &forces)
  {
    if (pairs_.empty())
      return;
    if (is_implicit_)
      press_implicitly(body_motion, positions, velocities, dt, forces);
    else
      press_explicitly(body_motion, positions, velocities, dt, forces);
    sums_.set(pairs_, !failure_.empty());
    sums_.set_teeth(model_, pairs_);
  }

  void ContactSystem::press_explicitly(const std::vector<RigidMotion> &body_motion,
                                       const NodeField                &positions,
                                       const NodeField                &velocities,
                                       const double                    dt,
                                       NodeField                      &forces)
  {
    bring_motion(positions, velocities, nullptr, dt);
    evaluate([&] {
      for (const auto &pair : pairs_)
        {
          const ContactSurface      &s = pair->slave, &m = pair->master;
          std::vector<TouchingPoint> points =
            pair->contact.locate({s.positions.data(), s.velocities.data(), body_motion[s.body]},
                                 {m.positions.data(), m.velocities.data(), body_motion[m.body]},
                                 dt,
                                 0.);
          pair->contact.find_explicit_pressures(dt, points);
          press(*pair, points, dt);
        }
    });
    hand_over_forces(forces);
  }

  void ContactSystem::press_implicitly(const std::vector<RigidMotion> &body_motion,
                                       const NodeField                &positions,
                                       const NodeField                &velocities,
                                       const double                    dt,
                                       NodeField                      &forces)
  {
    // 1. The active nodes' motion: where they are and how they would go on without contact.
    bring_motion(positions, velocities, &forces, dt);
    evaluate([&] {
      // 2. This rank's points that touch, their pressures, and what these do.
      std::vector<std::vector<TouchingPoint>> points;
      for (const auto &pair : pairs_)
        {
          const auto motion_of = [&body_motion](const ContactSurface &surface) {
            return SurfaceMotion{surface.positions.data(),
                                 surface.velocities.data(),
                                 body_motion[surface.body],
                                 surface.free_velocities.data()};
          };
          points.push_back(pair->contact.locate(motion_of(pair->slave),
                                                motion_of(pair->master),
                                                dt,
                                                pair->is_implicit() ? .5 * dt : 0.));
          if (!pair->is_implicit())
            pair->contact.find_explicit_pressures(dt, points.back());
        }
      implicit_.solve(dt, points);
      for (std::size_t i = 0; i < pairs_.size(); ++i)
        press(*pairs_[i], points[i], dt);
    });
    // 3. To all that hold the nodes.
    hand_over_forces(forces);
  }

  void ContactSystem::press(ContactOfPair                    &pair,
                            const std::vector<TouchingPoint> &points,
                            const double                      dt)
  {
    pair.contact.press(points, dt, pair.slave.forces.data(), pair.master.forces.data());
    for (const TouchingPoint &point : points)
      for (unsigned int k = 0; k < 8; ++k)
        {
          // The slave of the second of two passes is the contact's master.
          const unsigned int i       = k < 4 ? point.slave_nodes[k] : point.master_nodes[k - 4];
          ContactSurface    &surface = (k < 4) == (point.pass == 0) ? pair.slave : pair.master;
          if (surface.touched[i] != 0)
            continue;
          surface.touched[i] = 1;
          touched_.push_back({&surface, i});
        }
  }

  void ContactSystem::hand_over_forces(NodeField &forces)
  {
    // To all copies of the nodes. The arrays of the surfaces are zero again for the next time.
    for (const auto &[surface, i] : ranks_.messages().add_up_forces(touched_))
      {
        Eigen::Map<Vector3> f(surface->forces.data() + 3 * static_cast<std::size_t>(i));
        if (surface->local[i] != Partition::absent && !(f[0] == 0. && f[1] == 0. && f[2] == 0.))
          forces.add(surface->local[i], f);
        f.setZero();
      }
  }

  void ContactSystem::append_sums(std::vector<double *> &numbers)
  {
    sums_.append(numbers);
  }

  void ContactSystem::save_forces(const NodeField &forces)
  {
    saved_nodes_.clear();
    saved_forces_.clear();
    for (const auto &pair : pairs_)
      for (const ContactSurface *surface : pair->surfaces())
        for (const unsigned int i : *surface->active)
          if (surface->local[i] != Partition::absent)
            {
              saved_nodes_.push_back(surface->local[i]);
              saved_forces_.push_back(forces.value(surface->local[i]));
            }
  }

  void ContactSystem::find_added(const NodeField &forces, NodeField &added)
  {
    for (const std::uint32_t node : shown_nodes_)
      added.set(node, Vector3::Zero());
    for (std::size_t k = 0; k < saved_nodes_.size(); ++k)
      added.set(saved_nodes_[k], forces.value(saved_nodes_[k]) - saved_forces_[k]);
    shown_nodes_ = saved_nodes_;
  }

  std::vector<ToothContact> ContactSystem::collect_results() const
  {
    return collect_pressed_teeth(model_, pairs_, communicator_);
  }

  std::string ContactSystem::describe_deepest_point() const
  {
    return vfife::describe_deepest_point(model_, pairs_, communicator_);
  }

  std::vector<std::string> ContactSystem::describe_coarse_slaves() const
  {
    return vfife::describe_coarse_slaves(model_, pairs_);
  }

  std::vector<std::string> ContactSystem::describe_rattling(const double dt) const
  {
    return vfife::describe_rattling(pairs_, dt);
  }

  void ContactSystem::measure_times(ContactTimes *times)
  {
    times_ = times;
    for (const auto &pair : pairs_)
      pair->contact.measure_times(times);
  }

  std::size_t ContactSystem::n_listed_points() const
  {
    std::size_t n = 0;
    for (const auto &pair : pairs_)
      n += pair->contact.n_listed_points();
    return n;
  }

  void ContactSystem::add_relaxation_masses(const double         fraction,
                                            std::vector<double> &masses) const
  {
    for (const auto &pair : pairs_)
      {
        // A node on a spring k = eps C gets k/(2 phi^2) more mass, phi the fraction, C the area of
        // points that it may carry, whether it touches or not: masses stay as they are when contact
        // opens and closes.
        const auto carried = pair->contact.node_springs().carried_areas();
        for (const ContactSurface *surface : pair->surfaces())
          {
            const std::vector<double> &areas = carried[surface == &pair->slave ? 0 : 1];
            for (std::size_t i = 0; i < surface->local.size(); ++i)
              if (surface->local[i] != Partition::absent)
                masses[surface->local[i]] +=
                  pair->penalty().relaxation_mass(pair->contact.penalty() * areas[i], fraction);
          }
      }
  }
} // namespace vfife
