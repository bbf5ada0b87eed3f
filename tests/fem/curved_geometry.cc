// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Quadratic and cubic elements whose edges and faces follow the true surfaces.
#include "../model_parts.h"
#include "../ranks.h"
#include "../reduced/whole_body.h"
#include "../refusal.h"

#include <vfife/fem/modes/rotating_body.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/fem/system/load_forces.h>

#include <deal.II/grid/manifold.h>

using namespace vfife;

constexpr double inner = 20., outer = 40.;

Model make_ring_model(const unsigned int n)
{
  return model_of(Body("ring", make_ring(inner, outer, 5., {{n / 4, n, 1}}), {}));
}

double volume_of(const FemSpace &space)
{
  double volume = 0;
  for (unsigned int e = 0; e < space.n_elements(); ++e)
    for (const ElementPoint &point : compute_element_points(space.element_nodes(e)))
      volume += point.weight;
  return volume;
}

/** A face through degree + 1 Lobatto points of a circle has its area right to h^(2 degree). */
void volume_of_ring()
{
  const double exact = pi * (outer * outer - inner * inner) * 5.;
  for (const FemElement element : {FemElement::quadratic, FemElement::cubic})
    {
      const unsigned int degree = degree_of(element);
      double             error[2];
      for (const unsigned int times : {1u, 2u})
        {
          const Model model = make_ring_model(8 * times);
          error[times - 1] =
            volume_of(FemSpace(model, {0}, {element, FemGeometry::curved})) / exact - 1.;
        }
      check_close("volume of a ring, order with degree " + std::to_string(degree),
                  std::log2(error[0] / error[1]),
                  2. * degree,
                  .15);
    }
  const double straight = volume_of(FemSpace(make_ring_model(16), {0}, FemElement::cubic)) / exact;
  check_close("straight: the volume of the polygon", straight, 8. / pi * std::sin(pi / 8.), 1e-12);
}

/** Work of the pressure inside Lame's ring, free at its ends: plane stress [N mm]. */
double work_of_pressure(const unsigned int  n,
                        const FemElement    element,
                        const FemGeometry   geometry,
                        const Communicator &communicator)
{
  Model       model = make_ring_model(n);
  const Body &ring  = model.bodies[0];
  const Load  load  = pressure_on(ring.node_set("inner"), 100.);
  model.loads.push_back(load);
  for (const unsigned int direction : {0u, 1u})
    {
      std::vector<unsigned int> nodes;
      for (unsigned int i = 0; i < ring.n_nodes(); ++i)
        if (std::abs(ring.node_positions()[i][direction]) < 1e-9)
          nodes.push_back(i);
      model.constraints.push_back(hold(nodes, {{direction == 0, direction == 1, false}}));
    }
  model.constraints.push_back(hold(ring.node_set("bottom"), {{false, false, true}}));
  FemOptions options;
  options.element       = element;
  options.geometry      = geometry;
  options.linear_solver = LinearSolverKind::direct;
  const StaticSolver  solver(model, {0}, options, communicator);
  const StaticResult  result = solver.solve({});
  std::vector<double> forces(result.displacements.size(), 0.);
  add_load_forces(load, solver.space(), solver.space().parts()[0], 1., forces);
  return std::inner_product(forces.begin(), forces.end(), result.displacements.begin(), 0.);
}

void pressed_ring(const Communicator &communicator)
{
  const Material steel;
  const double   square = outer * outer + inner * inner, less = outer * outer - inner * inner;
  const double   widening =
    100. * inner / steel.youngs_modulus * (square / less + steel.poissons_ratio);
  const double exact = 100. * 2. * pi * inner * 5. * widening;
  const auto   error = [&](const unsigned int n, const FemElement element, const FemGeometry kind) {
    return std::abs(work_of_pressure(n, element, kind, communicator) / exact - 1.);
  };
  for (const FemElement element : {FemElement::quadratic, FemElement::cubic})
    {
      const double coarse = error(16, element, FemGeometry::curved),
                   fine   = error(32, element, FemGeometry::curved);
      // Work is as the square of the energy's norm, of degree's order.
      check_close("pressed ring, order with " + word_of(element, fem_element_choices()),
                  std::log2(coarse / fine),
                  2. * degree_of(element),
                  .4);
    }
  // The chords of 16 sides, whatever the degree.
  check("pressed ring: straight edges are a hundred times as far off",
        error(16, FemElement::quadratic, FemGeometry::straight) >
          100. * error(16, FemElement::quadratic, FemGeometry::curved));
}

