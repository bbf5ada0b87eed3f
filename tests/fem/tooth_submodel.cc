// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Submodels of teeth and webs: on the body's own mesh they have its displacements to round-off, for
// a solid pinion and a gear on a web, under forces on several teeth and in spin. Forces and moments
// on the flanks are kept on another mesh.
#include "../mesh/coarsest.h"
#include "../mesh/paper_members.h"
#include "../ranks.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/fem/fem_options.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/fem/submodel/sector_submodel.h>
#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/node_set_names.h>

using namespace vfife;

Model make_model(const GearGeometry &gear, const GearBodyOptions &options)
{
  Model model;
  model.add_body(Body("gear", make_gear_body(gear, options), Material()));
  Body &body                 = model.bodies[0];
  body.placement.rotation    = Eigen::AngleAxisd(.4, Vector3(1, 2, 3).normalized()).matrix();
  body.placement.translation = Vector3(7, -5, 3);
  body.axis                  = {body.placement.translation, body.placement.rotation.col(2)};
  body.turns_on_axis         = true;
  body.rate                  = 1000.;
  model.constraints.push_back({"bore", ConstraintKind::held, 0, body.node_set(node_set::bore)});
  return model;
}

/** Displacements of nodes of the part. */
std::vector<PointReading> read_nodes(const SubmodelPart part, const FemSpace &sector)
{
  std::vector<PointReading>      readings;
  const Body                    &body = sector.model().bodies[0];
  const std::vector<std::string> sets =
    part == SubmodelPart::teeth
      ? std::vector<std::string>{node_set::concave_fillet, node_set::convex_fillet, node_set::tip}
      : std::vector<std::string>{node_set::hub_fillet_front, node_set::hub_fillet_back};
  for (const std::string &set : sets)
    for (const unsigned int node : body.node_set(set))
      if (body.structure().sector_of(node) == 0)
        for (unsigned int c = 0; c < 3; ++c)
          readings.push_back({{node, Vector3::Unit(c)}});
  return readings;
}

void check_body(const std::string  &name,
                const SubmodelPart  part,
                const Model        &model,
                const Communicator &world)
{
  const Body         &body  = model.bodies[0];
  const Matrix3      &R     = body.placement.rotation;
  const unsigned int  n     = body.structure().n_sectors();
  const FacetSurface &flank = body.mesh().surfaces.at(surface_name::concave);
  const FemSpace      sector =
    FemSpace::sector_of(model, 0, {FemElement::incompatible_modes, FemGeometry::straight});
  const auto           readings = read_nodes(part, sector);
  const SectorSubmodel submodel(part, sector, body, readings);

  // Different forces on the flanks of four teeth, round the first one.
  StaticLoads loads;
  loads.nodal_forces.assign(body.n_nodes(), Vector3::Zero());
  SectorSubmodel::ToothForces forces;
  for (std::size_t f = 0; f < flank.facets.size(); ++f)
    for (const unsigned int corner : flank.facets[f])
      {
        const unsigned int node = flank.nodes[corner], tooth = flank.group[f];
        if (tooth > 2 && tooth + 1 < n)
          continue;
        loads.nodal_forces[node] =
          Vector3(1 + tooth, std::sin(double(node)), .1 * (node % 7)) - R.col(1);
      }
  for (unsigned int node = 0; node < body.n_nodes(); ++node)
    if (!loads.nodal_forces[node].isZero(0.))
      submodel.add_nodal_force(node, R.transpose() * loads.nodal_forces[node], forces);

  FemOptions options;
  options.linear_solver = LinearSolverKind::direct;
  const StaticSolver solver(model, {0}, options, world);
  for (const bool spins : {false, true})
    {
      loads.centrifugal  = spins;
      const auto u       = solver.solve(loads).displacements;
      const auto at_node = [&](const unsigned int node) -> Vector3 {
        return R.transpose() * Eigen::Map<const Vector3>(u.data() + 3 * std::size_t(node));
      };
      double error = 0., largest = 0.;
      for (const unsigned int tooth : {0u, 1u, 3u, n - 1})
        {
          const Eigen::VectorXd values =
            submodel.follow(tooth, at_node) + submodel.load(tooth, forces, spins ? body.rate : 0.);
          const Matrix3 back =
            Eigen::AngleAxisd(-body.structure().angle(tooth), Vector3::UnitZ()).matrix();
          for (std::size_t k = 0; k < readings.size(); k += 3)
            {
              const Vector3 expected =
                back * at_node(body.structure().copy(readings[k].front().first, tooth));
              raise_to(error, (values.segment<3>(k) - expected).norm());
              raise_to(largest, expected.norm());
            }
        }
      check_below(name + (spins ? ", in spin" : "") + ": displacements over the body's largest",
                  error / largest,
                  1e-9);
    }
}

