// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/fem/solvers/direct_solver.h>
#include <vfife/fem/solvers/multigrid_solver.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/fem/system/rigid_motions.h>
#include <vfife/fem/system/turn_pins.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Nodal forces [N] of a force per volume [N/mm^3], 3 a point of the element. */
    Eigen::VectorXd integrate_body_force(const ElementNodes                            &X,
                                         const std::function<Vector3(const Vector3 &)> &force)
    {
      ElementNodes forces = ElementNodes::Zero(3, X.cols());
      for (const ElementPoint &point : compute_element_points(X))
        // f_a = sum_q w N_a force(x_q)
        forces += point.weight * force(X * point.N) * point.N.transpose();
      return Eigen::Map<const Eigen::VectorXd>(forces.data(), forces.size());
    }

    /** Of a load: its history at the time asked for, or the part of all loads. */
    double factor_of(const ParameterHistory &history, const StaticLoads &loads)
    {
      return loads.time ? history.value(*loads.time) : loads.part_of_loads;
    }
  } // namespace

  StaticSolver::StaticSolver(const Model                     &model,
                             const std::vector<unsigned int> &bodies,
                             const FemOptions                &options,
                             const Communicator              &communicator,
                             const HubRotation                rotation)
    : model_(model)
    , options_(options)
    , communicator_(communicator)
    , space_(model, bodies, options)
    , rotation_(rotation)
  {
    for (const FemSpace::Part &part : space_.parts())
      {
        const bool has_hub = has_turning_hub(model, part.body);
        // Of a hub that is pinned or held, the rotation about the axis is not missing.
        const auto        motions = find_free_motions(space_, part);
        const std::size_t n       = motions.size();
        std::size_t       allowed = has_hub && rotation != HubRotation::free ? 1 : 0;
        // Nor of a shaft in its bearings.
        if (!has_hub && n == 1 && rotation == HubRotation::pinned &&
            model.bodies[part.body].floats && is_turn(space_, part, motions.front()))
          {
            pinned_.push_back(part.body);
            allowed = 1;
          }
        refuse_free_motions(model.bodies[part.body], n - std::min(n, allowed));
      }
  }

  void refuse_free_motions(const Body &body, const std::size_t n)
  {
    if (n > 0)
      throw InputError("body \"" + body.name() + "\": " + std::to_string(n) +
                       " of its 6 rigid motions are not held by any constraint, so that it has "
                       "no static equilibrium. Hold more of its nodes");
  }

  std::vector<double> StaticSolver::make_forces(const StaticLoads &loads) const
  {
    std::vector<double> forces(3 * static_cast<std::size_t>(space_.n_points()), 0.);
    for (const Torque &torque : model_.torques)
      if (const auto *part = space_.find_part(torque.body))
        add_torque_forces(torque, space_, *part, loads.part_of_torques * torque.value, forces);
    for (const Load &load : model_.loads)
      if (const auto *part = space_.find_part(load.body);
          part != nullptr && load.kind != LoadKind::spring)
        add_load_forces(load, space_, *part, factor_of(load.history, loads), forces);
    if (!loads.nodal_forces.empty())
      for (const FemSpace::Part &part : space_.parts())
        {
          const Body &body = model_.bodies[part.body];
          for (unsigned int i = 0; i < body.n_nodes(); ++i)
            for (unsigned int c = 0; c < 3; ++c)
              forces[3 * std::size_t(part.first_point + i) + c] +=
                loads.nodal_forces[body.first_node + i][c];
        }
    return forces;
  }

  SystemMatrices::Rate StaticSolver::body_rate(const StaticLoads &loads) const
  {
    // Without centrifugal force bodies are at rest, as their bearings stand.
    return [this, turns = loads.centrifugal](const unsigned int body) {
      return turns ? model_.bodies[body].rate : 0.;
    };
  }

  std::vector<double> StaticSolver::balance(const SystemMatrices      &matrices,
                                            const StaticLoads         &loads,
                                            const std::vector<double> &u,
                                            const std::vector<double> &spun,
                                            double                    &strain_energy) const
  {
    // g(u) = K u - what acts: forces of the model and springs on one rank, the rest element by
    // element; about a state of spin u_s, f(u_s) + K(u_s) (u - u_s) instead of K u. Without
    // constraints it is zero in equilibrium; with them it is what they exert.
    const FemSpace &d       = space_;
    const bool      is_root = communicator_.is_root();
    // Without displacements, as in the first call where none are prescribed, no element stiffness
    // is asked for.
    const bool moved = std::any_of(u.begin(), u.end(), [](const double v) { return v != 0.; }) ||
                       std::any_of(d.parts().begin(), d.parts().end(), [this](const auto &part) {
                         return model_.bodies[part.body].has_initial_strains();
                       });
    std::vector<double>        sums(u.size(), 0.);
    const SystemMatrices::Rate rate = body_rate(loads);
    if (is_root)
      {
        const std::vector<double> forces = make_forces(loads);
        std::transform(forces.begin(), forces.end(), sums.begin(), std::negate<double>());
        for (const auto &spring : find_springs(d))
          {
            const std::size_t               row = 3 * std::size_t(spring.first);
            const Eigen::Map<const Vector3> way(u.data() + row);
            Eigen::Map<Vector3>(sums.data() + row) += spring.second * way;
            strain_energy += .5 * way.dot(spring.second * way);
          }
        const BearingRings   &rings   = matrices.system().rings();
        const Eigen::VectorXd ways    = rings.displacement(u);
        const Eigen::VectorXd pressed = rings.stiffness(rate) * ways;
        rings.add_forces(pressed - rings.preload(), sums);
        strain_energy += ways.dot(.5 * pressed - rings.preload());
      }
    // Elements are dealt out to the ranks in equal runs.
    const auto first = [&](const unsigned int rank) {
      return static_cast<unsigned long long>(rank) * d.n_elements() / communicator_.size();
    };
    for (unsigned int e = first(communicator_.rank()); e < first(communicator_.rank() + 1); ++e)
      {
        const ElementNodes    X      = d.element_nodes(e);
        const Eigen::VectorXd v      = d.gather(e, u);
        Eigen::VectorXd       forces = Eigen::VectorXd::Zero(v.size());
        if (!spun.empty())
          {
            const Eigen::VectorXd v_s   = d.gather(e, spun);
            const ElementState    state = compute_element_state(d.stress_free_nodes(e),
                                                             d.material(e),
                                                             d.element(),
                                                             options_.strain,
                                                             d.gather_from_stress_free(e, spun),
                                                             true);
            forces                      = state.forces + state.tangent * (v - v_s);
            strain_energy +=
              state.energy + (v - v_s).dot(state.forces + .5 * state.tangent * (v - v_s));
          }
        else if (moved)
          {
            const Eigen::VectorXd strained = d.gather_from_stress_free(e, u);
            forces = compute_fem_stiffness(X, d.material(e), d.element()) * strained;
            strain_energy += .5 * strained.dot(forces);
          }
        if (loads.body_force)
          forces -= integrate_body_force(X, loads.body_force);
        if (loads.centrifugal)
          {
            forces -=
              matrices.centrifugal_force(e,
                                         loads.spin_softening ? v : Eigen::VectorXd::Zero(v.size()),
                                         rate);
          }
        for (int i = 0; i < forces.size(); ++i)
          sums[3 * std::size_t(d.element_points(e)[i / 3]) + i % 3] += forces[i];
      }
    communicator_.sum(sums);
    d.move_to_masters(sums);
    strain_energy = communicator_.sum(strain_energy);
    return sums;
  }

  LinearSolve StaticSolver::prepare(const SystemMatrices &matrices,
                                    FemMatrix             K,
                                    unsigned int         &n_iterations) const
  {
    const FemSystem &system = matrices.system();
    K                       = add_turn_pins(system, pinned_, std::move(K));
    std::function<bool(OwnedVector & q)> solve; // tells whether K is known to be positive
    if (options_.linear_solver == LinearSolverKind::direct)
      {
        const auto solver = std::make_shared<DirectSolver>(K);
        const bool stable = solver->n_negative() == 0 && solver->n_zero() == 0;
        solve             = [solver, stable](OwnedVector &q) {
          solver->solve(q.data(), 1);
          return stable;
        };
      }
    else
      {
        system.set_padding(K, system.mean_diagonal(K));
        const auto solver = std::make_shared<MultigridSolver>(K, matrices.near_kernel());
        solve             = [this, solver, &n_iterations](OwnedVector &q) {
          q            = solver->solve(q, options_.linear_tolerance);
          n_iterations = solver->n_iterations();
          return true;
        };
      }
    return [&system, solve](OwnedVector &q) {
      const OwnedVector f    = q;
      const double      size = system.dot(f, f);
      if (!std::isfinite(size))
        throw NumericalError("the loads of the static solution are not finite");
      // Nothing acts: conjugate gradients could not measure their residual by it.
      if (size == 0)
        return;
      const bool stable = solve(q);
      // Conjugate gradients count no pivots, but an indefinite matrix shows in negative work.
      const double work = system.dot(f, q);
      if (!std::isfinite(work))
        throw NumericalError("the static solution is not finite");
      if (!stable || !(work > 0))
        throw NumericalError("the bodies have no stable equilibrium (a speed is too high)");
    };
  }

  StaticResult StaticSolver::solve(const StaticLoads &loads) const
  {
    // u = T q + u_c: unknowns are what is not prescribed.
    FemConstraints::Options constraints;
    constraints.padded       = options_.linear_solver == LinearSolverKind::multigrid;
    constraints.rotation     = rotation_;
    constraints.led_are_held = true;
    const FemSystem            system(space_, constraints, communicator_);
    const SystemMatrices       matrices(system, options_.mass, options_.strain);
    const SystemMatrices::Rate rate = body_rate(loads);
    StaticResult               result;
    result.turns = loads.centrifugal;
    // First the state of spin, which stiffens and softens the bodies: everything else is linear
    // about it.
    SpinState  state;
    const auto prepared = [&](FemMatrix K) {
      return prepare(matrices, std::move(K), result.n_iterations);
    };
    if (loads.centrifugal && loads.stress_stiffness)
      state = find_spin_state(matrices, rate, loads.spin_softening, 0., "the bodies", prepared);
    else
      {
        FemMatrix K = matrices.stiffness(rate);
        // K - Omega^2 S: the displaced mass is thrown outwards too.
        if (loads.centrifugal && loads.spin_softening)
          K = add_scaled(std::move(K), -1., matrices.spin_mass(rate));
        state.solve = prepared(std::move(K));
      }

    // K T q = -g(u) at the state of spin with the prescribed displacements.
    std::vector<double> &u = result.displacements;
    u = compute_prescribed_displacements(space_, [&loads](const Constraint &constraint) {
      return factor_of(constraint.history, loads);
    });
    if (!state.displacements.empty())
      u = add_scaled(std::move(u), 1., state.displacements);
    double              energy = 0;
    std::vector<double> forces = balance(matrices, loads, u, state.displacements, energy);
    std::transform(forces.begin(), forces.end(), forces.begin(), std::negate<double>());
    // The force of a hub's constraint that has turned with its point is in balance with the rest at
    // the state of spin; as a force of a constraint it is no load.
    if (!state.displacements.empty())
      for (const auto &point : matrices.hub_curvature(state.displacements, rate))
        {
          const std::size_t row = 3 * std::size_t(point.first);
          Eigen::Map<Vector3>(forces.data() + row) -=
            point.second * Eigen::Map<const Vector3>(state.displacements.data() + row);
        }
    OwnedVector q = system.restrict_forces(forces);
    state.solve(q);
    u = add_scaled(std::move(u), 1., system.expand(q));
    // What is left of all forces at the solution is what the constraints exert.
    result.reactions = balance(matrices, loads, u, state.displacements, result.strain_energy);
    return result;
  }

  std::vector<Stress> compute_stresses(const FemSpace            &space,
                                       const std::vector<double> &displacements)
  {
    // The plain mean of the elements that meet at a point.
    std::vector<Stress>       stresses(space.n_points(), Stress::Zero());
    std::vector<unsigned int> counts(space.n_points(), 0);
    const Eigen::MatrixXd    &to_points = point_extrapolation(space.degree());
    for (unsigned int e = 0; e < space.n_elements(); ++e)
      {
        const Eigen::Matrix<double, 6, Eigen::Dynamic> values =
          compute_point_stresses(space.element_nodes(e),
                                 space.material(e),
                                 space.element(),
                                 space.gather_from_stress_free(e, displacements)) *
          to_points;
        for (unsigned int a = 0; a < space.points_per_element(); ++a)
          {
            const unsigned int point = space.element_points(e)[a];
            stresses[point] += values.col(a);
            ++counts[point];
          }
      }
    for (std::size_t i = 0; i < stresses.size(); ++i)
      stresses[i] /= counts[i];
    return stresses;
  }

  std::vector<Stress> take_nodes(const FemSpace &space, const std::vector<Stress> &stresses)
  {
    const Model        &model = space.model();
    std::vector<Stress> nodes(model.n_nodes(), Stress::Zero());
    // Points of a body are in the order of its nodes.
    for (const FemSpace::Part &part : space.parts())
      std::copy_n(stresses.begin() + part.first_point,
                  part.n_nodes,
                  nodes.begin() + model.bodies[part.body].first_node);
    return nodes;
  }

  std::vector<Stress> compute_node_stresses(const FemSpace            &space,
                                            const std::vector<double> &displacements)
  {
    return take_nodes(space, compute_stresses(space, displacements));
  }
} // namespace vfife
