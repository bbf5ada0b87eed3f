// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Linear statics: patch test, order of convergence, spin and torque against closed forms, messages.
#include "../model_parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/fem/system/system_matrices.h>
#include <vfife/mesh/primitives/primitives.h>

#include <deal.II/grid/grid_tools.h>

#include <set>

using namespace vfife;

using Field = std::function<Vector3(const Vector3 &)>;

/** Moves inner vertices by @p part of the cell size, without pattern. */
void distort(BodyMesh &mesh, const double h, const double part)
{
  std::set<unsigned int> kept;
  for (const auto &vertex : dealii::GridTools::get_all_vertices_at_boundary(mesh.triangulation))
    kept.insert(vertex.first);
  for (const auto &cell : mesh.triangulation.active_cell_iterators())
    for (unsigned int v = 0; v < 8; ++v)
      if (kept.insert(cell->vertex_index(v)).second)
        for (unsigned int c = 0; c < 3; ++c)
          cell->vertex(v)[c] +=
            part * h * std::sin(12.9898 * (cell->vertex_index(v) + 1) + 78.233 * c);
}

Model make_block_model(const unsigned int n, const double distortion, const Material &material)
{
  Model model;
  auto  mesh = make_block(Vector3(2., 1.5, 1.), {{n, n, n}});
  distort(*mesh, 1. / n, distortion);
  model.add_body(Body("block", std::move(mesh), material));
  return model;
}

std::vector<unsigned int> boundary_nodes(const Body &body)
{
  std::set<unsigned int> nodes;
  for (const char *side : {"x-", "x+", "y-", "y+", "z-", "z+"})
    nodes.insert(body.node_set(side).begin(), body.node_set(side).end());
  return {nodes.begin(), nodes.end()};
}

FemOptions make_options(const FemElement element, const LinearSolverKind solver)
{
  FemOptions options;
  options.element          = element;
  options.linear_solver    = solver;
  options.linear_tolerance = 1e-12;
  return options;
}

/**
 * A linear field on a distorted mesh: forces at inner points vanish, stresses at all points are
 * the constant ones.
 */
void patch_test(const FemElement element, const Communicator &communicator)
{
  const Model     model = make_block_model(3, .15, {});
  const FemSpace  d(model, {0}, element);
  const FemSystem system(d, {}, communicator);
  Matrix3         gradient;
  gradient << 1e-3, 2e-4, -3e-4, 5e-4, -4e-4, 1e-4, 2e-4, 6e-4, 7e-4;
  std::vector<double> u;
  for (const Vector3 &x : d.points())
    for (unsigned int c = 0; c < 3; ++c)
      u.push_back(gradient.row(c).dot(x));

  const OwnedVector         own    = system.vector([&](const unsigned int e) -> Eigen::VectorXd {
    return compute_fem_stiffness(d.element_nodes(e), d.material(e), element) * d.gather(e, u);
  });
  const std::vector<double> forces = system.expand(own);
  double                    inner = 0, largest = 0;
  for (unsigned int p = 0; p < d.n_points(); ++p)
    {
      const Vector3 x = d.points()[p];
      const bool    on_border =
        x.minCoeff() < 1e-9 || x[0] > 2. - 1e-9 || x[1] > 1.5 - 1e-9 || x[2] > 1. - 1e-9;
      for (unsigned int c = 0; c < 3; ++c)
        {
          raise_to(largest, std::abs(forces[3 * p + c]));
          if (!on_border)
            raise_to(inner, std::abs(forces[3 * p + c]));
        }
    }
  const Matrix3 strain = .5 * (gradient + gradient.transpose());
  Stress        exact;
  exact << strain(0, 0), strain(1, 1), strain(2, 2), 2 * strain(0, 1), 2 * strain(1, 2),
    2 * strain(2, 0);
  exact            = compute_elasticity(d.material(0)) * exact;
  double deviation = 0;
  for (unsigned int e = 0; e < d.n_elements(); ++e)
    raise_to(deviation,
             (compute_point_stresses(d.element_nodes(e), d.material(e), element, d.gather(e, u))
                .colwise() -
              exact)
               .cwiseAbs()
               .maxCoeff());
  const std::string name = word_of(element, fem_element_choices());
  // Round-off of sums of some hundred terms.
  check_below("patch test, forces inside, " + name, inner / largest, 1e-12);
  check_below("patch test, stresses, " + name, deviation / exact.norm(), 1e-12);
}

