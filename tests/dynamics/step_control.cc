// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The step: bound of the assembly against the exact largest frequency of a small assembly, and
// selective mass scaling.
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"
#include "one_solver.h"

#include <vfife/dynamics/operator/mass_scaling.h>
#include <vfife/dynamics/operator/step_bound.h>
#include <vfife/element/stable_step.h>
#include <vfife/mesh/body_mesh.h>

#include <Eigen/Eigenvalues>

#include <limits>
#include <sstream>

using namespace vfife;

/** A block of 5 x 2 x 2 cells; the layer in its middle is thinner by @p thinness. */
Model make_model(const double thinness)
{
  const auto block = make_block(Vector3(5, 2, 2), {{5, 2, 2}});
  auto       mesh  = make_moved(*block, "layered block", [thinness](const Vector3 &x) {
    return Vector3(x[0] > 2.5 ? x[0] - 1 + thinness : x[0], x[1], x[2]);
  });
  return model_of(Body("block", std::move(mesh), Material()));
}

/** Largest circular frequency of the free body, from its assembled matrices [rad/s]. */
double exact_frequency(const Body &body)
{
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(3 * body.n_nodes(), 3 * body.n_nodes());
  for (unsigned int e = 0; e < body.n_elements(); ++e)
    {
      const Matrix24 Ke = compute_stiffness(body.element_nodes(e),
                                            body.materials().front(),
                                            StiffnessKind::incompatible_modes);
      for (unsigned int a = 0; a < 8; ++a)
        for (unsigned int b = 0; b < 8; ++b)
          K.block<3, 3>(3 * body.elements()[e][a], 3 * body.elements()[e][b]) +=
            Ke.block<3, 3>(3 * a, 3 * b);
    }
  Eigen::VectorXd scale(K.rows());
  for (unsigned int i = 0; i < body.n_nodes(); ++i)
    scale.segment<3>(3 * i).setConstant(1 / std::sqrt(body.node_masses()[i]));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * K *
                                                                scale.asDiagonal(),
                                                              Eigen::EigenvaluesOnly);
  return std::sqrt(solver.eigenvalues().tail<1>()[0]);
}

void bound_of_assembly()
{
  for (const double thinness : {1., 0.3})
    {
      const std::string name  = thinness < 1 ? "thin layer: " : "equal cells: ";
      const Model       model = make_model(thinness);
      DynamicsOptions   options;
      options            = undamped();
      options.step_bound = StepBound::element;
      OneSolver    element(model, options);
      const double exact = exact_frequency(model.bodies[0]);
      auto        &vfife = element.solver.vfife_operator();
      const auto   found = bound_largest_frequency(model, vfife, element.communicator);
      check(name + "element bound is a bound", vfife.limiting_element().frequency >= exact);
      // Difference of forces: strains of 1e-6.
      check_ratio(name + "Ritz value over the largest eigenvalue",
                  found.ritz_value / (exact * exact),
                  1e-5);
      check_close(name + "bound over the exact frequency",
                  found.frequency / exact,
                  std::min(1 / std::sqrt(0.99), vfife.limiting_element().frequency / exact),
                  1e-5);
      check(name + "at most the element's", found.frequency <= vfife.limiting_element().frequency);

      // Right at the limit a run is stable; 10 % beyond it is not.
      options.step_bound = StepBound::assembly;
      options.safety     = 1;
      OneSolver run(model, options);
      check_close(name + "solver's step", run.solver.element_step(), 2 / found.frequency, 0.);
      Model shaken = make_model(thinness);
      for (const Vector3 &X : shaken.bodies[0].node_positions())
        shaken.bodies[0].initial_velocity.push_back(
          10 * Vector3(std::sin(7 * X[0]), std::sin(5 * X[1] + X[0]), std::cos(3 * X[2])));
      for (const double factor : {0.98, 1.1})
        {
          OneSolver trial(shaken, options);
          trial.solver.set_step(factor * 2 / exact);
          trial.solver.start(trial.state);
          Observers  none;
          const bool failed = refuses<NumericalError>(
            [&] { trial.solver.run(trial.state, 3000 * factor * 2 / exact, none); });
          check(name + (factor < 1 ? "just below the limit: stable" : "beyond it: given up"),
                failed == (factor > 1));
        }
    }
}

