// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Shafts meshed with gear bodies: volume and inertias against prisms over polygons and against the
// round rings, conforming and cyclic meshes, sets and their areas.

#include "../tests.h"

#include "paper_members.h"
#include "sector_copies.h"

#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/gear/gear_meridian.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/mesh/node_set_names.h>

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <set>

using namespace vfife;

namespace
{
  /** What a mesh of a body is held against. */
  struct Expected
  {
    Vector2      hub            = Vector2::Zero(); ///< z of its ends [mm]
    unsigned int around_outside = 0;               ///< columns at the bore and outside it
    unsigned int around_within  = 0; ///< columns inside a row that joins three into one
    double       joining_radius = 0; ///< outer one of that row [mm]

    unsigned int around(const double radius) const
    {
      return radius < joining_radius - 1e-9 ? around_within : around_outside;
    }
  };

  /** A prism over the regular polygon of @p n corners on a circle. Triangles from the axis to a
   * side of angle a have area R^2 sin(a)/2 and int r^2 dA of this times R^2 (2 + cos(a))/6. */
  SolidIntegrals prism(const unsigned int n, const double R, const double from, const double to)
  {
    const double a = 2. * pi / n, area = .5 * n * R * R * std::sin(a), l = to - from;
    return {area * l,
            area * l * R * R * (2. + std::cos(a)) / 6.,
            area * .5 * (to * to - from * from),
            area * (to * to * to - from * from * from) / 3.};
  }

  SolidIntegrals negative(const SolidIntegrals &s)
  {
    return {-s.volume, -s.radius_squared, -s.height, -s.height_squared};
  }

  double polygon_area(const unsigned int n, const double R)
  {
    return prism(n, R, 0., 1.).volume;
  }

  /** Integrals over the cells of the shaft that @p select takes by the z of their middle. */
  template <typename Selection>
  SolidIntegrals integrate_shaft(const BodyMesh &mesh, const Selection &select)
  {
    std::set<dealii::Triangulation<3>::active_cell_iterator> others;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      if (mesh.regions.at(cell->material_id()) != "shaft" || !select(cell->center()[2]))
        others.insert(cell);
    dealii::Triangulation<3> shaft;
    dealii::GridGenerator::create_triangulation_with_removed_cells(mesh.triangulation,
                                                                   others,
                                                                   shaft);
    return compute_solid_integrals(shaft);
  }

  /** Largest relative difference. */
  double difference(const SolidIntegrals &a, const SolidIntegrals &b)
  {
    return largest_of({std::abs(a.volume / b.volume - 1.),
                       std::abs(a.radius_squared / b.radius_squared - 1.),
                       std::abs(a.height / b.height - 1.),
                       std::abs(a.height_squared / b.height_squared - 1.)});
  }

  /** Beyond the hub the shaft is prisms over polygons, exactly. @p whole: also in the hub, where
   * lines of the bore run straight. */
  void check_prisms(const BodyMesh        &mesh,
                    const GearBodyOptions &options,
                    const Expected        &expected,
                    const bool             whole)
  {
    SolidIntegrals sum;
    for (const ShaftSection &s : options.shaft.sections("Shaft"))
      for (const Vector2 &part :
           {Vector2(s.from, std::min(s.to, expected.hub[0])),
            Vector2(std::max(s.from, expected.hub[1]), s.to),
            Vector2(std::max(s.from, expected.hub[0]), std::min(s.to, expected.hub[1]))})
        if (part[0] < part[1] && (whole || part[0] < expected.hub[0] || part[0] >= expected.hub[1]))
          for (const double R : {.5 * s.outer, .5 * s.inner})
            {
              const SolidIntegrals p = prism(expected.around(R), R, part[0], part[1]);
              sum += R == .5 * s.outer ? p : negative(p);
            }
    const auto select = [&](const double z) {
      return whole || z < expected.hub[0] || z > expected.hub[1];
    };
    // round-off of sums over many cells
    check_below(mesh.name + ": integrals of the shaft over those of its prisms",
                difference(integrate_shaft(mesh, select), sum),
                options.refinements == 0 ? 1e-12 : 1e-11);
  }

  /** Area of the facets that @p select takes by their middle (r, z). */
  template <typename Selection>
  double area_of(const FacetSurface &surface, const Selection &select)
  {
    double area = 0.;
    for (const auto &facet : surface.facets)
      {
        const auto   &x      = surface.positions;
        const Vector3 middle = .25 * (x[facet[0]] + x[facet[1]] + x[facet[2]] + x[facet[3]]);
        if (select(std::hypot(middle[0], middle[1]), middle[2]))
          area += .5 * (x[facet[2]] - x[facet[0]]).cross(x[facet[3]] - x[facet[1]]).norm();
      }
    return area;
  }

