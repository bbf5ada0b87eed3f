// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Block, ring and cylinder: numbers of cells, volumes against closed forms, named sides, refusals.

#include "../model_parts.h"
#include "../read_entries.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/mesh/boundary_surface.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/mesh/primitives/primitive_options.h>
#include <vfife/mesh/primitives/primitives.h>

using namespace vfife;

// coordinates of about 10 mm, sums of up to 1000 cells
constexpr double round_off = 1e-11;

double area_of(const FacetSurface &surface, Vector3 &area_vector)
{
  double area = 0.;
  area_vector.setZero();
  for (const auto &f : surface.facets)
    {
      const Vector3 a = .5 * (surface.positions[f[2]] - surface.positions[f[0]])
                               .cross(surface.positions[f[3]] - surface.positions[f[1]]);
      area += a.norm();
      area_vector += a;
    }
  return area;
}

unsigned int open_sides(const FacetSurface &surface)
{
  unsigned int n = 0;
  for (const auto &sides : surface.neighbours)
    for (const unsigned int neighbour : sides)
      n += neighbour == FacetSurface::no_facet ? 1 : 0;
  return n;
}

void check_block()
{
  const auto block   = make_block({2., 3., 5.}, {{2, 3, 4}});
  const auto quality = compute_mesh_quality(block->triangulation);
  check("block cells", quality.cells == 24 && quality.nodes == 60);
  check_close("block volume", quality.volume, 30., round_off);
  check_ratio("block scaled Jacobian", quality.least_scaled_jacobian, round_off);
  check_close("block least determinant", quality.least_determinant, 1.25, round_off);
  check_ratio("block least edge", quality.least_edge, round_off);
  check_ratio("block least height", quality.least_height, round_off);

  const char *names[6]      = {"x-", "x+", "y-", "y+", "z-", "z+"};
  bool        normals_right = true, areas_right = true, nodes_right = true;
  for (unsigned int side = 0; side < 6; ++side)
    {
      const unsigned int d        = side / 2;
      const Vector3      expected = (side % 2 == 0 ? -1. : 1.) * Vector3::Unit(d);
      const auto        &surface  = block->surfaces.at(names[side]);
      Vector3            area_vector;
      const double       area = area_of(surface, area_vector);
      areas_right = areas_right && std::abs(area - 30. / Vector3(2., 3., 5.)[d]) < round_off &&
                    (area_vector - area * expected).norm() < round_off;
      for (const Vector3 &normal : surface.normals)
        normals_right = normals_right && (normal - expected).norm() < round_off;
      nodes_right = nodes_right && surface.nodes.size() == block->node_sets.at(names[side]).size();
    }
  check("block sides: areas, orientation", areas_right);
  check("block sides: normals", normals_right);
  check("block sides: nodes", nodes_right);
  check("block side: open border", open_sides(block->surfaces.at("z+")) == 10);

  const auto whole = surface_of_boundary(block->triangulation,
                                         "all",
                                         numbers_below(block->triangulation.n_vertices()));
  check("block boundary is closed", whole.facets.size() == 52 && open_sides(whole) == 0);
}

void check_ring()
{
  const auto   ring    = make_ring(5., 8., 2., {{3, 40, 2}});
  const auto   quality = compute_mesh_quality(ring->triangulation);
  const double angle   = 2. * pi / 40;
  check("ring cells", quality.cells == 240 && quality.nodes == 480);
  check_close("ring volume",
              quality.volume,
              pi * (64. - 25.) * 2. * std::sin(angle) / angle,
              1e-10);
  check("ring sectors",
        ring->structure.n_sectors() == 40 &&
          ring->structure.sector_of_element(ring->triangulation.n_active_cells() - 1) == 39);
  Vector3      area_vector;
  const double outer = area_of(ring->surfaces.at("outer"), area_vector);
  check_close("ring outer area", outer, 40. * 2. * 8. * std::sin(angle / 2.) * 2., 1e-10);
  check("ring outer surface closes", open_sides(ring->surfaces.at("outer")) == 80);
  bool        outward = true;
  const auto &surface = ring->surfaces.at("inner");
  for (unsigned int i = 0; i < surface.nodes.size(); ++i)
    outward = outward && surface.normals[i].dot(surface.positions[i]) < -4.9;
  check("ring inner normals point to the axis", outward);
}

void check_cylinder()
{
  const auto   cylinder = make_cylinder(3., 4., {{4, 3, 5}});
  const auto   quality  = compute_mesh_quality(cylinder->triangulation);
  const double angle    = 2. * pi / 16;
  check("cylinder cells", quality.cells == (16 + 48) * 5);
  check_close("cylinder volume", quality.volume, pi * 9. * 4. * std::sin(angle) / angle, 1e-10);
  check("cylinder scaled Jacobian above 0.7", quality.least_scaled_jacobian > .7);
  check("cylinder outer nodes", cylinder->node_sets.at("outer").size() == 16 * 6);
  bool on_axis = cylinder->node_sets.at("axis").size() == 6;
  for (const unsigned int i : cylinder->node_sets.at("axis"))
    {
      const auto &x = cylinder->triangulation.get_vertices()[i];
      on_axis       = on_axis && std::hypot(x[0], x[1]) < round_off;
    }
  check("cylinder axis nodes", on_axis);
}

