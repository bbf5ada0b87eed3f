// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// One tooth of a pinion under pressure on curved elements with a layer of them under its surface,
// against a reference of two other programs.
#include "../gear/paper_pair.h"
#include "../mesh/paper_members.h"
#include "../ranks.h"
#include "../tests.h"
#include "pinion_fillets.h"

#include <vfife/fem/statics/compliance.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/mesh/gear/gear_body.h>
#include <vfife/study/conventional/fillet_faces.h>

#include <numeric>

using namespace vfife;

int main(int argc, char **argv)
{
  const TestRanks ranks(argc, argv);
  GearBodyOptions options  = coarse(pinion_body_defaults());
  options.cells_lengthwise = 8;
  options.cells_across     = 4;
  options.rim_rows         = 6;
  options.surface_layer    = .7;
  Model model;
  model.add_body(Body("pinion", make_gear_body(paper::pinion(), options), Material()));
  const Body &body = model.bodies[0];
  Constraint  bore;
  bore.name         = "bore";
  bore.nodes        = body.node_set(node_set::bore);
  model.constraints = {bore};
  FemOptions fem;
  fem.element  = FemElement::quadratic;
  fem.geometry = FemGeometry::curved;
  const Compliance compliance(model, fem, false, ranks.world);
  check("by one sector", compliance.by_sectors());

  // 100 MPa on the concave flank of tooth 0.
  Load load;
  load.name     = "pressure";
  load.kind     = LoadKind::pressure;
  load.pressure = 100.;
  for (const unsigned int node : body.mesh().surfaces.at(surface_name::concave).nodes)
    if (body.structure().sector_of(node) == 0)
      load.nodes.push_back(node);
  const FemSpace     &space = compliance.space();
  std::vector<double> forces(3 * std::size_t(space.n_points()), 0.);
  add_load_forces(load, space, space.parts()[0], 1., forces);
  Vector3 sum = Vector3::Zero();
  for (unsigned int p = 0; p < space.n_points(); ++p)
    sum += Vector3(forces[3 * p], forces[3 * p + 1], forces[3 * p + 2]);
  // The reference has the flank's area 175.157 mm^2 and this force into the metal.
  check_below("force on the flank over that of the reference",
              (sum + Vector3(3015.82, 13778.20, -10044.10)).norm() / 17317.,
              1e-5);

  const std::vector<double> u = compliance.solve(forces);
  const double              deflection =
    std::inner_product(u.begin(), u.end(), forces.begin(), 0.) / (100. * 175.157);
  // 13.94 um within 0.04; 13.90 with 12 elements lengthwise, 13.93 with cubic ones.
  check_close("mean deflection of the flank [um]", 1e3 * deflection, 13.94, .1);
  // 851 and -785 MPa; 865 and -779 MPa with 12 elements lengthwise.
  const auto         fillets = list_fillets(body);
  const FilletFaces  faces(space, fillets);
  const RootStresses found = find_largest(fillets, faces.of(u));
  check_close("largest tension [MPa]", found.tension, 851., .03 * 851.);
  check_close("largest compression [MPa]", found.compression, -785., .05 * 785.);
  return 0;
}
