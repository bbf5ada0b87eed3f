// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies: masses and inertia of the lumped masses, node sets, areas of nodes, boundary faces, axes
// and displacements in the body frame, numbering in a model.
#include "../model_parts.h"
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/contact/surface/facet_integrals.h>
#include <vfife/contact/surface/facet_quadrature.h>
#include <vfife/element/hexahedron.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/load_shares.h>

using namespace vfife;

constexpr double density = 7.85e-9;

/** Of a cross-section of n cells of h: the trapezoidal rule of x^2 about the middle, over the
 * length. */
double lumped_square(const double length, const unsigned int n)
{
  const double h = length / n;
  return length * length / 12 + h * h / 6;
}

void masses()
{
  Body         body("block", make_block(Vector3(4., 6., 9.), {{2, 3, 9}}), Material());
  const double mass = density * 4 * 6 * 9;
  check("block: nodes and elements", body.n_nodes() == 3 * 4 * 10 && body.n_elements() == 54);
  check_ratio("block: mass", body.mass() / mass, 1e-13);
  check_ratio("block: sum of nodal masses", sum_of(body.node_masses()) / mass, 1e-13);
  const auto ends = std::minmax_element(body.node_masses().begin(), body.node_masses().end());
  check_close("block: corner over element", *ends.first / (density * 4), 1. / 8, 1e-14);
  check_ratio("block: inner node over element", *ends.second / (density * 4), 1e-14);

  body.axis              = {Vector3(2., 3., 0.), Vector3::UnitZ()};
  const double about_own = mass * (lumped_square(4., 2) + lumped_square(6., 3));
  check_ratio("block: inertia about its own axis", body.axial_inertia() / about_own, 1e-13);
  body.axis.point = Vector3(2. + 30., 3. - 40., 5.);
  check_ratio("block: inertia about a parallel axis",
              body.axial_inertia() / (about_own + mass * 2500.),
              1e-13);
  // The axis is one of the fixed frame: it goes along with the placement.
  body.placement.rotation    = rotation_about(Vector3(1., 2., 3.).normalized(), .7);
  body.placement.translation = Vector3(10., 20., -30.);
  body.axis = {body.placement(Vector3(2., 3., 1.)), body.placement.rotation.col(2)};
  check_ratio("block: inertia where it is placed", body.axial_inertia() / about_own, 1e-12);

  std::vector<double> more(body.n_nodes(), 0.);
  more[7] = .25 * mass;
  more[0] = .05 * mass;
  body.add_masses(more);
  check_close("added mass", body.added_mass() / mass, .3, 1e-14);
  check_close("mass with it", body.mass() / mass, 1.3, 1e-13);
  check_close("sum of nodal masses with it", sum_of(body.node_masses()) / mass, 1.3, 1e-13);

  for (unsigned int source = 0; source < 2; ++source)
    body.add_initial_strains(std::vector<double>(body.n_elements(), 1e-3));
  check_close("initial strains of two sources", body.initial_strain(5), 2e-3, 0.);
}

/** The cells of a ring are chords: volume and areas are those of the polygons. */
constexpr double       inner = 20, outer = 30, height = 8;
constexpr unsigned int around = 48;

Body ring()
{
  return {"ring", make_ring(inner, outer, height, {{2, around, 3}}), Material()};
}

void areas()
{
  const Body   body   = ring();
  const double half   = pi / around;
  const double volume = around * .5 * std::sin(2 * half) * (outer * outer - inner * inner) * height;
  check_ratio("ring: mass", body.mass() / (density * volume), 1e-12);

  const double chord = 2 * outer * std::sin(half);
  const auto  &nodes = body.node_set("outer");
  const auto   of    = compute_nodal_areas(body, nodes);
  check_ratio("ring: area outside", sum_of(of) / (around * chord * height), 1e-12);
  bool right = true;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      const double z    = body.node_positions()[nodes[i]][2];
      const double part = std::abs(z) < 1e-9 || std::abs(z - height) < 1e-9 ? .5 : 1.;
      right             = right && std::abs(of[i] / (part * chord * height / 3) - 1) < 1e-12;
    }
  check("ring: area of each node outside", right);
  check_ratio("ring: area above",
              sum_of(compute_nodal_areas(body, body.node_set("top"))) / (volume / height),
              1e-12);
  const std::vector<unsigned int> all = all_nodes(body);
  const double whole = 2 * volume / height + around * 2 * (outer + inner) * std::sin(half) * height;
  check_ratio("ring: all of its surface", sum_of(compute_nodal_areas(body, all)) / whole, 1e-12);

  // Faces count only where all four nodes are in the set.
  std::vector<unsigned int> lower;
  for (const unsigned int node : nodes)
    if (body.node_positions()[node][2] < .5 * height)
      lower.push_back(node);
  check_ratio("ring: area of the rows of nodes below the middle",
              sum_of(compute_nodal_areas(body, lower)) / (around * chord * height / 3),
              1e-12);
  const auto line = compute_nodal_areas(body, {nodes[0], nodes[1]});
  check("two nodes carry no face", line == std::vector<double>({0., 0.}));
}