void check_beam_and_disc()
{
  const auto beam     = make_beam({10., 2., 1.}, {{5, 2, 2}});
  const auto disc     = make_disc(3., .5, {{4, 3, 1}});
  Vector3    beam_sum = Vector3::Zero(), disc_sum = Vector3::Zero();
  for (const auto &x : beam->triangulation.get_vertices())
    beam_sum += Vector3(x[0], x[1], x[2]);
  for (const auto &x : disc->triangulation.get_vertices())
    disc_sum += Vector3(x[0], x[1], x[2]);
  check_below("beam centred on its axis", std::hypot(beam_sum[1], beam_sum[2]), round_off);
  check_below("disc centred on the origin", disc_sum.norm(), round_off);
  check("beam and disc sides",
        beam->surfaces.at("x+").facets.size() == 4 &&
          disc->surfaces.at("outer").facets.size() == 16);
}

double sphere_volume_error(const unsigned int n)
{
  const auto sphere = make_sphere(10., {{n, n}});
  return compute_mesh_quality(sphere->triangulation).volume / (4. / 3. * pi * 1000.) - 1.;
}

void check_sphere()
{
  const auto sphere  = make_sphere(10., {{4, 3}});
  const auto quality = compute_mesh_quality(sphere->triangulation);
  check("sphere cells", quality.cells == 64 + 6 * 16 * 3 && quality.nodes == 125 + 3 * 98);
  check("sphere scaled Jacobian above 0.7", quality.least_scaled_jacobian > .7);
  // Every edge is a chord: the volume is too small by a term of second order.
  check_close("sphere volume: order",
              std::log2(sphere_volume_error(4) / sphere_volume_error(8)),
              2.,
              .05);
  const FacetSurface &outer = sphere->surfaces.at("outer");
  double              off   = 0.;
  for (const Vector3 &x : outer.positions)
    raise_to(off, std::abs(x.norm() - 10.));
  check_below("sphere outer nodes on the sphere", off, round_off);
  check("sphere surface closes", outer.facets.size() == 96 && open_sides(outer) == 0);
  const auto &centre = sphere->triangulation.get_vertices()[sphere->node_sets.at("centre")[0]];
  check_below("sphere centre node", centre.norm(), round_off);
  sphere->triangulation.refine_global(1);
  double off_refined = 0.;
  for (const Vector3 &x : surface_of_boundary(sphere->triangulation, "refined", 1).positions)
    raise_to(off_refined, std::abs(x.norm() - 10.));
  check_below("sphere refined: outer nodes on the sphere", off_refined, round_off);
}

/** Every shape of the table: declared, read, made. */
void check_table()
{
  for (const std::string &shape : PrimitiveOptions::shapes())
    {
      PrimitiveOptions         options(shape);
      dealii::ParameterHandler prm;
      options.declare(prm);
      options.check("Body");
      const auto mesh = make_primitive(options);
      check(shape + " by name",
            mesh->name == shape &&
              compute_mesh_quality(mesh->triangulation).least_scaled_jacobian > .5);
    }
  PrimitiveOptions ring("ring");
  read_entries(ring, "set inner radius = 0.021 m\nset elements around = 12");
  check("entries are read", std::abs(ring.sizes[0] - 21.) < round_off && ring.counts[1] == 12);
  check("refuses an unknown shape", refuses([] { PrimitiveOptions("spher"); }));
  check("refuses an odd core by entry", refuses([] {
          PrimitiveOptions disc("disc");
          disc.counts[0] = 3;
          disc.check("Body");
        }));
  check("refuses radii out of order", refuses([] {
          PrimitiveOptions inside_out("ring");
          inside_out.sizes[0] = 31.;
          inside_out.check("Body");
        }));
}

int main()
{
  check_block();
  check_ring();
  check_cylinder();
  check_beam_and_disc();
  check_sphere();
  check_table();
  check("refuses a flat block", refuses([] { make_block({1., 0., 1.}, {{1, 1, 1}}); }));
  check("refuses no cells", refuses([] { make_block({1., 1., 1.}, {{1, 0, 1}}); }));
  check("refuses a ring inside out", refuses([] { make_ring(2., 1., 1., {{1, 8, 1}}); }));
  check("refuses an odd core", refuses([] { make_cylinder(2., 1., {{3, 1, 1}}); }));
  return 0;
}
