// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// One tooth under pressure: root stresses of a coarse mesh of trilinear elements by a submodel,
// against those of the fine mesh by itself and against a reference of two other programs.
#include "../mesh/coarsest.h"
#include "../ranks.h"
#include "fillet_readings.h"
#include "pinion_fillets.h"

#include <vfife/fem/statics/compliance.h>
#include <vfife/fem/submodel/sector_submodel.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/model/load_shares.h>
#include <vfife/study/fillets/fillet_faces.h>

using namespace vfife;

/** Displacements of all points under the pressure. */
std::vector<double> solve(const Body &body, const Compliance &compliance)
{
  const FemSpace     &space = compliance.space();
  std::vector<double> forces(3 * std::size_t(space.n_points()), 0.);
  add_load_forces(press_flank(body), space, space.parts()[0], 1., forces);
  return compliance.solve(forces);
}

/** Tractions that are left on all facets of both fillets. */
std::vector<PointReading> read_tractions(const FemSpace                 &sector,
                                         const std::deque<MemberFillet> &fillets)
{
  std::vector<PointReading> readings;
  for (const MemberFillet &member : fillets)
    for (unsigned int column = 0; column < member.fillet.n_columns(); ++column)
      for (unsigned int row = Fillet::first_row; row < member.fillet.end_row(); ++row)
        readings.push_back(read_traction(sector, member.fillet.facet(column, row, 0)));
  return readings;
}

/** Largest tension and compression at mid-face: means of the two columns of facets beside it, as
 * read_fillets() reads them. */
RootStresses find_at_middle(const std::deque<MemberFillet> &fillets,
                            const Eigen::VectorXd          &values,
                            std::size_t                     n)
{
  std::size_t n_facets = 0;
  for (const MemberFillet &member : fillets)
    n_facets += member.fillet.n_columns() * (member.fillet.end_row() - Fillet::first_row);
  const std::size_t of_facet = n / n_facets;
  RootStresses      middle;
  std::size_t       at = 0;
  for (const MemberFillet &member : fillets)
    for (unsigned int column = 0; column < member.fillet.n_columns(); ++column)
      {
        double tension = 0., compression = 0.;
        for (unsigned int row = Fillet::first_row; row < member.fillet.end_row(); ++row)
          for (std::size_t point = 0; point < of_facet / 3; ++point, at += 3)
            {
              const PrincipalStresses stress = compute_principal_stresses(
                compute_surface_stress(values.segment<3>(at), member.fillet.material()));
              raise_to(tension, stress.first);
              compression = std::min(compression, stress.third);
            }
        if (2 * column + 2 < member.fillet.n_columns() || 2 * column > member.fillet.n_columns())
          continue;
        if (member.fillet.side() == surface_name::concave)
          middle.tension += .5 * tension;
        else
          middle.compression += .5 * compression;
      }
  return middle;
}

/** A body that grows evenly under pressure from all sides: 3 lambda + 2 mu times the strain. */
void check_even_growth(const FemSpace &sector, const std::vector<PointReading> &tractions)
{
  constexpr double growth   = 1e-3;
  const Material  &material = sector.material(0);
  const double     pressure = growth * (3. * material.lambda() + 2. * material.mu());
  double           largest  = 0.;
  for (const PointReading &reading : tractions)
    {
      double traction = 0.;
      for (const auto &[point, weight] : reading)
        traction += growth * weight.dot(sector.points()[point]);
      raise_to(largest, std::abs(traction / pressure - 1.));
    }
  check_below("traction of even growth, relative error", largest, 1e-9);
}

/** Initial strains: where the followed body expands freely, so does the submodel. */
void check_free_expansion(const GearBodyOptions &options, const FemOptions &elements)
{
  constexpr double expansion = 1e-3;
  Model            warm      = make_held_pinion(options);
  warm.bodies[0].add_initial_strains(std::vector<double>(warm.bodies[0].n_elements(), expansion));
  const FemSpace            sector  = FemSpace::sector_of(warm, 0, elements);
  const auto                fillets = list_fillets(warm.bodies[0]);
  std::vector<PointReading> readings;
  for (const unsigned int row : {Fillet::first_row, fillets.front().fillet.end_row() - 1})
    for (PointReading &reading : read_facet(sector, fillets.front().fillet.facet(1, row, 0)))
      readings.push_back(std::move(reading));
  const SectorSubmodel  submodel(SubmodelPart::teeth, sector, warm.bodies[0], readings);
  const Eigen::VectorXd values =
    submodel.load(0, {}, 0.) + submodel.follow(0, [&](const unsigned int node) -> Vector3 {
      return expansion * warm.bodies[0].node_positions()[node];
    });
  double wrong = 0.;
  for (Eigen::Index k = 0; k < values.size(); k += 3)
    raise_to(wrong, (values.segment<3>(k) - SurfaceTensor(expansion, expansion, 0.)).norm());
  check_below("strain of free thermal expansion, relative error", wrong / expansion, 1e-9);
}