/** Force and moment about the axes of the body are those given, on curved quadratic elements of
 * another mesh. */
void check_forces(const Model &coarse_model, const Model &fine_model)
{
  const Body    &body = coarse_model.bodies[0];
  const FemSpace sector =
    FemSpace::sector_of(fine_model, 0, {FemElement::quadratic, FemGeometry::curved});
  const auto           readings = read_nodes(SubmodelPart::teeth, sector);
  const SectorSubmodel submodel(SubmodelPart::teeth, sector, body, readings);
  check("other meshes: nodes are followed", submodel.followed_nodes().size() > 50);

  // A rigid motion of the body is that of the submodel, without forces.
  const Vector3         shift(.1, -.2, .3), turn(1e-3, 2e-3, -3e-3);
  const auto            rigid  = [&](const Vector3 &x) -> Vector3 { return shift + turn.cross(x); };
  const Eigen::VectorXd values = submodel.follow(0, [&](const unsigned int node) -> Vector3 {
    return rigid(body.node_positions()[node]);
  });
  double                error  = 0.;
  for (std::size_t k = 0; k < readings.size(); k += 3)
    raise_to(error,
             (values.segment<3>(k) -
              rigid(fine_model.bodies[0].node_positions()[readings[k].front().first]))
               .norm());
  check_below("other meshes: rigid motion [mm]", error, 1e-9);

  const FacetSurface         &flank = body.mesh().surfaces.at(surface_name::convex);
  Vector3                     sum   = Vector3::Zero();
  SectorSubmodel::ToothForces at_nodes, at_places;
  for (std::size_t i = 0; i < flank.nodes.size(); ++i)
    if (body.structure().sector_of(flank.nodes[i]) == 0)
      {
        const Vector3 force = -10. * flank.normals[i];
        sum += force;
        submodel.add_nodal_force(flank.nodes[i], force, at_nodes);
        submodel.add_force(surface_name::convex, 0, flank.positions[i], force, at_places);
      }
  for (const auto *forces : {&at_nodes, &at_places})
    {
      Vector3 total = Vector3::Zero();
      for (Eigen::Index k = 0; k < forces->at(0).size(); k += 3)
        total += forces->at(0).segment<3>(k);
      check_below(std::string("other meshes: force ") +
                    (forces == &at_nodes ? "by nodes" : "by places"),
                  (total - sum).norm() / sum.norm(),
                  1e-12);
    }
}

void check_refusals(const Model &pinion, const Model &gear)
{
  const FemSpace sector =
    FemSpace::sector_of(gear, 0, {FemElement::incompatible_modes, FemGeometry::straight});
  print_refusal([&] { SectorSubmodel(SubmodelPart::teeth, sector, pinion.bodies[0], {}); });
}

int main(int argc, char **argv)
{
  const TestRanks ranks(argc, argv);
  GearBodyOptions of_pinion = coarsest(pinion_body_defaults()), of_gear = coarsest({});
  of_gear.hub_fillet_radius = 2.;
  const Model pinion        = make_model(paper::pinion(), of_pinion),
              gear          = make_model(paper::gear(), of_gear);
  check_body("solid pinion", SubmodelPart::teeth, pinion, ranks.world);
  check_body("gear on a web", SubmodelPart::teeth, gear, ranks.world);
  check_body("web of the gear", SubmodelPart::web, gear, ranks.world);
  GearBodyOptions fine  = coarse(pinion_body_defaults());
  fine.surface_layer    = .6;
  fine.cells_lengthwise = 4;
  check_forces(pinion, make_model(paper::pinion(), fine));
  check_refusals(pinion, gear);
  return 0;
}