Vector3 vector_area(const std::array<Vector3, 4> &corners)
{
  const auto normals = integrate_normals(corners);
  return normals[0] + normals[1] + normals[2] + normals[3];
}

/** A cell with warped faces: the divergence of x is 3, that of a constant and of a rotation is
 * nothing. */
void warped_cell()
{
  auto mesh = make_block(Vector3(2., 3., 1.5), {{1, 1, 1}});
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    for (unsigned int v = 0; v < 8; ++v)
      for (unsigned int c = 0; c < 3; ++c)
        cell->vertex(v)[c] += .3 * std::sin(12.9898 * (v + 1) + 78.233 * c);
  const Body                      body("cell", std::move(mesh), Material());
  const std::vector<unsigned int> all     = {0, 1, 2, 3, 4, 5, 6, 7};
  double                          outflow = 0;
  Vector3                         force = Vector3::Zero(), moment = Vector3::Zero();
  for (const BoundaryFace &face : find_boundary_faces(body, all))
    {
      std::array<Vector3, 4> x;
      for (unsigned int k = 0; k < 4; ++k)
        x[k] = body.node_positions()[face.nodes[k]];
      const auto normals = integrate_normals(x);
      for (unsigned int k = 0; k < 4; ++k)
        {
          outflow += x[k].dot(normals[k]);
          force += normals[k];
          moment += x[k].cross(normals[k]);
        }
    }
  check_ratio("warped cell: outflow of x over three volumes",
              outflow / (3 * compute_volume(body.element_nodes(0))),
              1e-13);
  check_below("warped cell: even pressure leaves no force [N]", force.norm(), 1e-13);
  check_below("warped cell: and no moment [N mm]", moment.norm(), 1e-13);
  // A plane face with unequal sides: the corner's share by hand, (4 J0 + 2 J1 + 2 J3 + J2)/36
  // with J = 6, 3, 3, 0 at corners in turn.
  const auto areas =
    integrate_areas({{Vector3(0, 0, 0), Vector3(3, 0, 0), Vector3(1.5, 1, 0), Vector3(0, 2, 0)}});
  check_close("uneven face: the corner at the right angle",
              areas[0],
              (4 * 6 + 2 * 3 + 2 * 3) / 36.,
              1e-14);
  check_close("uneven face: all of its area", areas[0] + areas[1] + areas[2] + areas[3], 3., 1e-14);
}

void faces()
{
  const Body   body   = ring();
  Vector3      total  = Vector3::Zero();
  double       volume = 0;
  unsigned int n      = 0;
  for (const BoundaryFace &face : find_boundary_faces(body, all_nodes(body)))
    {
      std::array<Vector3, 4> x;
      for (unsigned int i = 0; i < 4; ++i)
        x[i] = body.node_positions()[face.nodes[i]];
      const Vector3 area = vector_area(x);
      total += area;
      volume += area.dot(x[0] + x[1] + x[2] + x[3]) / 12; // divergence of x/3
      ++n;
    }
  check("faces of the whole boundary", n == around * 2 * (2 + 3));
  check_below("their vector areas sum to nothing [mm^2]", total.norm(), 1e-10);
  check_ratio("and enclose the body", volume / (body.mass() / density), 1e-12);

  // Pressure on half of the curved face, to both sides of + x: p times the projected area.
  std::vector<unsigned int> half;
  for (const unsigned int node : body.node_set("outer"))
    if (body.node_positions()[node][0] > -1e-9)
      half.push_back(node);
  Vector3 resultant = Vector3::Zero();
  for (const BoundaryFace &face : find_boundary_faces(body, half))
    {
      const auto &x = body.node_positions();
      resultant -=
        vector_area({{x[face.nodes[0]], x[face.nodes[1]], x[face.nodes[2]], x[face.nodes[3]]}});
    }
  check_close("pressure on a half: along - x", resultant[0], -2 * outer * height, 1e-10);
  check_below("pressure on a half: across", resultant.tail<2>().norm(), 1e-10);
  // A warped face: the mean of both ways to cut it into triangles.
  const Vector3 a(0., 0., 0.), b(2., 0., .3), c(2.5, 1.5, 0.), d(0., 1., .4);
  const Vector3 first  = .5 * ((b - a).cross(c - a) + (c - a).cross(d - a));
  const Vector3 second = .5 * ((b - a).cross(d - a) + (c - b).cross(d - b));
  check_below("warped face: vector area by either diagonal [mm^2]",
              largest_of((vector_area({{a, b, c, d}}) - first).norm(),
                         (vector_area({{a, b, c, d}}) - second).norm()),
              1e-14);
}

