// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/pressure/pair_pressure.h>
#include <vfife/fem/pressure/penalty_calibration.h>
#include <vfife/model/model.h>
#include <vfife/model/pair_measures.h>

namespace vfife
{
  PairPressure::PairPressure(Compliance        &compliance,
                             const double       depth,
                             const unsigned int cells_across)
    : compliance_(compliance)
    , model_(compliance.space().model())
    , cells_across_(cells_across)
    , flanks_(compliance.space(), depth)
    , places_(compliance)
  {
  }

  void PairPressure::place(const PairEquilibrium &equilibrium, const PairEquilibriumResult &result)
  {
    for (unsigned int side = 0; side < 2; ++side)
      {
        const unsigned int  body  = flanks_.body(side);
        const Body         &b     = model_.bodies[body];
        const std::size_t   first = compliance_.space().find_part(body)->first_point;
        std::vector<double> positions;
        for (const unsigned int node : flanks_.facets(side).nodes)
          {
            const Vector3 moved =
              equilibrium.place(body,
                                b.placement(b.node_positions()[node]) +
                                  compute_mean(flanks_.averages().of(first + node),
                                               result.displacements));
            positions.insert(positions.end(), moved.data(), moved.data() + 3);
          }
        flanks_.place(side,
                      std::move(positions),
                      {equilibrium.rotation(body) * b.placement.rotation,
                       equilibrium.place(body, b.placement.translation)});
      }
    flanks_.bend(result.displacements);
  }

  ContactLoad PairPressure::make_load(const PairEquilibrium       &equilibrium,
                                      const PairEquilibriumResult &result) const
  {
    ContactLoad load;
    load.flexibility = [this](const std::vector<unsigned int> &rows) {
      return compliance_.flexibility(rows);
    };
    load.forces = Eigen::VectorXd::Zero(compliance_.first_motion_row());
    for (const NodalForce &nodal : result.contact_forces)
      {
        const unsigned int point =
          compliance_.space().find_part(nodal.body)->first_point + nodal.node;
        load.forces.segment<3>(3 * places_.nodes[point]) +=
          equilibrium.rotation(nodal.body).transpose() * nodal.force;
      }
    load.arm  = [this](const Vector3 &x, const Vector3 &n) { return flanks_.torque_arm(x, n); };
    load.load = load_torque(model_);
    return load;
  }

  PairPressures PairPressure::solve(const PairEquilibrium       &equilibrium,
                                    const PairEquilibriumResult &result,
                                    PenaltyCalibration          *calibration)
  {
    // Flanks that rigid bodies would press on each other may carry.
    const double reach =
      std::abs(result.turn - result.touch_turn) * model_.only_transmission()->arm;
    place(equilibrium, result);
    std::vector<ElasticContact> contacts;
    for (const auto &[slave, master] : equilibrium.candidate_teeth())
      {
        const FacingSurfaces facing = flanks_.facing(slave, master, equilibrium.depth_limit());
        if (find_least_gap(facing) <= reach)
          contacts.push_back({facing,
                              {{flanks_.make_flank(0, slave, slave, places_),
                                flanks_.make_flank(1, master, master, places_)}}});
      }
    const ContactLoad         load  = make_load(equilibrium, result);
    std::vector<GridPressure> grids = find_grid_pressures(contacts, load, cells_across_);
    if (calibration != nullptr)
      calibration->add(contacts, load, grids);
    PairPressures found;
    for (std::size_t i = 0; i < grids.size(); ++i)
      {
        const FacingSurfaces &teeth = contacts[i].surfaces;
        found.lead                  = -grids[i].closing;
        if (grids[i].carries())
          found.teeth.push_back(
            flanks_.describe(teeth.slave_group, teeth.master_group, std::move(grids[i])));
      }
    return found;
  }
} // namespace vfife
