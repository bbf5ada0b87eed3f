// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// One field file read back and compared with closed forms at every point: a ring that turns about
// an axis askew and is strained uniformly, and a block that is.
#include "../made_state.h"
#include "../tests.h"
#include "../vtu_file.h"
#include "ring_askew.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/observers/field_writer.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <filesystem>

using namespace vfife;

const std::string folder_name = "field_values_results";
constexpr double  E = 206000, nu = .3, angle = 2.5, rate = 2000;

/** The displacement H (X - c) before turning, in the fixed frame. Symmetric: no rotation. */
Matrix3 gradient(const unsigned int body)
{
  Matrix3 H;
  if (body == 0)
    H << 3., 1., -2., 1., -5., 4., -2., 4., 2.;
  else
    H << -1., 2., 3., 2., 4., -1., 3., -1., 2.;
  return 1e-5 * H;
}

/** Of that strain, sigma = 2 mu e + lambda tr(e), in the fixed frame before turning [MPa]. */
Matrix3 stress(const unsigned int body)
{
  const Matrix3 e  = gradient(body);
  const double  mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
  return 2 * mu * e + lambda * e.trace() * Matrix3::Identity();
}

Matrix3 turn(const Model &model, const unsigned int body)
{
  return body == 0 ? rotation_about(model.bodies[0].axis.direction, angle)
                   : Matrix3(Matrix3::Identity());
}

// What is left of the ring's velocity: r grows by 300 of itself a second, and it flies by 4 m/s
// along its axis. Neither has a moment about the axis.
constexpr double growth = 300, along = 4000;

/** What a node pushes with [N], of its undeformed place: 5, 6... times its height. */
double force_at(const Vector3 &X)
{
  return 20 + 5 * X[2];
}

Model make_model()
{
  Material material;
  material.youngs_modulus = E;
  material.poissons_ratio = nu;
  return ring_and_block(material, rate);
}

State make_state(const Model &model)
{
  State state = undeformed_state(model);
  for (unsigned int b = 0; b < 2; ++b)
    {
      const Body &body = model.bodies[b];
      RigidMotion motion;
      motion.rotation = turn(model, b) * body.placement.rotation;
      state.body_motion.push_back(motion);
      for (unsigned int i = 0; i < body.n_nodes(); ++i)
        {
          const unsigned int node = body.first_node + i;
          const Vector3     &X    = body.node_positions()[i];
          const Vector3      r    = turn(model, b) * (Matrix3::Identity() + gradient(b)) *
                            (body.placement(X) - body.axis.point);
          const Vector3 &a = body.axis.direction;
          state.position.set(node, body.axis.point + r);
          if (b == 0)
            state.velocity.set(node, rate * a.cross(r) + growth * r + along * a);
          state.contact_force.set(node, force_at(X) / 7 * Vector3(2., -3., 6.));
        }
    }
  state.time = 1e-3;
  state.step = 100;
  state.dt   = 1e-5;
  return state;
}

/** Area of a node of the ring's outer facets, or of the block's side x- [mm^2]; 0 elsewhere. */
double area_at(const unsigned int body, const Vector3 &X)
{
  const auto is = [](const double a, const double b) { return std::abs(a - b) < 1e-3; };
  if (body == 0)
    {
      if (!is(X.head<2>().norm(), 30.))
        return 0;
      // Chords of 15 degrees by 2.5 mm: four facets a node, two at the rims z = 0 and 5.
      const double facet = 2 * 30 * std::sin(pi / 24) * 2.5;
      return is(X[2], 2.5) ? facet : facet / 2;
    }
  if (!is(X[0], 0.))
    return 0;
  // Facets of 1 mm^2 on 3 x 2 mm.
  return (is(X[1], 0.) || is(X[1], 3.) ? .5 : 1.) * (is(X[2], 0.) || is(X[2], 2.) ? .5 : 1.);
}