/** A cube on springs a hundred times as stiff as itself, the same on each corner: they add k/m to
 * the square of each of its frequencies, and the bound is the frequency itself. */
void springs()
{
  Model model = model_of(Body("cube", make_block(Vector3(2, 2, 2), {{1, 1, 1}}), Material()));
  Body &cube  = model.bodies[0];
  for (const Vector3 &X : cube.node_positions())
    cube.initial_velocity.push_back(
      Vector3(std::sin(7 * X[0] + X[1]), std::sin(5 * X[1] + X[2]), std::cos(3 * X[2] + X[0])));
  const double own = exact_frequency(cube), corner = cube.mass() / 8;
  Load         spring;
  spring.name   = "springs";
  spring.kind   = LoadKind::spring;
  spring.vector = Vector3::Constant(8 * 100 * corner * own * own);
  for (unsigned int i = 0; i < cube.n_nodes(); ++i)
    spring.nodes.push_back(i);
  model.loads.push_back(spring);

  DynamicsOptions options = undamped();
  options.safety          = 1;
  options.energy_limit    = std::numeric_limits<double>::max();
  OneSolver    bound(model, options);
  const double step = bound.solver.stable_step();
  check_ratio("springs: step over 2/omega", step * std::sqrt(101.) * own / 2, 1e-9);
  // Solutions of (omega dt/2)^2 = 0.999^2 stay within 1/sqrt(1 - 0.999^2) of their start; beyond
  // 1.001 they grow by 2 acosh(1.001) = 0.089 a step.
  for (const double factor : {0.999, 1.001})
    {
      OneSolver run(model, options);
      run.solver.set_step(factor * step);
      run.solver.start(run.state);
      double     start = 0, largest = 0;
      auto       observers = watch(1, [&](const State &state) {
        double square = 0;
        for (unsigned int i = 0; i < cube.n_nodes(); ++i)
          square += state.node_velocity(i).squaredNorm();
        start = state.step == 0 ? std::sqrt(square) : start;
        raise_to(largest, std::sqrt(square));
      });
      const bool given_up =
        refuses<NumericalError>([&] { run.solver.run(run.state, 400 * factor * step, observers); });
      if (factor < 1)
        check("springs: stable just below their step",
              !given_up && largest < 2 * start / std::sqrt(1 - factor * factor));
      else
        check("springs: not beyond it", given_up || largest > 1e10 * start);
    }
}

void mass_scaling()
{
  std::ostringstream nothing;
  Log                log(nothing, true, Verbosity::quiet);
  Model              model   = make_model(0.3);
  const double       mass    = model.bodies[0].mass();
  const auto        &middle  = model.bodies[0].element_nodes(2);
  const double       density = model.bodies[0].materials().front().density;
  const double       thin =
    compute_largest_frequency(compute_stiffness(middle,
                                                model.bodies[0].materials().front(),
                                                StiffnessKind::incompatible_modes),
                              compute_lumped_mass(middle, density));

  DynamicsOptions options    = undamped();
  options.step_bound         = StepBound::element;
  options.mass_scaling_step  = 1.2 * 2 / thin;
  options.largest_added_mass = 0.05;
  scale_masses(options, model, log);
  // Four cells of 0.3 mm^3 in 16.8 mm^3, their mass times 1.44.
  check_ratio("added mass", model.bodies[0].added_mass() / (0.44 * 4 * 0.3 * density), 1e-9);
  check_ratio("mass of the body",
              model.bodies[0].mass() / (mass + model.bodies[0].added_mass()),
              1e-12);
  OneSolver run(model, options);
  check_close("step of the elements", run.solver.element_step(), options.mass_scaling_step, 1e-18);
  check("is a bound of the scaled body",
        2 / exact_frequency(model.bodies[0]) >= options.mass_scaling_step);

  options.largest_added_mass = 0.01;
  Model other                = make_model(0.3);
  print_refusal([&] { scale_masses(options, other, log); });

  Model equal = make_model(1.);
  options.mass_scaling_step /= 10;
  scale_masses(options, equal, log);
  check("a step below that of all elements adds nothing", equal.bodies[0].added_mass() == 0);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {bound_of_assembly, springs, mass_scaling});
}