/** u = (1, 2, -1) s(x), s a product of sines that vanishes on the border. */
Vector3 manufactured(const Vector3 &x)
{
  const double s = std::sin(pi * x[0] / 2.) * std::sin(pi * x[1] / 1.5) * std::sin(pi * x[2]);
  return 1e-3 * s * Vector3(1., 2., -1.);
}

/** -div sigma of it, with a = 1e-3 (1, 2, -1): -(mu laplace(u) + (lambda + mu) grad div u). */
Vector3 manufactured_force(const Vector3 &x, const Material &material)
{
  const Vector3 k(pi / 2., pi / 1.5, pi), a = 1e-3 * Vector3(1., 2., -1.);
  Vector3       s, c;
  for (unsigned int d = 0; d < 3; ++d)
    {
      s[d] = std::sin(k[d] * x[d]);
      c[d] = std::cos(k[d] * x[d]);
    }
  const double value = s.prod();
  Matrix3      second; // of s
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      second(i, j) = i == j ? -k[i] * k[i] * value : k[i] * k[j] * c[i] * c[j] * s[3 - i - j];
  return material.mu() * k.squaredNorm() * value * a -
         (material.lambda() + material.mu()) * (second * a);
}

double error_of(const unsigned int  n,
                const FemElement    element,
                const double        distortion,
                const Communicator &communicator)
{
  Model model = make_block_model(n, distortion, {});
  model.constraints.push_back({"border", ConstraintKind::held, 0, boundary_nodes(model.bodies[0])});
  const StaticSolver solver(model,
                            {0},
                            make_options(element, LinearSolverKind::multigrid),
                            communicator);
  StaticLoads        loads;
  loads.body_force = [&](const Vector3 &x) {
    return manufactured_force(x, model.bodies[0].materials().front());
  };
  const StaticResult result = solver.solve(loads);
  const FemSpace    &d      = solver.space();
  double             square = 0, reference = 0;
  for (unsigned int e = 0; e < d.n_elements(); ++e)
    {
      const Eigen::VectorXd                u = d.gather(e, result.displacements);
      const ElementNodes                   X = d.element_nodes(e);
      const Eigen::Map<const ElementNodes> columns(u.data(), 3, X.cols());
      for (const ElementPoint &point : compute_element_points(X))
        {
          const Vector3 exact = manufactured(X * point.N);
          square += point.weight * (columns * point.N - exact).squaredNorm();
          reference += point.weight * exact.squaredNorm();
        }
    }
  return std::sqrt(square / reference);
}

void convergence(const Communicator &communicator)
{
  for (const auto &choice : fem_element_choices())
    {
      const unsigned int degree = degree_of(choice.second), n = 5 - degree;
      const double       coarse = error_of(n, choice.second, .15, communicator);
      const double       fine   = error_of(2 * n, choice.second, .15, communicator);
      // One more than the degree; 0.3 for the coarse meshes.
      check_close("order of convergence, " + choice.first,
                  std::log2(coarse / fine),
                  degree + 1.,
                  .3);
    }
}

/** Code_Aster SSLV104: a bar that turns about one end. */
void spinning_bar(const Communicator &communicator)
{
  Material steel;
  steel.density        = 7.8e-9;
  steel.youngs_modulus = 2e5;
  steel.poissons_ratio = 0.;
  Model model = model_of(Body("bar", make_block(Vector3(500., 10., 10.), {{50, 1, 1}}), steel));
  Body &bar   = model.bodies[0];
  bar.rate    = 3000.;
  model.constraints.push_back({"end", ConstraintKind::held, 0, bar.node_set("x-")});
  bar.axis.point = Vector3(0., 5., 5.);
  // Held straight: without stress stiffness the spin would bend it sideways.
  model.constraints.push_back(hold(all_nodes(bar), {{false, true, true}}));
  for (const LinearSolverKind kind : {LinearSolverKind::multigrid, LinearSolverKind::direct})
    {
      const StaticSolver solver(model,
                                {0},
                                make_options(FemElement::incompatible_modes, kind),
                                communicator);
      StaticLoads        loads;
      loads.centrifugal         = true;
      const unsigned int tip    = bar.node_set("x+").front();
      const double       linear = solver.solve(loads).displacements[3 * tip];
      loads.spin_softening      = true;
      const double softened     = solver.solve(loads).displacements[3 * tip];
      // rho omega^2 L^3/(3 E) = 14.625 mm; with the load on the moved mass L (tan kL/kL - 1)
      // = 15.1572 mm (k = omega sqrt(rho/E)); 50 linear elements: (kL)^2/(12 50^2) = 4e-6 of it.
      check_close("spinning bar, linear [mm]", linear, 14.625, 2e-4);
      check_close("spinning bar, load on the moved mass [mm]", softened, 15.1572, 3e-4);
    }

  model.constraints.pop_back();
  const StaticSolver loose(model,
                           {0},
                           make_options(FemElement::incompatible_modes, LinearSolverKind::direct),
                           communicator);
  StaticLoads        loads;
  loads.centrifugal = loads.spin_softening = true;
  print_refusal<NumericalError>([&] { loose.solve(loads); });
  loads.stress_stiffness = true;
  // Its stresses keep it straight. Linear in turned axes it stretches as above; with Green's
  // strain d/dx[E (1 + e)(e + e^2/2)] + rho omega^2 (x + u) = 0, e = u' (Runge and Kutta, 5000
  // steps).
  for (const StrainMeasure strain : {StrainMeasure::biot, StrainMeasure::green})
    {
      FemOptions options = make_options(FemElement::incompatible_modes, LinearSolverKind::direct);
      options.strain     = strain;
      const StaticSolver solver(model, {0}, options, communicator);
      check_close("spinning bar under its own stresses [mm]",
                  solver.solve(loads).displacements[3 * bar.node_set("x+").front()],
                  strain == StrainMeasure::biot ? 15.1572 : 14.37934,
                  5e-4);
    }
}

