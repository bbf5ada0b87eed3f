// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets of gear bodies as grids of facets, and gauges glued into them.
#include "../mesh/coarsest.h"
#include "../mesh/paper_members.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/model/body.h>
#include <vfife/stress/gauge.h>
#include <vfife/stress/surface_stress.h>

#include <set>

using namespace vfife;

Body make_body(const GearMember  &member,
               GearBodyOptions    options,
               const unsigned int columns,
               const unsigned int refinements)
{
  options                  = coarsest(options);
  options.cells_lengthwise = columns;
  options.refinements      = refinements;
  return Body(member.name(), make_gear_body(member, options), Material());
}

FlankSide side_of(const std::string &side)
{
  return side == surface_name::concave ? FlankSide::concave : FlankSide::convex;
}

/** Length of the true profile of the fillet at L [mm]. */
double true_profile(const GearMember &member, const FlankSide side, const double L)
{
  constexpr unsigned int n      = 400;
  double                 length = 0;
  Vector3                last   = member.fillet_point(side, L, 0.).position;
  for (unsigned int k = 1; k <= n; ++k)
    {
      const Vector3 next = member.fillet_point(side, L, member.fillet_end(side) * k / n).position;
      length += (next - last).norm();
      last = next;
    }
  return length;
}

void check_grid(const GearMember      &member,
                const GearBodyOptions &options,
                const std::string     &side,
                const unsigned int     refinements)
{
  const Body        body = make_body(member, options, 3, refinements);
  const Fillet      fillet(body, side);
  const std::string name =
    member.name() + ", " + side + ", " + std::to_string(refinements) + " refinements: ";
  const unsigned int factor = 1u << refinements;
  check(name + "columns and rows",
        fillet.n_columns() == 3 * factor && fillet.n_rows() == 2 * factor + 2);

  // The fillet's own facets are those between the nodes of its set, each once.
  const unsigned int     last = fillet.n_teeth() - 1;
  std::set<unsigned int> nodes, expected;
  for (unsigned int c = 0; c <= fillet.n_columns(); ++c)
    for (unsigned int r = Fillet::first_row; r <= fillet.end_row(); ++r)
      for (const unsigned int tooth : {0u, last})
        nodes.insert(fillet.node(c, r, tooth));
  const unsigned int per_tooth = body.n_nodes() / fillet.n_teeth();
  for (const unsigned int i : body.node_set(side + " fillet"))
    if (i < per_tooth || i >= last * per_tooth)
      expected.insert(i);
  check(name + "nodes of two teeth", nodes == expected);

  const std::set<unsigned int> toe(body.node_set(node_set::toe).begin(),
                                   body.node_set(node_set::toe).end()),
    root(body.node_set(node_set::root_land).begin(), body.node_set(node_set::root_land).end()),
    flank(body.node_set(side).begin(), body.node_set(side).end());
  bool in_place = true;
  for (unsigned int r = 0; r <= fillet.n_rows(); ++r)
    in_place = in_place && toe.count(fillet.node(0, r, last)) == 1;
  for (unsigned int c = 0; c <= fillet.n_columns(); ++c)
    in_place = in_place && root.count(fillet.node(c, 0, last)) == 1 &&
               root.count(fillet.node(c, Fillet::first_row, 0)) == 1 &&
               flank.count(fillet.node(c, fillet.end_row(), 0)) == 1 &&
               flank.count(fillet.node(c, fillet.n_rows(), last)) == 1;
  check(name + "toe, root land and flank where they are", in_place);

  // Normals out of the metal; of the flank's row those of the surface in contact.
  bool outwards = true;
  for (const unsigned int tooth : {0u, last})
    for (unsigned int c = 0; c < fillet.n_columns(); ++c)
      for (unsigned int r = 0; r < fillet.n_rows(); ++r)
        {
          const auto facet = fillet.facet(c, r, tooth);
          Vector3    x[4], centre = Vector3::Zero();
          for (unsigned int k = 0; k < 4; ++k)
            {
              x[k] = body.node_positions()[facet[k]];
              centre += x[k] / 4.;
            }
          const Vector3 normal = (x[2] - x[0]).cross(x[3] - x[1]).normalized();
          // Two fillets of a tooth look away from it, and all look away from the axis' side.
          const Vector3 a(centre[0], centre[1], 0.);
          outwards = outwards && (r > 0 || normal.dot(a) > 0);
          if (r == fillet.end_row())
            {
              const double  turn = tooth * member.pitch();
              const Vector3 back =
                rotation_about(Vector3::UnitZ(), -turn) * (x[0] + x[1] + x[2] + x[3]) / 4.;
              const Vector2 L_h =
                member.blank().cone_coordinates(Vector2(back.head<2>().norm(), back[2]));
              const SurfacePoint point = member.flank_point(side_of(side), L_h[0], L_h[1]);
              outwards =
                outwards && normal.dot(rotation_about(Vector3::UnitZ(), turn) * point.normal) < -.9;
            }
        }
  check(name + "corners round against the clock", outwards);

  // Chords of the true profile: short by the square of their angle.
  const double L      = member.blank().inner_cone_distance();
  const double length = true_profile(member, side_of(side), L);
  check_close(name + "length of the profile at the toe",
              fillet.profile_length(0, fillet.end_row()) / length,
              1. - .012 / (factor * factor),
              .008 / (factor * factor));
}