  /** The faces of a set are those of the boundary id of its name. */
  FacetSurface surface_of(const BodyMesh &mesh, const char *name)
  {
    unsigned int id = 0;
    for (const auto &boundary : mesh.boundaries)
      if (boundary.second == name)
        id = boundary.first;
    const FacetSurface by_set =
      surface_of_boundary(mesh.triangulation, name, mesh.node_sets.at(name));
    const FacetSurface by_id = surface_of_boundary(mesh.triangulation, name, id);
    check(mesh.name + ": " + name + ", faces of the set and of the boundary",
          by_set.facets.size() == by_id.facets.size() &&
            by_set.nodes.size() == mesh.node_sets.at(name).size());
    return by_set;
  }

  /** Each side of each section, beyond the hub, where the lines of a solid body's bore are skewed.
   */
  void check_sides(const BodyMesh &mesh, const GearBodyOptions &options, const Expected &expected)
  {
    const FacetSurface outside = surface_of(mesh, node_set::shaft_surface),
                       inside  = surface_of(mesh, node_set::shaft_bore);
    double worst = 0., all = 0.;
    for (const ShaftSection &s : options.shaft.sections("Shaft"))
      for (const bool outer : {true, false})
        {
          const double       radius = .5 * (outer ? s.outer : s.inner);
          const unsigned int n      = expected.around(radius);
          const double       in_hub =
            std::max(0., std::min(s.to, expected.hub[1]) - std::max(s.from, expected.hub[0]));
          const double exact = 2. * n * radius * std::sin(pi / n) * (s.to - s.from - in_hub);
          const double found =
            area_of(outer ? outside : inside, [&](const double r, const double z) {
              return s.from < z && z < s.to && (z < expected.hub[0] || z > expected.hub[1]) &&
                     std::abs(r / radius / std::cos(pi / n) - 1.) < 1e-9;
            });
          worst = largest_of(worst, std::abs(found / exact - 1.));
          all += outer ? exact : 0.;
        }
    check_below(mesh.name + ": areas of the sides of each section", worst, 1e-12);
    check_close(mesh.name + ": nothing else on the shaft's surface",
                area_of(outside, [](double, double) { return true; }) / all,
                1.,
                1e-12);
  }

  void check_ends(const BodyMesh &mesh, const Expected &expected, const std::vector<Vector2> &ends)
  {
    double exact = 0.;
    for (const Vector2 &end : ends)
      exact += polygon_area(expected.around(end[0]), end[0]) -
               polygon_area(expected.around(end[1]), end[1]);
    check_close(mesh.name + ": area of the ends and shoulders",
                area_of(surface_of(mesh, node_set::shaft_ends),
                        [](double, double) { return true; }) /
                  exact,
                1.,
                1e-12);
  }