void sets()
{
  const Body body("bar", make_block(Vector3(1., 1., 1.), {{1, 2, 3}}), Material());
  check("sides", body.node_set("x+").size() == 12 && body.node_set("z-").size() == 6);
  check("what is there", body.has_node_set("y-") && !body.has_node_set("top"));
  for (const char *name : {"z", "outer"})
    print_refusal([&] { body.node_set(name); });
  // A node of the last element pushed through the opposite side.
  auto mesh = make_block(Vector3(3., 1., 1.), {{3, 1, 1}});
  std::next(mesh->triangulation.begin_active(), 2)->vertex(1) = dealii::Point<3>(1., 0., 0.);
  print_refusal([&] { Body("bent", std::move(mesh), Material()); });
  auto refined = make_block(Vector3(3., 1., 1.), {{3, 1, 1}});
  refined->triangulation.begin_active()->set_refine_flag();
  refined->triangulation.execute_coarsening_and_refinement();
  print_refusal([&] { Body("refined", std::move(refined), Material()); });
}

void axes()
{
  Body body                  = ring();
  body.placement.rotation    = rotation_about(Vector3(0., 1., 1.).normalized(), 1.1);
  body.placement.translation = Vector3(5., -7., 11.);
  body.axis           = {body.placement(Vector3(0., 0., 3.)), body.placement.rotation.col(2)};
  const double  angle = .4;
  const Vector3 X(25. * std::cos(angle), 25. * std::sin(angle), 6.);
  const Matrix3 found = compute_cylindrical_axes(body, X);
  Matrix3       exact;
  exact << std::cos(angle), -std::sin(angle), 0., std::sin(angle), std::cos(angle), 0., 0., 0., 1.;
  check_below("axes r, theta, z of a point", (found - exact).norm(), 1e-14);
  const Matrix3 on_axis = compute_cylindrical_axes(body, Vector3(0., 0., 100.));
  check("on the axis: some r, right-handed about z",
        (on_axis.transpose() * on_axis - Matrix3::Identity()).norm() < 1e-14 &&
          (on_axis.col(2) - Vector3::UnitZ()).norm() < 1e-14 && on_axis.determinant() > 0);

  // Turned by 3 rad, then stretched by 1 um along r of the body.
  const unsigned int node = 77;
  const Vector3      X0   = body.node_positions()[node];
  const Vector3      r    = Vector3(X0[0], X0[1], 0.).normalized();
  const Matrix3      turn = rotation_about(body.axis.direction, 3.);
  RigidMotion        now;
  now.rotation        = turn * body.placement.rotation;
  const Vector3 x     = body.axis.point + turn * (body.placement(X0 + 1e-3 * r) - body.axis.point);
  body.turns_on_axis  = true;
  const Vector3 left  = compute_displacement(body, node, x, compute_turn(body, now));
  body.turns_on_axis  = false;
  const Vector3 whole = compute_displacement(body, node, x, compute_turn(body, now));
  check_below("in bearings: what is left in the turning body [mm]",
              (left - 1e-3 * (body.placement.rotation * r)).norm(),
              1e-13);
  check_below("free: the whole way [mm]", (whole - (x - body.placement(X0))).norm(), 1e-13);
}

void numbering()
{
  Model model;
  check("an empty model", model.n_nodes() == 0 && model.n_elements() == 0);
  const unsigned int first =
    model.add_body({"first", make_block(Vector3(1., 1., 1.), {{2, 1, 1}}), Material()});
  const unsigned int second = model.add_body(ring());
  check("bodies in turn", first == 0 && second == 1 && model.bodies[1].name() == "ring");
  check("nodes and elements follow each other",
        model.bodies[0].first_node == 0 && model.bodies[1].first_node == 12 &&
          model.bodies[1].first_element == 2 && model.n_nodes() == 12 + 3 * 4 * around &&
          model.n_elements() == 2 + 2 * 3 * around);
}

int main()
{
  return run_parts({masses, areas, warped_cell, faces, sets, axes, numbering});
}