/** The pressure on the elements' faces as forces at points of a quadrature. */
void add_pressure(const FemSpace              &sector,
                  const SectorSubmodel        &submodel,
                  SectorSubmodel::ToothForces &forces)
{
  const Body &body = sector.model().bodies[0];
  const Load  load = press_flank(body);
  for (const BoundaryFace &face : find_boundary_faces(body, load.nodes))
    for (const auto &[points, X] : points_of_face(sector, sector.parts()[0], face))
      for (const FacePoint &at : compute_face_points(X))
        submodel.add_force(surface_name::concave, 0, X * at.N, -load.pressure * at.normal, forces);
}

int main(int argc, char **argv)
{
  const TestRanks ranks(argc, argv);
  // The mesh that runs have by default, and that of submodels.
  const Model     followed       = make_held_pinion(coarse(pinion_body_defaults()));
  GearBodyOptions options        = coarse(pinion_body_defaults());
  options.cells_lengthwise       = 10;
  options.grading_towards_fillet = 4.;
  options.surface_layer          = .5;
  const Model fine               = make_held_pinion(options);
  const auto  fillets            = list_fillets(fine.bodies[0]);
  FemOptions  quadratic;
  quadratic.element  = FemElement::quadratic;
  quadratic.geometry = FemGeometry::curved;

  const FemSpace sector = FemSpace::sector_of(fine, 0, quadratic);
  const auto strains = read_fillets(sector, fillets), tractions = read_tractions(sector, fillets);
  check_even_growth(sector, tractions);
  check_free_expansion(options, quadratic);
  std::vector<PointReading> readings = strains;
  readings.insert(readings.end(), tractions.begin(), tractions.end());
  const SectorSubmodel        submodel(SubmodelPart::teeth, sector, followed.bodies[0], readings);
  SectorSubmodel::ToothForces forces;
  add_pressure(sector, submodel, forces);
  const Compliance          trilinear(followed, {}, false, ranks.world);
  const std::vector<double> u = solve(followed.bodies[0], trilinear);
  const Eigen::VectorXd     values =
    submodel.load(0, forces, 0.) + submodel.follow(0, [&u](const unsigned int node) -> Vector3 {
      return Eigen::Map<const Vector3>(u.data() + 3 * node);
    });
  RootStresses found;
  double       left = 0.; // where the tension is largest
  for (std::size_t k = 0; k < strains.size(); k += 3)
    {
      const PrincipalStresses stress = compute_principal_stresses(
        compute_surface_stress(values.segment<3>(k), fillets.front().fillet.material()));
      // As many points of each facet.
      if (stress.first > found.tension)
        left = values[strains.size() + k * tractions.size() / strains.size()];
      raise_to(found.tension, stress.first);
      found.compression = -largest_of(-found.compression, -stress.third);
    }

  // The fine mesh as a whole body.
  const Compliance          whole(fine, quadratic, false, ranks.world);
  const std::vector<double> v  = solve(fine.bodies[0], whole);
  const RootStresses by_itself = find_largest(fillets, FilletFaces(whole.space(), fillets).of(v));
  check_close("tension, submodel and whole fine body [MPa]",
              found.tension,
              by_itself.tension,
              .015 * by_itself.tension);
  check_close("compression, submodel and whole fine body [MPa]",
              found.compression,
              by_itself.compression,
              .015 * 785.);
  // Elements of the followed mesh by themselves have a third.
  const auto         own     = list_fillets(followed.bodies[0]);
  const RootStresses coarse_ = find_largest(own, FilletFaces(trilinear.space(), own).of(u));
  check_below("tension of the followed mesh over the reference", coarse_.tension / 851., .5);
  check_below("traction left where the tension is largest, over it",
              std::abs(left) / found.tension,
              .15);
  check_close("tension, submodel and reference [MPa]", found.tension, 851., .03 * 851.);
  check_close("compression, submodel and reference [MPa]", found.compression, -785., .05 * 785.);
  const RootStresses middle = find_at_middle(fillets, values, strains.size());
  check_close("tension at mid-face, submodel and reference [MPa]",
              middle.tension,
              565.,
              .03 * 565.);
  check_close("compression at mid-face, submodel and reference [MPa]",
              middle.compression,
              -615.,
              .03 * 615.);
  return 0;
}