  /** The bore is inside: on each of its faces a cell of the hub and one of the shaft. */
  void check_bore(const BodyMesh &mesh, const unsigned int faces)
  {
    const auto  &bore   = mesh.node_sets.at(node_set::bore);
    unsigned int found  = 0;
    bool         inside = true;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          bool on_bore = mesh.regions.at(cell->material_id()) == "shaft";
          for (unsigned int v = 0; v < 4 && on_bore; ++v)
            on_bore = std::binary_search(bore.begin(), bore.end(), cell->face(f)->vertex_index(v));
          if (!on_bore)
            continue;
          ++found;
          inside = inside && !cell->face(f)->at_boundary() &&
                   mesh.regions.at(cell->neighbor(f)->material_id()) != "shaft";
        }
    check(mesh.name + ": the bore is shared by hub and shaft", inside && found == faces);
    std::set<unsigned int> nodes;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      if (mesh.regions.at(cell->material_id()) == "shaft")
        for (const unsigned int v : cell->vertex_indices())
          nodes.insert(cell->vertex_index(v));
    const auto &set = mesh.node_sets.at(node_set::shaft);
    check(mesh.name + ": set of all nodes of the shaft",
          std::equal(nodes.begin(), nodes.end(), set.begin(), set.end()));
  }

  /** @p columns: of a sector, at the bore; @p joining_radius: under which three become one, where
   * their number allows; @p ends: radii between which faces across the axis are free. */
  void check_body(const std::string          &name,
                  const GearGeometry         &gear,
                  GearBodyOptions             options,
                  const unsigned int          columns,
                  const double                joining_radius,
                  const std::vector<Vector2> &ends)
  {
    const bool coarsens = columns % 3 == 0, solid = options.web == WebKind::solid;
    for (const unsigned int times : {0u, 1u})
      {
        options.refinements = times;
        const auto mesh     = make_gear_body(gear, options);
        mesh->name          = name + (times > 0 ? ", refined" : "");
        const Expected expected{ends_of(*mesh, node_set::bore),
                                gear.blank().teeth * columns << times,
                                gear.blank().teeth * (coarsens ? columns / 3 : columns) << times,
                                joining_radius};
        check_prisms(*mesh, options, expected, !solid);
        check_sides(*mesh, options, expected);
        check_ends(*mesh, expected, ends);
        const unsigned int lines =
          solid ? options.cells_lengthwise : 2 * options.hub_side_cells + options.web_layers;
        check_bore(*mesh, expected.around_outside * (lines << times));
        check_copies(*mesh);
        check_closed(*mesh);
        const MeshQuality quality = compute_mesh_quality(mesh->triangulation);
        // as of bodies without a shaft (gear_webs)
        check(mesh->name + ": shape of the cells",
              quality.least_determinant > 0. && quality.least_scaled_jacobian > .5);
        // Lengths in the hub count twice, and each diameter for a row.
        const double foreseen = options.n_cells(gear.blank()) / quality.cells;
        check(mesh->name + ": number of cells foreseen", foreseen > 1. && foreseen < 2.);
      }
  }

  /** The round shaft: its share of the true body by closed forms, and meshes that converge to it.
   */
  void check_convergence(const GearGeometry &gear, GearBodyOptions options)
  {
    GearBodyOptions bare = options;
    bare.shaft           = {};
    SolidIntegrals rings = compute_true_integrals(gear, bare);
    for (const ShaftSection &s : options.shaft.sections("Shaft"))
      {
        const double R = .5 * s.outer, r = .5 * s.inner, area = pi * (R * R - r * r);
        rings += {area * (s.to - s.from),
                  .5 * area * (R * R + r * r) * (s.to - s.from),
                  .5 * area * (s.to * s.to - s.from * s.from),
                  area * (std::pow(s.to, 3) - std::pow(s.from, 3)) / 3.};
      }
    const SolidIntegrals exact = compute_true_integrals(gear, options);
    check_below(gear.name() + ": true body with a shaft", difference(exact, rings), 1e-13);
    options.refinements = 0;
    const SolidIntegrals first =
      compute_solid_integrals(make_gear_body(gear, options)->triangulation);
    options.refinements = 1;
    const SolidIntegrals second =
      compute_solid_integrals(make_gear_body(gear, options)->triangulation);
    const auto compare = [&](const std::string &what, const auto &value) {
      const double one = value(first) / value(exact) - 1., two = value(second) / value(exact) - 1.;
      check_below(gear.name() + " with a shaft: " + what + ", refined", two, 1e-3);
      // second order; what is left is as small as of bodies without a shaft (solid_integrals)
      check_below(gear.name() + " with a shaft: " + what + ", extrapolated",
                  (4. * two - one) / 3.,
                  1e-5);
    };
    compare("volume", [](const SolidIntegrals &s) { return s.volume; });
    compare("polar inertia", [](const SolidIntegrals &s) { return s.polar(); });
    compare("transverse inertia", [](const SolidIntegrals &s) { return s.transverse(); });
  }
} // namespace

int main()
{
  const GearMember gear = paper::gear(), pinion = paper::pinion();

  // Steps on either side, a collar apart from the body that is shorter than a cell, a wider bore.
  GearBodyOptions solid           = coarse(pinion_body_defaults());
  solid.cells_lengthwise          = 3;
  solid.shaft.text                = "80 140 40 20, 140 160 30 20, 160 163 60 20, 163 200 40 26";
  const std::vector<Vector2> ends = {{20, 10}, {20, 15}, {30, 15}, {30, 20}, {13, 10}, {20, 13}};
  check_body("pinion, three columns to one", pinion, solid, 6, 20., ends);
  solid.cells_across = 3;
  check_body("pinion, columns as they are", pinion, solid, 7, 20., ends);

  // A step under the bore that is too thin for the row that joins columns.
  solid.cells_across = 2;
  solid.shaft.text   = "90 140 40 20, 140 160 39 20";
  check_body("pinion, a thin step", pinion, solid, 6, 19.5, {{20, 10}, {20, 19.5}, {19.5, 10}});

  GearBodyOptions conical       = coarse(GearBodyOptions());
  conical.shaft.text            = "-20 90 100 60, 90 100 80 60, 100 104 130 60";
  conical.shaft.axial_cell_size = conical.shaft.radial_cell_size = 10.;
  const std::vector<Vector2> gear_ends = {{50, 30}, {50, 40}, {65, 40}, {65, 30}};
  check_body("gear, columns as they are", gear, conical, 2, 50., gear_ends);
  conical.cells_across = 5;
  check_body("gear, three columns to one", gear, conical, 3, 50., gear_ends);

  solid            = coarse(pinion_body_defaults());
  solid.shaft.text = "90 180 40 20";
  check_convergence(pinion, solid);
  return 0;
}
