// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/byte_stream.h>
#include <vfife/base/communicator.h>
#include <vfife/base/errors.h>
#include <vfife/contact/contact.h>
#include <vfife/dynamics/contact_system.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>
#include <vfife/model/tooth_contact.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    const FacetSurface &find_surface(const Body &body, const std::string &name)
    {
      const auto found = body.mesh().surfaces.find(name);
      if (found == body.mesh().surfaces.end())
        {
          std::string list;
          for (const auto &s : body.mesh().surfaces)
            list += (list.empty() ? "" : ", ") + s.first;
          throw InputError("body \"" + body.name() + "\" has no surface \"" + name +
                           "\" (surfaces: " + list + ")");
        }
      return found->second;
    }
  } // namespace

  /** One surface of a pair: its nodes' place in the local arrays, and their motion and forces by
   * surface node. */
  struct ContactSystem::Side
  {
    unsigned int                     body;
    const FacetSurface              *surface;
    std::vector<std::uint32_t>       local; ///< local node of each surface node, or absent
    std::vector<double>              mass;  ///< [t]
    std::vector<double>              positions, velocities, forces;
    const std::vector<unsigned int> *active = nullptr; ///< surface nodes

    Side(const unsigned int body_index,
         const Body        &b,
         const std::string &name,
         const Partition   &partition)
      : body(body_index)
      , surface(&find_surface(b, name))
      , positions(3 * surface->nodes.size())
      , velocities(3 * surface->nodes.size())
      , forces(3 * surface->nodes.size())
    {
      for (const unsigned int node : surface->nodes)
        {
          local.push_back(partition.local_node[b.first_node + node]);
          mass.push_back(b.node_masses()[node]);
        }
    }
  };

  struct ContactSystem::Pair
  {
    const ContactPair &definition;
    Side               slave, master;
    Contact            contact;
    double             mass_per_area;

    Pair(const ContactPair &pair, const Model &model, const Partition &partition)
      : definition(pair)
      , slave(pair.slave_body, model.bodies[pair.slave_body], pair.slave_surface, partition)
      , master(pair.master_body, model.bodies[pair.master_body], pair.master_surface, partition)
      , contact(*slave.surface, *master.surface, pair.options)
      , mass_per_area(contact.mass_per_area(slave.mass, master.mass))
    {
      slave.active  = &contact.active_slave_nodes();
      master.active = &contact.active_master_nodes();
    }

    /** Penetration at which a run is given up [mm]. */
    double penetration_limit() const
    {
      return definition.options.penetration_limit * contact.depth_limit();
    }

    std::array<Side *, 2> sides()
    {
      return {{&slave, &master}};
    }
  };

  ContactSystem::ContactSystem(const Model        &model,
                               const Partition    &partition,
                               const Communicator &communicator)
    : model_(model)
    , partition_(partition)
    , communicator_(communicator)
  {
    for (const ContactPair &pair : model.contacts)
      pairs_.push_back(std::make_unique<Pair>(pair, model, partition));
    for (const Body &body : model.bodies)
      {
        double reach = 0;
        for (const Vector3 &x : body.node_positions())
          reach = std::max(reach, (body.placement(x) - body.axis.point).norm());
        reach_.push_back(reach);
      }
  }

  ContactSystem::~ContactSystem() = default;

  bool ContactSystem::empty() const
  {
    return pairs_.empty();
  }

  double ContactSystem::vote_on_step(const double element_step) const
  {
    // omega^2 of elements and of springs between two nodes add at most: (4/dt^2) = (4/dt_e^2) + 2
    // eps A/m.
    double dt = element_step;
    for (const auto &pair : pairs_)
      {
        const ContactOptions &options = pair->definition.options;
        const double          inverse_square =
          options.penalty_from_step
                     ? 1. / (element_step * element_step * (1. - 0.5 * options.penalty_fraction))
                     : 1. / (element_step * element_step) + 0.5 * options.penalty / pair->mass_per_area;
        dt = std::min(dt, 1. / std::sqrt(inverse_square));
      }
    return dt;
  }

  void ContactSystem::set_penalties(const double dt)
  {
    for (const auto &pair : pairs_)
      pair->contact.set_penalty(pair->definition.options.penalty_for(pair->mass_per_area, dt),
                                pair->mass_per_area);
  }

  std::vector<double> ContactSystem::penalties() const
  {
    std::vector<double> values;
    for (const auto &pair : pairs_)
      values.push_back(pair->contact.penalty());
    return values;
  }

  double ContactSystem::largest_deformation(const std::vector<RigidMotion> &body_motion,
                                            const double                   *positions) const
  {
    double largest = 0;
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const Body &body = model_.bodies[b];
        for (std::uint32_t i = partition_.first_local_node[b];
             i < partition_.first_local_node[b + 1];
             ++i)
          {
            const Vector3 x =
              Eigen::Map<const Vector3>(positions + 4 * static_cast<std::size_t>(i));
            const Vector3 rigid =
              body_motion[b](body.node_positions()[partition_.global_node[i] - body.first_node]);
            largest = std::max(largest, (x - rigid).squaredNorm());
          }
      }
    return std::sqrt(communicator_.max(largest));
  }

  void ContactSystem::search(const std::vector<RigidMotion>   &body_motion,
                             const std::vector<RigidVelocity> &rates,
                             const double                     *positions,
                             const double                      duration)
  {
    if (pairs_.empty())
      return;
    // What the rigid motion of the bodies leaves out: deformation of both, and their way until the
    // next search.
    double margin = 2 * largest_deformation(body_motion, positions);
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      margin += duration * (rates[b].omega.norm() * reach_[b] +
                            rates[b].at(model_.bodies[b].axis.point).norm());
    for (const auto &pair : pairs_)
      {
        pair->contact.find_candidates(body_motion[pair->slave.body],
                                      body_motion[pair->master.body],
                                      margin + pair->contact.search_skin());
      }
  }

  void ContactSystem::exchange(ByteStream &stream)
  {
    for (const auto &pair : pairs_)
      pair->contact.exchange(stream);
  }

  void ContactSystem::gather(const double *positions, const double *velocities)
  {
    std::size_t n = 0;
    for (const auto &pair : pairs_)
      n += pair->slave.active->size() + pair->master.active->size();
    buffer_.assign(6 * n, 0.);

    // The owner of a node writes it, all others add zero: sums are exact copies.
    double *record = buffer_.data();
    for (const auto &pair : pairs_)
      for (const Side *side : pair->sides())
        for (const unsigned int i : *side->active)
          {
            const std::uint32_t local = side->local[i];
            if (local != Partition::absent && partition_.owned[local])
              {
                std::copy_n(positions + 4 * static_cast<std::size_t>(local), 3, record);
                std::copy_n(velocities + 4 * static_cast<std::size_t>(local), 3, record + 3);
              }
            record += 6;
          }
    communicator_.sum(buffer_);

    record = buffer_.data();
    for (const auto &pair : pairs_)
      for (Side *side : pair->sides())
        for (const unsigned int i : *side->active)
          {
            std::copy_n(record, 3, side->positions.data() + 3 * i);
            std::copy_n(record + 3, 3, side->velocities.data() + 3 * i);
            std::fill_n(side->forces.data() + 3 * i, 3, 0.);
            record += 6;
          }
  }

  void ContactSystem::add_forces(const std::vector<RigidMotion> &body_motion,
                                 const double                   *positions,
                                 const double                   *velocities,
                                 const double                    dt,
                                 double                         *forces)
  {
    if (pairs_.empty())
      return;
    gather(positions, velocities);

    std::size_t n = 0;
    energy_ = lost_power_ = largest_penetration_ = 0;
    double too_deep                              = 0;
    for (const auto &pair : pairs_)
      {
        Side &s = pair->slave, &m = pair->master;
        pair->contact.add_forces({s.positions.data(), s.velocities.data(), body_motion[s.body]},
                                 {m.positions.data(), m.velocities.data(), body_motion[m.body]},
                                 dt,
                                 communicator_.rank(),
                                 communicator_.size(),
                                 s.forces.data(),
                                 m.forces.data());
        for (const GroupPairResult &result : pair->contact.results())
          {
            energy_ += result.energy;
            lost_power_ += result.damping_power + result.friction_power;
            largest_penetration_ = std::max(largest_penetration_, result.largest_penetration);
            if (result.largest_penetration > pair->penetration_limit())
              too_deep = 1;
          }
        n += s.active->size() + m.active->size();
      }

    buffer_.resize(3 * n + 3);
    double *record = buffer_.data();
    for (const auto &pair : pairs_)
      for (const Side *side : pair->sides())
        for (const unsigned int i : *side->active)
          {
            std::copy_n(side->forces.data() + 3 * i, 3, record);
            record += 3;
          }
    record[0] = energy_;
    record[1] = lost_power_;
    record[2] = too_deep;
    communicator_.sum(buffer_);

    record = buffer_.data();
    for (const auto &pair : pairs_)
      for (const Side *side : pair->sides())
        for (const unsigned int i : *side->active)
          {
            if (side->local[i] != Partition::absent)
              for (unsigned int c = 0; c < 3; ++c)
                forces[4 * static_cast<std::size_t>(side->local[i]) + c] += record[c];
            record += 3;
          }
    energy_      = record[0];
    lost_power_  = record[1];
    is_too_deep_ = record[2] > 0;
  }

  double ContactSystem::energy() const
  {
    return energy_;
  }

  double ContactSystem::lost_power() const
  {
    return lost_power_;
  }

  double ContactSystem::largest_local_penetration() const
  {
    return largest_penetration_;
  }

  bool ContactSystem::is_too_deep() const
  {
    return is_too_deep_;
  }

  std::string ContactSystem::describe_deepest_point() const
  {
    double             deepest = 0; // over the limit
    std::ostringstream text;
    for (const auto &pair : pairs_)
      for (const ContactPoint &point : pair->contact.points())
        {
          const double ratio = -point.gap / pair->penetration_limit();
          if (!(ratio > deepest))
            continue;
          deepest             = ratio;
          const Side &pressed = point.swapped ? pair->slave : pair->master;
          const Side &from    = point.swapped ? pair->master : pair->slave;
          const auto  place   = [&](const Side &side, const unsigned int facet) {
            return "\"" + model_.bodies[side.body].name() + "\", tooth or group " +
                   std::to_string(side.surface->group[facet]) + ", facet " + std::to_string(facet);
          };
          text.str("");
          text << pair->definition.side << " side: " << place(from, point.slave_facet) << ", is "
               << 1e3 * -point.gap << " um deep in " << place(pressed, point.master_facet)
               << " (limit " << 1e3 * pair->penetration_limit()
               << " um, Contact/penetration limit)";
        }
    const std::vector<double>      all   = communicator_.all_gather(deepest);
    const std::vector<std::string> texts = communicator_.all_gather(text.str());
    return texts[std::max_element(all.begin(), all.end()) - all.begin()];
  }

  std::vector<ToothContact> ContactSystem::collect_results() const
  {
    std::vector<ToothContact> teeth;
    for (const auto &pair : pairs_)
      {
        const auto         &results = pair->contact.results();
        std::vector<double> sums, maxima;
        for (const GroupPairResult &r : results)
          {
            sums.insert(sums.end(),
                        {r.force[0],
                         r.force[1],
                         r.force[2],
                         r.moment[0],
                         r.moment[1],
                         r.moment[2],
                         r.normal_force,
                         r.area});
            maxima.insert(maxima.end(), {r.largest_pressure, r.largest_penetration});
          }
        communicator_.sum(sums);
        communicator_.max(maxima);

        for (std::size_t i = 0; i < results.size(); ++i)
          {
            const double *s = sums.data() + 8 * i;
            if (!(s[6] > 0))
              continue;
            GroupPairResult sum     = results[i];
            sum.force               = Vector3(s[0], s[1], s[2]);
            sum.moment              = Vector3(s[3], s[4], s[5]);
            sum.normal_force        = s[6];
            sum.area                = s[7];
            sum.largest_pressure    = maxima[2 * i];
            sum.largest_penetration = maxima[2 * i + 1];
            teeth.push_back(make_tooth_contact(model_, pair->definition, sum));
          }
      }
    return teeth;
  }

  void ContactSystem::add_relaxation_masses(const double         fraction,
                                            std::vector<double> &masses) const
  {
    for (const auto &pair : pairs_)
      for (const Side *side : pair->sides())
        {
          const auto &areas = side == &pair->slave ? pair->contact.slave_node_areas()
                                                   : pair->contact.master_node_areas();
          for (std::size_t i = 0; i < side->local.size(); ++i)
            if (side->local[i] != Partition::absent)
              // Two nodes on one spring k: omega^2 = 2 k/m <= (2 fraction)^2.
              masses[side->local[i]] +=
                pair->contact.penalty() * areas[i] / (2 * fraction * fraction);
        }
  }
} // namespace vfife