/** A gauge across the start of the flank, half-way along the face. */
GaugeOptions make_options(const double direction, const double length)
{
  GaugeOptions options;
  options.side      = surface_name::convex;
  options.height    = 1.;
  options.direction = direction;
  options.length    = length;
  return options;
}

/** Where the middle of such a gauge is. */
Vector3 find_middle(const Body &body, const Fillet &fillet)
{
  const auto place = [&](const unsigned int column) {
    return body.node_positions()[fillet.node(column, fillet.end_row(), 0)];
  };
  double left = 0;
  for (unsigned int c = 0; c < fillet.n_columns(); ++c)
    left += .5 * (place(c + 1) - place(c)).norm();
  unsigned int c = 0;
  for (; (place(c + 1) - place(c)).norm() < left; ++c)
    left -= (place(c + 1) - place(c)).norm();
  return place(c) + left * (place(c + 1) - place(c)).normalized();
}

/** What a gauge reads where the strain is G everywhere: t.G t, t along it. */
double read(const Gauge &gauge, const Body &body, const Matrix3 &G, const unsigned int tooth = 0)
{
  return gauge.of_displacements(
    [&](const unsigned int i) { return Vector3(G * body.node_positions()[i]); }, tooth);
}

void check_gauges()
{
  // An odd number of columns: the middle of the face is that of a facet.
  const Body   body = make_body(paper::gear(), GearBodyOptions(), 9, 0);
  const Fillet fillet(body, surface_name::convex);
  const auto  &X = body.node_positions();
  Matrix3      G;
  G << 1., .2, -.3, .5, -.4, .1, .2, .6, .7;
  G *= 1e-4;
  const Matrix3 R      = rotation_about(Vector3(1., 2., 3.).normalized(), 1.3),
                S      = rotation_about(Vector3::UnitZ(), 2. * pi / fillet.n_teeth());
  const Vector3 middle = find_middle(body, fillet);
  for (const double direction : {0., .25 * pi, .5 * pi, -.7 * pi})
    {
      const std::string name = "gauge at " + std::to_string(int(direction * 180. / pi)) + " deg: ";
      const Gauge       gauge(body, fillet, make_options(direction, .2), "Fillets/Gauge G");
      const double      strain = read(gauge, body, G);
      check_close(
        name + "large rotation",
        gauge.of_places([&](const unsigned int i) { return Vector3(R * (X[i] + G * X[i])); }, 0),
        strain,
        G.squaredNorm());
      check_close(name + "the next tooth in the field turned with it",
                  read(gauge, body, S * G * S.transpose(), 1),
                  strain,
                  1e-12);
      // t t^T from three elongations: a unit tensor in all.
      double trace = 0;
      for (unsigned int c = 0; c < 3; ++c)
        trace += read(gauge, body, Vector3::Unit(c) * Vector3::Unit(c).transpose());
      check_ratio(name + "uniform growth", trace, 1e-12);

      // A bar along y that is bent, x across the neutral plane: strains kappa x, -nu kappa x.
      const double kappa = 1e-6, nu = .29;
      const auto   bent = [&](const unsigned int i) {
        const double x = X[i][0], y = X[i][1], z = X[i][2];
        return Vector3(-.5 * kappa * (y * y + nu * (x * x - z * z)),
                       kappa * x * y,
                       -nu * kappa * x * z);
      };
      const double along = read(gauge, body, Vector3::UnitY() * Vector3::UnitY().transpose());
      check_ratio(name + "bent bar",
                  gauge.of_displacements(bent, 0) /
                    (kappa * middle[0] * (along - nu * (1. - along))),
                  .005);
    }
  print_refusal([&] { Gauge(body, fillet, make_options(.5 * pi, 100.), "Fillets/Gauge G"); });
  print_refusal([&] { Gauge(body, fillet, make_options(0., 20.), "Fillets/Gauge G"); });
  GaugeOptions no_tooth = make_options(0., 1.);
  no_tooth.tooth        = 79;
  print_refusal([&] { Gauge(body, fillet, no_tooth, "Fillets/Gauge G"); });
}

int main()
{
  for (const unsigned int refinements : {0u, 1u})
    for (const char *side : {surface_name::concave, surface_name::convex})
      {
        check_grid(paper::gear(), GearBodyOptions(), side, refinements);
        check_grid(paper::pinion(), pinion_body_defaults(), side, refinements);
      }
  check_gauges();
  return 0;
}