/** Fields of constant gradient on the curved pinion: forces inside vanish, and a rotation has no
 * forces at all. */
void patch_test(const Communicator &communicator)
{
  const Model model = make_pinion(ConstraintKind::free_rotation, 0., communicator);
  for (const FemElement element : {FemElement::quadratic, FemElement::cubic})
    {
      const FemSpace space = FemSpace::sector_of(model, 0, {element, FemGeometry::curved});
      Matrix3        gradient, spin;
      gradient << 1e-3, 2e-4, -3e-4, 5e-4, -4e-4, 1e-4, 2e-4, 6e-4, 7e-4;
      spin << 0., -1e-3, 2e-3, 1e-3, 0., -5e-4, -2e-3, 5e-4, 0.;
      double deviation = 0, forces = 0;
      for (unsigned int e = 0; e < space.n_elements(); ++e)
        {
          const ElementNodes    X = space.element_nodes(e);
          const ElementNodes    u = gradient * X, turn = spin * X;
          const Eigen::VectorXd v        = Eigen::Map<const Eigen::VectorXd>(u.data(), u.size());
          const auto            stresses = compute_point_stresses(X, space.material(e), element, v);
          raise_to(deviation,
                   (stresses.colwise() - stresses.col(0)).cwiseAbs().maxCoeff() / stresses.norm());
          const Eigen::MatrixXd K = compute_fem_stiffness(X, space.material(e), element);
          const Eigen::Map<const Eigen::VectorXd> w(turn.data(), turn.size());
          // Round-off is that of the products that cancel.
          forces =
            largest_of(forces,
                       (K * w).cwiseAbs().maxCoeff() / (K.cwiseAbs() * w.cwiseAbs()).maxCoeff());
        }
      const std::string name = word_of(element, fem_element_choices());
      check_below("curved pinion, stress of a linear field, " + name, deviation, 1e-12);
      check_below("curved pinion, forces of a rotation, " + name, forces, 1e-14);
    }
}

/** One sector has the modes of the whole body. */
void sector_and_body(const Communicator &communicator)
{
  const Model model = make_pinion(ConstraintKind::free_rotation, 0., communicator);
  FemOptions  options;
  options.element          = FemElement::quadratic;
  options.geometry         = FemGeometry::curved;
  options.n_modes          = 8;
  options.largest_diameter = 3;
  const ModesAtSpeed all   = RotatingBody(model, 0, options, communicator).find_modes(0.);
  options.cyclic_symmetry  = true;
  const ModesAtSpeed some  = RotatingBody(model, 0, options, communicator).find_modes(0.);
  check("modes of a sector", some.modes.size() >= all.modes.size());
  double worst = 0;
  for (std::size_t i = 1; i < all.modes.size() && i < some.modes.size(); ++i)
    raise_to(worst, std::abs(all.modes[i].frequency / some.modes[i].frequency - 1.));
  check_below("modes of the curved sector and body", worst, 1e-9);
}

/** Puts what lies between corners beside its place by more than half an edge. */
class Pushed : public dealii::Manifold<3>
{
public:
  std::unique_ptr<dealii::Manifold<3>> clone() const override
  {
    return std::make_unique<Pushed>();
  }
  dealii::Point<3> get_new_point(const dealii::ArrayView<const dealii::Point<3>> &points,
                                 const dealii::ArrayView<const double> &weights) const override
  {
    dealii::Point<3> place(.7, 0., 0.);
    for (std::size_t i = 0; i < points.size(); ++i)
      place += weights[i] * points[i];
    return place;
  }
};

void refusals()
{
  auto mesh = make_block(Vector3(2., 1., 1.), {{2, 1, 1}});
  mesh->triangulation.set_all_manifold_ids(7);
  mesh->triangulation.set_manifold(7, Pushed());
  Model model                           = model_of(Body("block", std::move(mesh), {}));
  model.bodies[0].placement.translation = Vector3(0., 10., 0.);
  print_refusal<NumericalError>([&] {
    FemSpace(model, {0}, {FemElement::quadratic, FemGeometry::curved});
  });
  const FemSpace straight(model, {0}, FemElement::quadratic);
  check_close("straight edges do not ask the mesh", volume_of(straight), 2., 1e-14);
  FemOptions options;
  options.geometry = FemGeometry::curved;
  print_refusal([&] { options.check("Fem"); });
}

int main(int argc, char **argv)
{
  const TestRanks ranks(argc, argv);
  volume_of_ring();
  pressed_ring(ranks.world);
  patch_test(ranks.world);
  sector_and_body(ranks.world);
  refusals();
  return 0;
}
