// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The web's fillets at the hub: grid of facets and curved elements on the true arcs, and stresses
// of a spinning gear by a submodel that follows a coarse mesh, against a whole quadratic body.
#include "../ranks.h"
#include "../refusal.h"
#include "fillet_readings.h"
#include "pinion_fillets.h"

#include <vfife/fem/statics/compliance.h>
#include <vfife/fem/submodel/sector_submodel.h>
#include <vfife/model/load_shares.h>
#include <vfife/study/fillets/fillet_faces.h>

using namespace vfife;

constexpr double radius = 2.; ///< [mm]

GearBodyOptions options_of(const unsigned int web_rows, const unsigned int fillet_rows)
{
  GearBodyOptions options   = coarse(GearBodyOptions());
  options.hub_fillet_radius = radius;
  options.web_rows          = web_rows;
  options.fillet_rows       = fillet_rows;
  return options;
}

/** The paper's gear at 20,000 rpm on a rigid axle. */
Model make_gear(const GearBodyOptions &options)
{
  Model model        = model_of(Body("gear", make_gear_body(paper::gear(), options), Material()));
  Body &body         = model.bodies[0];
  body.axis          = {Vector3::Zero(), Vector3::UnitZ()};
  body.turns_on_axis = true;
  body.rate          = 20000. * 27. / 79. * pi / 30.;
  model.constraints.push_back({"bore", ConstraintKind::held, 0, body.node_set(node_set::bore)});
  return model;
}

std::deque<MemberFillet> list_hub_fillets(const Body &body)
{
  std::deque<MemberFillet> fillets;
  for (const std::string &side : Fillet::list_sides(body))
    if (Fillet::is_at_hub(side))
      fillets.push_back({0, Fillet(body, side)});
  return fillets;
}

Vector2 meridian_place(const Vector3 &x)
{
  return {std::hypot(x[0], x[1]), x[2]};
}

void check_geometry(const Model &model)
{
  const Body    &body = model.bodies[0];
  const FemSpace sector =
    FemSpace::sector_of(model, 0, {FemElement::quadratic, FemGeometry::curved});
  for (const MemberFillet &member : list_hub_fillets(body))
    {
      const Fillet &fillet = member.fillet;
      const bool    front  = fillet.side() == Fillet::hub_front;
      // The arc is tangent to the hub.
      const Vector2 bottom =
        meridian_place(body.node_positions()[fillet.node(0, Fillet::first_row, 0)]);
      const Vector2 centre = bottom + Vector2(radius, 0.);
      // The front face turns by 110 degrees into the hub, the back face by 70.
      const unsigned int rows  = fillet.end_row() - Fillet::first_row;
      const double       angle = (front ? 110. : 70.) * degree;
      check_close(fillet.side() + ": chords of the arc [mm]",
                  fillet.profile_length(0, fillet.end_row()) -
                    fillet.profile_length(0, Fillet::first_row),
                  2. * radius * rows * std::sin(.5 * angle / rows),
                  1e-9);
      double inward = 1., off_arc = 0.;
      for (unsigned int column = 0; column < fillet.n_columns(); ++column)
        for (unsigned int row = Fillet::first_row; row < fillet.end_row(); ++row)
          {
            const auto             facet = fillet.facet(column, row, 0);
            std::array<Vector3, 4> x;
            for (unsigned int k = 0; k < 4; ++k)
              x[k] = body.node_positions()[facet[k]];
            const Vector3 normal = (x[2] - x[0]).cross(x[3] - x[1]).normalized();
            const Vector2 place  = meridian_place(.25 * (x[0] + x[1] + x[2] + x[3]));
            const Vector2 across = (centre - place).normalized();
            inward               = std::min(inward,
                              across.dot(Vector2(normal.head<2>().dot(x[0].head<2>().normalized()),
                                                 normal[2])));
            for (const BoundaryFace &face : find_boundary_faces(body, {facet.begin(), facet.end()}))
              for (const auto &[points, X] : points_of_face(sector, sector.parts()[0], face))
                for (Eigen::Index i = 0; i < X.cols(); ++i)
                  raise_to(off_arc, std::abs((meridian_place(X.col(i)) - centre).norm() - radius));
          }
      check(fillet.side() + ": facets are seen from outside", inward > .9);
      check_below(fillet.side() + ": points of quadratic elements off the arc [mm]", off_arc, 1e-9);
    }
}

/** Stresses of the fillets of sector 0 by a submodel that follows the body in spin. */
RootStresses follow(const Model &followed, const Model &fine, const std::vector<double> &u)
{
  const FemSpace sector =
    FemSpace::sector_of(fine, 0, {FemElement::quadratic, FemGeometry::curved});
  const auto            readings = read_fillets(sector, list_hub_fillets(fine.bodies[0]));
  const Body           &body     = followed.bodies[0];
  const SectorSubmodel  submodel(SubmodelPart::web, sector, body, readings);
  const Eigen::VectorXd values =
    submodel.load(0, {}, body.rate) + submodel.follow(0, [&u](const unsigned int node) -> Vector3 {
      return Eigen::Map<const Vector3>(u.data() + 3 * node);
    });
  RootStresses found;
  for (Eigen::Index k = 0; k < values.size(); k += 3)
    {
      const PrincipalStresses stress =
        compute_principal_stresses(compute_surface_stress(values.segment<3>(k), Material()));
      raise_to(found.tension, stress.first);
      found.compression = -largest_of(-found.compression, -stress.third);
    }
  return found;
}

int main(int argc, char **argv)
{
  const TestRanks ranks(argc, argv);
  const Model     fine = make_gear(options_of(12, 6));
  check_geometry(fine);

  // A body in spin is on a tangent that a submodel does not know: less than 1 % here.
  const Model        coarse_gear = make_gear(options_of(5, 2));
  const Compliance   trilinear(coarse_gear, {}, true, ranks.world);
  const RootStresses by_submodel = follow(coarse_gear, fine, trilinear.spun());
  FemOptions         quadratic;
  quadratic.element  = FemElement::quadratic;
  quadratic.geometry = FemGeometry::curved;
  const Compliance   whole(fine, quadratic, true, ranks.world);
  const auto         fillets = list_hub_fillets(fine.bodies[0]);
  const RootStresses reference =
    find_largest(fillets, FilletFaces(whole.space(), fillets).of(whole.spun()));
  check_close("tension in spin, submodel and whole quadratic body [MPa]",
              by_submodel.tension,
              reference.tension,
              .08 * reference.tension);
  check_close("compression in spin, submodel and whole quadratic body [MPa]",
              by_submodel.compression,
              reference.compression,
              .08 * -reference.compression);
  const RootStresses on_quadratic = follow(fine, fine, whole.spun());
  check_close("tension, the submodel follows the quadratic body [MPa]",
              on_quadratic.tension,
              reference.tension,
              .01 * reference.tension);
  print_refusal([&] { Fillet(make_gear(coarse(GearBodyOptions())).bodies[0], Fillet::hub_front); });
  return 0;
}
