// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Elements divided around surfaces: constant strain, rigid motion, one sector against the body.
#include "../composite.h"
#include "../ranks.h"
#include "../reduced/whole_body.h"
#include "../refusal.h"

#include <vfife/fem/modes/rotating_body.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/fem/system/load_forces.h>

#include <set>

using namespace vfife;

Model make_block_model()
{
  auto mesh = make_block(Vector3(2., 1.5, 1.), {{3, 3, 3}});
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    for (unsigned int v = 0; v < 8; ++v)
      if (auto &x = cell->vertex(v);
          x[0] > .1 && x[0] < 1.9 && x[1] > .1 && x[1] < 1.4 && x[2] > .1 && x[2] < .9)
        x[v % 3] += .02;
  return model_of(Body("block", std::move(mesh), {}));
}

Model make_rod_model()
{
  return model_of(Body("rod", make_cylinder(10., 8., {{2, 2, 2}}), {}));
}

/** A linear field on the whole body: constant stress, and no force but on the boundary; a
 * rotation has no force at all. */
void patch_test(const std::string     &name,
                const Model           &model,
                const FemSpaceOptions &options,
                const Communicator    &communicator)
{
  const FemSpace  space(model, {0}, options);
  const FemSpace  coarse(model, {0}, options.element);
  const FemSystem system(space, {}, communicator);
  check(name + ": some elements are divided, and some points hang",
        space.n_elements() > coarse.n_elements() && !space.hanging().empty());
  // Also what a hanging point of the boundary passes to its masters is of the boundary.
  const auto                   list = space.points_of(space.parts()[0], all_nodes(model.bodies[0]));
  const std::set<unsigned int> boundary(list.begin(), list.end());
  Matrix3                      gradient, spin;
  gradient << 1e-3, 2e-4, -3e-4, 5e-4, -4e-4, 1e-4, 2e-4, 6e-4, 7e-4;
  spin << 0., -1e-3, 2e-3, 1e-3, 0., -5e-4, -2e-3, 5e-4, 0.;
  for (const Matrix3 &field : {gradient, spin})
    {
      std::vector<double> u;
      for (const Vector3 &x : space.points())
        for (unsigned int c = 0; c < 3; ++c)
          u.push_back(field.row(c).dot(x));
      double              scale = 0;
      std::vector<double> forces(u.size(), 0.);
      for (unsigned int e = 0; e < space.n_elements(); ++e)
        {
          const Eigen::MatrixXd K =
            compute_fem_stiffness(space.element_nodes(e), space.material(e), options.element);
          const Eigen::VectorXd v = space.gather(e, u), f = K * v;
          raise_to(scale, (K.cwiseAbs() * v.cwiseAbs()).maxCoeff());
          for (Eigen::Index i = 0; i < f.size(); ++i)
            forces[3 * std::size_t(space.element_points(e)[i / 3]) + i % 3] += f[i];
        }
      space.move_to_masters(forces);
      double worst = 0;
      for (unsigned int p = 0; p < space.n_points(); ++p)
        if (&field == &spin || boundary.count(p) == 0)
          raise_to(worst, Vector3(forces[3 * p], forces[3 * p + 1], forces[3 * p + 2]).norm());
      check_below(name + ": forces, over the products that cancel", worst / scale, 1e-14);
      // What is assembled is the same.
      const OwnedVector         own = system.vector([&](const unsigned int e) -> Eigen::VectorXd {
        return compute_fem_stiffness(space.element_nodes(e), space.material(e), options.element) *
               space.gather(e, u);
      });
      const std::vector<double> expanded = system.expand(own);
      double                    apart    = 0;
      for (unsigned int p = 0; p < space.n_points(); ++p)
        if (space.hanging().count(p) == 0)
          for (unsigned int c = 0; c < 3; ++c)
            raise_to(apart, std::abs(expanded[3 * p + c] - forces[3 * p + c]));
      check_below(name + ": assembled", apart / scale, 1e-14);
    }
}