/** Torsion of a ring between a free rotation under torque and a held face. */
void torsion(const Communicator &communicator)
{
  Model       model = model_of(Body("tube", make_ring(20., 22., 60., {{2, 48, 12}}), {}));
  const Body &tube  = model.bodies[0];
  model.constraints.push_back({"bottom", ConstraintKind::held, 0, tube.node_set("bottom")});
  const Torque torque = torque_on(model, "top", 1e5);
  model.torques.push_back(torque);
  const unsigned int node  = torque.nodes.front();
  const double       shear = tube.materials().front().mu();
  // Polar moment of the polygon that the mesh is: that of the ring times its area's ratio, within
  // a few 1e-3 for 48 sides.
  const double exact = 1e5 * 60. / (shear * pi / 2. * (std::pow(22., 4) - std::pow(20., 4)));
  for (const ConstraintKind kind : {ConstraintKind::free_rotation, ConstraintKind::rigid_hub})
    {
      model.constraints.resize(1);
      model.constraints.push_back({"top", kind, 0, torque.nodes});
      for (const LinearSolverKind solver_kind :
           {LinearSolverKind::multigrid, LinearSolverKind::direct})
        {
          const StaticSolver solver(model,
                                    {0},
                                    make_options(FemElement::incompatible_modes, solver_kind),
                                    communicator);
          const StaticResult result = solver.solve({});
          const Vector3      x      = tube.node_positions()[node];
          const double       angle =
            (x[0] * result.displacements[3 * node + 1] - x[1] * result.displacements[3 * node]) /
            x.head<2>().squaredNorm();
          check_ratio("torsion, angle", angle / exact, 1e-2);
        }
    }
}

/** A torque on a face with a node on the axis, which has no tangent there, whatever round-off of
 * the placement makes of its arm. */
void torque_on_axis()
{
  Model model                = model_of(Body("bar", make_cylinder(8., 20., {{4, 1, 2}}), {}));
  Body &bar                  = model.bodies[0];
  bar.placement.rotation     = rotation_about(Vector3(1., 2., 2.).normalized(), 1.3);
  bar.placement.translation  = Vector3(50., -20., 10.);
  bar.axis                   = {bar.placement.translation, bar.placement.rotation.col(2)};
  Torque              torque = torque_on(model, "top", 1e5);
  const FemSpace      space(model, {0}, FemElement::incompatible_modes);
  std::vector<double> forces(3 * space.n_points(), 0.);
  add_torque_forces(torque, space, space.parts()[0], torque.value, forces);
  Vector3 sum = Vector3::Zero(), moment = Vector3::Zero();
  for (unsigned int i = 0; i < bar.n_nodes(); ++i)
    {
      const Vector3 force(forces[3 * i], forces[3 * i + 1], forces[3 * i + 2]);
      sum += force;
      moment += (bar.placement(bar.node_positions()[i]) - bar.axis.point).cross(force);
    }
  check_below("torque on a full face: no resultant [N]", sum.norm(), 1e-8);
  check_close("its moment [N mm]", moment.dot(bar.axis.direction), 1e5, 1e-6);
  torque.nodes = bar.node_set("axis");
  torque.areas.assign(torque.nodes.size(), 1.);
  print_refusal([&] { add_torque_forces(torque, space, space.parts()[0], torque.value, forces); });
}

