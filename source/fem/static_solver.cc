// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/communicator.h>
#include <vfife/base/errors.h>
#include <vfife/fem/direct_solver.h>
#include <vfife/fem/multigrid_solver.h>
#include <vfife/fem/static_solver.h>
#include <vfife/fem/system_matrices.h>
#include <vfife/fem/torque_forces.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    Eigen::VectorXd integrate_body_force(const ElementNodes                            &X,
                                         const std::function<Vector3(const Vector3 &)> &force)
    {
      ElementNodes forces = ElementNodes::Zero(3, X.cols());
      for (const ElementPoint &point : compute_element_points(X))
        forces += point.weight * force(X * point.N) * point.N.transpose();
      return Eigen::Map<const Eigen::VectorXd>(forces.data(), forces.size());
    }

    /** Values at the corners of an element from those at its n^3 Gauss points. */
    Eigen::MatrixXd corner_extrapolation(const unsigned int n)
    {
      const double        outer  = n == 2 ? 1. / std::sqrt(3.) : std::sqrt(.6);
      std::vector<double> points = {-outer, outer};
      if (n == 3)
        points = {-outer, 0., outer};
      const auto lagrange = [&](const unsigned int i, const double x) {
        double value = 1.;
        for (unsigned int j = 0; j < n; ++j)
          if (j != i)
            value *= (x - points[j]) / (points[i] - points[j]);
        return value;
      };
      Eigen::MatrixXd matrix(n * n * n, 8);
      for (unsigned int q = 0; q < n * n * n; ++q)
        for (unsigned int v = 0; v < 8; ++v)
          {
            const Vector3 x = reference_corner(v);
            matrix(q, v) =
              lagrange(q % n, x[0]) * lagrange(q / n % n, x[1]) * lagrange(q / (n * n), x[2]);
          }
      return matrix;
    }
  } // namespace

  StaticSolver::StaticSolver(const Model                     &model,
                             const std::vector<unsigned int> &bodies,
                             const FemOptions                &options,
                             const Communicator              &communicator)
    : model_(model)
    , options_(options)
    , communicator_(communicator)
    , discretization_(model, bodies, options.element)
  {
    for (const Discretization::Part &part : discretization_.parts())
      {
        const std::size_t n = find_free_motions(discretization_, part).size();
        if (n > 0)
          throw InputError("body \"" + model.bodies[part.body].name() + "\": " + std::to_string(n) +
                           " of its 6 rigid motions are not held by any constraint, so it has no "
                           "static equilibrium; hold more of its nodes");
      }
  }

  std::vector<double> StaticSolver::make_forces(const StaticLoads &loads) const
  {
    std::vector<double> forces(3 * static_cast<std::size_t>(discretization_.n_points()), 0.);
    for (const Torque &torque : model_.torques)
      if (const auto *part = discretization_.find_part(torque.body))
        add_torque_forces(
          torque, discretization_, *part, loads.part_of_torques * torque.value, forces);
    if (!loads.nodal_forces.empty())
      for (const Discretization::Part &part : discretization_.parts())
        {
          const Body &body = model_.bodies[part.body];
          for (unsigned int i = 0; i < body.n_nodes(); ++i)
            for (unsigned int c = 0; c < 3; ++c)
              forces[3 * std::size_t(part.first_point + i) + c] +=
                loads.nodal_forces[body.first_node + i][c];
        }
    return forces;
  }

  StaticResult StaticSolver::solve(const StaticLoads &loads) const
  {
    Unknowns::Options unknowns;
    unknowns.padded = options_.linear_solver == LinearSolverKind::multigrid;
    const Assembly       assembly(discretization_, unknowns, communicator_);
    const SystemMatrices matrices(assembly, options_.mass);
    SparseValues         K = matrices.stiffness();
    OwnedVector          f = assembly.restrict_forces(make_forces(loads));

    const auto add = [&f](const OwnedVector &part) {
      std::transform(f.begin(), f.end(), part.begin(), f.begin(), std::plus<double>());
    };
    const auto rate = [this](const unsigned int body) { return model_.bodies[body].rate; };
    if (loads.body_force)
      add(assembly.vector([&](const unsigned int e) {
        return integrate_body_force(discretization_.element_nodes(e), loads.body_force);
      }));
    if (loads.centrifugal)
      add(matrices.centrifugal_load(rate));
    if (loads.centrifugal && loads.spin_softening)
      K = add_scaled(K, -1., matrices.spin_mass(rate));

    StaticResult result;
    OwnedVector  q;
    if (options_.linear_solver == LinearSolverKind::direct)
      {
        const DirectSolver solver(assembly.pattern(), K, communicator_);
        q = f;
        solver.solve(q.data(), 1);
      }
    else
      {
        assembly.set_padding(K, assembly.mean_diagonal(K));
        MultigridSolver solver(assembly, K, matrices.near_kernel());
        q                   = solver.solve(f, options_.linear_tolerance);
        result.n_iterations = solver.n_iterations();
      }
    result.displacements = assembly.expand(q);
    result.strain_energy = .5 * assembly.dot(f, q);
    if (!std::isfinite(result.strain_energy))
      throw NumericalError("the static solution is not finite");
    return result;
  }

  std::vector<Stress> StaticSolver::compute_node_stresses(const StaticResult &result) const
  {
    return vfife::compute_node_stresses(discretization_, result.displacements);
  }

  std::vector<Stress> compute_node_stresses(const Discretization      &discretization,
                                            const std::vector<double> &displacements)
  {
    const Model              &model = discretization.model();
    std::vector<Stress>       stresses(model.n_nodes(), Stress::Zero());
    std::vector<unsigned int> counts(model.n_nodes(), 0);
    const Eigen::MatrixXd     corners =
      corner_extrapolation(discretization.element() == FemElement::quadratic ? 3 : 2);
    for (const Discretization::Part &part : discretization.parts())
      {
        const Body &body = model.bodies[part.body];
        for (unsigned int e = 0; e < part.n_elements; ++e)
          {
            const unsigned int                element = part.first_element + e;
            const Eigen::Matrix<double, 6, 8> values =
              compute_point_stresses(discretization.element_nodes(element),
                                     body.material(),
                                     discretization.element(),
                                     discretization.gather(element, displacements)) *
              corners;
            for (unsigned int v = 0; v < 8; ++v)
              {
                const unsigned int node = body.first_node + body.elements()[e][v];
                stresses[node] += values.col(v);
                ++counts[node];
              }
          }
      }
    for (std::size_t i = 0; i < stresses.size(); ++i)
      if (counts[i] > 0)
        stresses[i] /= counts[i];
    return stresses;
  }
} // namespace vfife