/** Whole and halves: a set has the points that lie on it, hanging ones too. */
void points_on_surfaces()
{
  const Model    model = make_block_model();
  const FemSpace space(model, {0}, {FemElement::quadratic, FemGeometry::straight, {"x- 2"}});
  const auto     points = space.points_of(space.parts()[0], model.bodies[0].node_set("y-"));
  unsigned int   there  = 0;
  for (const Vector3 &x : space.points())
    there += std::abs(x[1]) < 1e-12 ? 1 : 0;
  check("points of a side", points.size() == there);
  double              area = 0;
  std::vector<double> forces(3 * std::size_t(space.n_points()), 0.);
  add_load_forces(
    pressure_on(model.bodies[0].node_set("y-"), 1.), space, space.parts()[0], 1., forces);
  for (unsigned int p = 0; p < space.n_points(); ++p)
    area += forces[3 * p + 1];
  check_close("pressure on a side with divided faces", area, 2., 1e-14);
}

/** A block between a held and a led side, divided beside both: uniaxial stress, also at what
 * hangs on points that are led. */
void stretch(const FemElement element, const Communicator &communicator)
{
  constexpr double strain              = 1e-3;
  Model            model               = make_block_model();
  const Body      &body                = model.bodies[0];
  model.constraints                    = {hold(body.node_set("x-"), {{true, false, false}}),
                                          hold(body.node_set("x+"), {{true, false, false}}),
                                          hold(body.node_set("y-"), {{false, true, false}}),
                                          hold(body.node_set("z-"), {{false, false, true}})};
  model.constraints[1].displacement[0] = 2. * strain;
  FemOptions options;
  options.element          = element;
  options.linear_solver    = LinearSolverKind::direct;
  options.local_refinement = {"y- 1"};
  const StaticSolver        solver(model, {0}, options, communicator);
  const std::vector<double> u     = solver.solve({}).displacements;
  const double              back  = -model.bodies[0].materials().front().poissons_ratio * strain;
  double                    worst = 0;
  for (unsigned int p = 0; p < solver.space().n_points(); ++p)
    raise_to(worst,
             (Eigen::Map<const Vector3>(u.data() + 3 * std::size_t(p)) -
              solver.space().points()[p].cwiseProduct(Vector3(strain, back, back)))
               .norm());
  check_below("stretched block, " + word_of(element, fem_element_choices()), worst / strain, 1e-12);
}

/** The modes of one sector are those of the whole body, and divided fillets make a stiff body
 * softer. */
void pinion(const Communicator &communicator)
{
  const Model model = make_pinion(ConstraintKind::free_rotation, 0., communicator);
  const auto  find  = [&](const bool sector, const std::vector<std::string> &refinement) {
    FemOptions options;
    options.local_refinement = refinement;
    options.n_modes          = sector ? 3 : 7;
    options.largest_diameter = 3;
    options.cyclic_symmetry  = sector;
    std::vector<double> frequencies;
    for (const RotatingMode &mode :
         RotatingBody(model, 0, options, communicator).find_modes(0.).modes)
      frequencies.push_back(mode.frequency);
    return frequencies;
  };
  const auto whole = find(false, {"fillets 1"}), sector = find(true, {"fillets 1"}),
             coarse = find(true, {});
  double worst      = 0;
  for (std::size_t i = 1; i < whole.size(); ++i)
    {
      double nearest = 1e9;
      for (const double frequency : sector)
        nearest = std::min(nearest, std::abs(frequency / whole[i] - 1.));
      raise_to(worst, nearest);
    }
  check_below("pinion with divided fillets: sector and body", worst, 1e-9);
  double lower = 0;
  for (std::size_t i = 1; i < sector.size(); ++i)
    raise_to(lower, sector[i] / coarse[i] - 1.);
  check("pinion with divided fillets: no frequency rises", lower < 1e-3);
}

void refusals()
{
  const Model model = make_block_model();
  for (const char *text : {"x-", "x- 9", "x- 1.5", "x- -1", "fillet 1", "X- 1"})
    print_refusal([&] {
      FemSpace(model, {0}, {FemElement::quadratic, FemGeometry::straight, {text}});
    });
}

int main(int argc, char **argv)
{
  const TestRanks ranks(argc, argv);
  for (const auto &choice : fem_element_choices())
    {
      patch_test("block, " + choice.first,
                 make_block_model(),
                 {choice.second, FemGeometry::straight, {"x- 2"}},
                 ranks.world);
      patch_test("rod, " + choice.first,
                 make_rod_model(),
                 {choice.second,
                  degree_of(choice.second) > 1 ? FemGeometry::curved : FemGeometry::straight,
                  {"top 1"}},
                 ranks.world);
      stretch(choice.second, ranks.world);
    }
  points_on_surfaces();
  pinion(ranks.world);
  refusals();
  return 0;
}
