// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/contact.h>
#include <vfife/fem/pressure/instant_pressure.h>
#include <vfife/fem/statics/compliance.h>
#include <vfife/model/model.h>

#include <numeric>

namespace vfife
{
  namespace
  {
    /** The tooth of each member whose flexibility all others have. */
    constexpr unsigned int copied = 0;
  } // namespace

  InstantPressure::InstantPressure(const Model        &model,
                                   const FemOptions   &options,
                                   const double        depth,
                                   const unsigned int  cells_across,
                                   const Communicator &communicator)
    : cells_across_(cells_across)
    , space_(model, all_bodies(model), options)
    , flanks_(space_, depth)
    , depth_limit_(
        Contact(flanks_.facets(0), flanks_.facets(1), flanks_.definition().options).depth_limit())
  {
    std::vector<unsigned int> points, rows;
    for (unsigned int side = 0; side < 2; ++side)
      {
        flanks_.near_layer(side, copied); // before the factors, which take longer to fail
        for (const unsigned int node : flanks_.nodes_of(side, copied))
          points.push_back(flanks_.point_of(side, node));
      }
    Compliance compliance(model, options, model.any_body_turns(), communicator);
    compliance.watch(points);
    places_ = std::make_unique<const PointPlaces>(compliance);
    rows.resize(compliance.first_motion_row());
    std::iota(rows.begin(), rows.end(), 0u);
    flexibility_ = compliance.flexibility(rows);
  }

  void InstantPressure::check(const Model &model, const FemOptions &options, const double depth)
  {
    const FemSpace space(model, all_bodies(model), options);
    FlankPair      flanks(space, depth);
    for (unsigned int side = 0; side < 2; ++side)
      flanks.near_layer(side, copied);
  }

  void InstantPressure::place(const FlankState &state)
  {
    for (unsigned int side = 0; side < 2; ++side)
      flanks_.place(side, state.positions[side], state.motions[side]);
    forces_ = state.forces;
  }

  bool InstantPressure::rubs() const
  {
    return flanks_.definition().options.friction.acts();
  }

  std::vector<Vector3> InstantPressure::find_forces(const unsigned int side,
                                                    const unsigned int group)
  {
    const FacetSurface  &facets = flanks_.facets(side);
    std::vector<Vector3> forces(facets.nodes.size(), Vector3::Zero());
    for (const unsigned int node : flanks_.nodes_of(side, group))
      forces[node] = Eigen::Map<const Vector3>(forces_[side].data() + 3 * std::size_t(node));
    if (!rubs())
      return forces;
    // What friction does stays; pressures on the grid take the place of those of the motion.
    for (const unsigned int f : flanks_.surface(side).group_facets(group))
      for (unsigned int k = 0; k < 4; ++k)
        {
          const double  xi = k == 1 || k == 2, eta = k >= 2;
          const Vector3 n     = flanks_.surface(side).state(f).normal(xi, eta).normalized();
          Vector3      &force = forces[facets.facets[f][k]];
          force               = n * n.dot(force);
        }
    return forces;
  }

  ContactLoad InstantPressure::make_load(const std::array<unsigned int, 2> &groups,
                                         const std::array<ElasticFlank, 2> &flanks,
                                         const double                       normal_force)
  {
    ContactLoad load;
    load.flexibility = [this](const std::vector<unsigned int> &rows) {
      Eigen::MatrixXd flexibility(rows.size(), rows.size());
      for (std::size_t k = 0; k < rows.size(); ++k)
        for (std::size_t i = 0; i < rows.size(); ++i)
          flexibility(i, k) = flexibility_(rows[i], rows[k]);
      return flexibility;
    };
    load.forces       = Eigen::VectorXd::Zero(flexibility_.rows());
    Vector3 resultant = Vector3::Zero(); // on the slave
    for (unsigned int side = 0; side < 2; ++side)
      {
        const std::vector<Vector3> forces = find_forces(side, groups[side]);
        for (const unsigned int node : flanks_.nodes_of(side, groups[side]))
          {
            load.forces.segment<3>(3 * flanks[side].places[node]) =
              flanks[side].rotation.transpose() * forces[node];
            if (side == 0)
              resultant += forces[node];
          }
      }
    // Normals of nodes are not those of the points that press: the parts along them are somewhat
    // less in all.
    if (rubs() && resultant.norm() > 0.)
      {
        const double scale = normal_force / resultant.norm();
        load.forces *= scale;
        resultant *= scale;
      }
    const Vector3 direction = resultant.normalized();
    load.arm  = [direction](const Vector3 &, const Vector3 &n) { return n.dot(direction); };
    load.load = resultant.norm();
    return load;
  }

  ToothPressure InstantPressure::solve(const unsigned int slave_group,
                                       const unsigned int master_group,
                                       const double       normal_force)
  {
    const ElasticContact contact{flanks_.facing(slave_group, master_group, depth_limit_),
                                 {{flanks_.make_flank(0, slave_group, copied, *places_),
                                   flanks_.make_flank(1, master_group, copied, *places_)}}};
    const ContactLoad load = make_load({{slave_group, master_group}}, contact.flanks, normal_force);
    if (!(load.load > 0.))
      throw NumericalError("the teeth are not in contact");
    GridPressure grid = find_grid_pressures({contact}, load, cells_across_).front();
    // Its arms were those of an approach along the resultant.
    grid.force  = grid.moment;
    grid.moment = 0.;
    for (std::size_t i = 0; i < grid.cells.size(); ++i)
      grid.moment +=
        grid.force_of(i) * flanks_.torque_arm(grid.cells[i].position, grid.cells[i].normal);
    return flanks_.describe(slave_group, master_group, std::move(grid));
  }
} // namespace vfife