/** Largest errors over the points, each over the largest size of its field. */
void check_values(const Model &model, const VtuFile &fields)
{
  const char *stress_names[] = {
    "stress r", "stress theta", "stress z", "stress r theta", "stress theta z", "stress z r"};
  const unsigned int    row[] = {0, 1, 2, 0, 1, 2}, column[] = {0, 1, 2, 1, 2, 0};
  double                place = 0, displacement = 0, velocity = 0, mises = 0, pressure = 0;
  std::array<double, 6> stresses = {};
  bool                  teeth    = true;
  unsigned int          carry    = 0;
  double                tensor = 0, principal = 0;
  for (std::size_t i = 0; i < 8 * fields.n_cells(); ++i)
    {
      const std::size_t  p    = fields.corner(i / 8, i % 8);
      const unsigned int b    = fields.cell_number("body", i / 8) < .5 ? 0 : 1;
      const Body        &body = model.bodies[b];
      const Vector3     &a    = body.axis.direction;
      const Matrix3      R = turn(model, b), H = gradient(b);
      // Back to the undeformed place, at which the closed forms are.
      const Vector3 x     = fields.point(p) - body.axis.point,
                    start = (Matrix3::Identity() + H).inverse() * R.transpose() * x, // X - c
        X                 = body.placement.rotation.transpose() *
            (start + body.axis.point - body.placement.translation);
      double nearest = 1e9;
      for (const Vector3 &node : body.node_positions())
        nearest = std::min(nearest, (node - X).norm());
      raise_to(place, nearest);
      raise_to(displacement, (fields.vector("displacement", p) - R * (H * start)).norm() / 1e-3);
      const Vector3 left =
        b == 0 ? Vector3(1e-3 * (growth * x + along * a)) : Vector3(Vector3::Zero());
      raise_to(velocity, (fields.vector("relative velocity", p) - left).norm() / 10.);
      // In the cylindrical axes of the undeformed place.
      Vector3 radial = start - start.dot(a) * a;
      Matrix3 axes;
      axes << radial.normalized(), a.cross(radial.normalized()), a;
      const Matrix3 s = axes.transpose() * stress(b) * axes;
      for (unsigned int c = 0; c < 6; ++c)
        if (radial.norm() > 1e-3) // the block has nodes on its axis
          stresses[c] =
            largest_of(stresses[c],
                       std::abs(fields.number(stress_names[c], p) - s(row[c], column[c])) / 10.);
      // In the fixed frame, turned with the body.
      const Matrix3             now  = R * stress(b) * R.transpose();
      const std::vector<double> here = fields.values("stress", p);
      for (unsigned int c = 0; c < 6; ++c)
        raise_to(tensor, std::abs(here[c] - now(row[c], column[c])) / 10.);
      const Vector3 exact = Eigen::SelfAdjointEigenSolver<Matrix3>(stress(b)).eigenvalues();
      for (unsigned int c = 0; c < 3; ++c)
        raise_to(principal,
                 std::abs(fields.number("principal stress " + std::to_string(c + 1), p) -
                          exact[2 - c]) /
                   10.);
      const Matrix3 deviator =
        stress(b) - stress(b).trace() / 3 * Matrix3::Identity(); // whatever the axes
      mises = largest_of(
        mises, std::abs(fields.number("von mises", p) - std::sqrt(1.5) * deviator.norm()) / 10.);
      const double area = area_at(b, X), expected = area > 0 ? force_at(X) / area : 0.;
      raise_to(pressure, std::abs(fields.number("contact pressure", p) - expected) / 10.);
      carry += area > 0;
      // A point of the ring lies at the border of its sector of 15 degrees.
      const double tooth = fields.cell_number("tooth", i / 8);
      const double from  = std::remainder(std::atan2(X[1], X[0]) - tooth * pi / 12, 2 * pi);
      teeth =
        teeth && (b == 1 ? tooth == 0. : std::min(std::abs(from), std::abs(from - pi / 12)) < 1e-5);
    }
  check("all cells, which share their points",
        fields.n_cells() == model.n_elements() && fields.n_points() == model.n_nodes());
  check("those of both surfaces", carry == 24 * 2 * 4 + 3 * 2 * 4);
  // Single precision: 6e-8 of coordinates of some 40 mm, and of the values.
  check_below("places [mm]", place, 2e-5);
  check_below("displacement, over 1 um", displacement, 1e-5);
  check_below("relative velocity, over 10 m/s", velocity, 1e-6);
  for (unsigned int c = 0; c < 6; ++c)
    check_below(std::string(stress_names[c]) + ", over 10 MPa", stresses[c], 1e-6);
  check_below("stress in the fixed frame, over 10 MPa", tensor, 1e-6);
  check_below("principal stresses, over 10 MPa", principal, 1e-6);
  check_below("von mises, over 10 MPa", mises, 1e-6);
  check_below("contact pressure, over 10 MPa", pressure, 1e-6);
  check("teeth", teeth);
  check("names with units",
        fields.unit("displacement") == " [mm]" && fields.unit("relative velocity") == " [m/s]" &&
          fields.unit("stress") == " [MPa]" && fields.unit("contact pressure") == " [MPa]");
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all(folder_name);
  const OutputFolder folder(folder_name, session.world());
  const Model        model = make_model();
  const State        state = make_state(model);
  FieldWriter        writer(
    folder, model, FieldFormat::vtu, 50, StiffnessKind::incompatible_modes, FrameKind::polar);
  writer.observe(model, state);
  check_values(model, VtuFile(folder.file("fields/00000.vtu")));
  return 0;
}