/** A block whose nodes are shifted in the planes z = const, the same way in all of them. */
Model make_uneven_block(const Material &material)
{
  auto                   mesh = make_block(Vector3(2., 1.5, 1.), {{3, 3, 2}});
  std::set<unsigned int> moved;
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    for (unsigned int v = 0; v < 8; ++v)
      if (auto &x = cell->vertex(v); moved.insert(cell->vertex_index(v)).second)
        {
          const double way = .12 * std::sin(pi * x[0] / 2.) * std::sin(pi * x[1] / 1.5);
          const double i = std::round(1.5 * x[0]), j = std::round(2. * x[1]);
          x[0] += way * std::sin(12.9898 * (i + 1) + 78.233 * j);
          x[1] += way * std::sin(39.425 * (j + 2) + 11.137 * i);
        }
  return model_of(Body("block", std::move(mesh), material));
}

/** Largest difference between what a load does and what holds the field @p u, at points above
 * the foot, over the largest force. */
double imbalance(const Model        &model,
                 const Load         &load,
                 const FemElement    element,
                 const Communicator &communicator,
                 const Field        &field)
{
  const FemSpace      d(model, {0}, element);
  const FemSystem     system(d, {}, communicator);
  std::vector<double> u, applied(3 * d.n_points(), 0.);
  for (const Vector3 &x : d.points())
    for (unsigned int c = 0; c < 3; ++c)
      u.push_back(field(x)[c]);
  const OwnedVector         own    = system.vector([&](const unsigned int e) -> Eigen::VectorXd {
    return compute_fem_stiffness(d.element_nodes(e), d.material(e), element) * d.gather(e, u);
  });
  const std::vector<double> forces = system.expand(own);
  add_load_forces(load, d, d.parts().front(), 1., applied);
  double difference = 0, largest = 0;
  for (unsigned int p = 0; p < d.n_points(); ++p)
    for (unsigned int c = 0; c < 3; ++c)
      {
        raise_to(largest, std::abs(forces[3 * p + c]));
        if (d.points()[p][2] > 1e-9)
          raise_to(difference, std::abs(forces[3 * p + c] - applied[3 * p + c]));
      }
  return difference / largest;
}

/** Even loads on uneven faces leave the fields that hold them in equilibrium. */
void uneven_faces(const Communicator &communicator)
{
  Material steel;
  steel.poissons_ratio = 0.;
  const double E = steel.youngs_modulus, rho = steel.density, g = 9810., p = 100.;
  const Model  model = make_uneven_block(steel);
  const Body  &block = model.bodies[0];
  for (const auto &choice : fem_element_choices())
    {
      Load        load    = pressure_on(block.node_set("z+"), p);
      const Field pressed = [&](const Vector3 &x) { return Vector3(0, 0, -p / E * x[2]); };
      check_below("uneven face under pressure, " + choice.first,
                  imbalance(model, load, choice.second, communicator, pressed),
                  1e-12);
      load.kind   = LoadKind::force;
      load.vector = Vector3(0., 0., -p * 2. * 1.5);
      check_below("uneven face under a force, " + choice.first,
                  imbalance(model, load, choice.second, communicator, pressed),
                  1e-12);
    }
  // Under its own weight the way is quadratic, which elements with 27 nodes have.
  Load weight;
  weight.name   = "weight";
  weight.kind   = LoadKind::acceleration;
  weight.vector = Vector3(0., 0., -g);
  weight.nodes  = all_nodes(block);
  check_below("uneven block under its own weight, quadratic",
              imbalance(model,
                        weight,
                        FemElement::quadratic,
                        communicator,
                        [&](const Vector3 &x) {
                          return Vector3(0, 0, -rho * g / E * (x[2] - .5 * x[2] * x[2]));
                        }),
              1e-12);
}

void free_body(const Communicator &communicator)
{
  Model model = make_block_model(2, 0., {});
  model.constraints.push_back(
    {"hub", ConstraintKind::free_rotation, 0, model.bodies[0].node_set("z-")});
  print_refusal([&] { const StaticSolver solver(model, {0}, {}, communicator); });
}

int main(int argc, char **argv)
{
  MpiSession          session(argc, argv);
  const Communicator &communicator = session.world();
  for (const auto &choice : fem_element_choices())
    patch_test(choice.second, communicator);
  convergence(communicator);
  spinning_bar(communicator);
  torsion(communicator);
  torque_on_axis();
  uneven_faces(communicator);
  free_body(communicator);
  return 0;
}
