// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/machine_speed.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/loads/contact/contact_of_pair.h>
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

    ContactRanks::Pairs
    make_pairs(const Model &model, const Partition &partition, const double safety)
    {
      ContactRanks::Pairs pairs;
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
  {
    for (const auto &pair : pairs_)
      {
        const ContactOptions &options = pair->definition.options;
        needs_velocities_ =
          needs_velocities_ || options.gap_damping_ratio() > 0. || options.friction.acts();
        is_implicit_ = is_implicit_ || pair->is_implicit();
      }
    number_nodes();
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

  void ContactSystem::add_forces(const std::vector<RigidMotion> &body_motion,
                                 const NodeField                &positions,
                                 const NodeField                &velocities,
                                 const double                    dt,
                                 NodeField                      &forces)
  {
    if (pairs_.empty())
      return;
    press_explicitly(body_motion, positions, velocities, dt, forces);
    sum_results();
    communicator_.sum(sums_.data(), sums_.size());
    rethrow_failure();
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
