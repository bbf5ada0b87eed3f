// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/fem/modes/mass_basis.h>
#include <vfife/fem/modes/modal_solver.h>
#include <vfife/fem/solvers/direct_solver.h>
#include <vfife/fem/solvers/eigen_solver.h>
#include <vfife/fem/system/rigid_motions.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace vfife
{
  /** Pairs, and what was learnt while finding them. */
  struct ModalSolver::Found
  {
    EigenPairs pairs;
    bool       counted = false;
    double     memory  = 0;
  };

  double Mode::frequency() const
  {
    // omega = sqrt(lambda); a negative one, of a motion that grows, keeps its sign
    return std::copysign(std::sqrt(std::abs(eigenvalue)) / (2. * pi), eigenvalue);
  }

  ModalSolver::ModalSolver(const FemSystem &system, const FemOptions &options)
    : system_(system)
    , options_(options)
    , matrices_(system, options.mass, options.strain)
  {
    const unsigned int n = system.constraints().n(), most = largest_number(n);
    if (options.n_modes > most)
      throw InputError("Fem/modes",
                       "the eigenvalue solver needs " +
                         std::to_string(least_unknowns(options.n_modes)) + " unknowns for " +
                         std::to_string(options.n_modes) +
                         (options.n_modes == 1 ? " mode" : " modes") + ", and the mesh has " +
                         std::to_string(n) + ". " +
                         (most > 0 ? "Request at most " + std::to_string(most) + " modes, or refine"
                                   : "Refine") +
                         " the mesh");
  }

  unsigned int ModalSolver::least_unknowns(const unsigned int n_modes)
  {
    return 2 * (n_modes + n_guard_modes + 10) + 1;
  }

  unsigned int ModalSolver::largest_number(const unsigned int n_unknowns)
  {
    // The Krylov space has 2 (n + guards + 10) vectors, and one more so that pairs stay together.
    const unsigned int half = (std::max(n_unknowns, 1u) - 1) / 2;
    return half - std::min(half, n_guard_modes + 10);
  }

  void check_residual(const double residual, const double frequency)
  {
    if (residual < 1e-3)
      return;
    std::ostringstream text;
    text << "the mode at " << frequency << " Hz has the residual " << residual
         << ": the eigenvalue solver did not converge. Reduce Fem/eigenvalue tolerance";
    throw NumericalError(text.str());
  }

  void check_orthogonality(const double defect)
  {
    if (defect < 1e-6)
      return;
    std::ostringstream text;
    text << "modes are orthogonal to " << defect << " only: the eigenvalue solver has failed";
    throw NumericalError(text.str());
  }

  double choose_shift(const FemMatrix &stiffness, const FemMatrix &mass)
  {
    return choose_shift(stiffness.diagonal(), mass.diagonal(), mass.communicator());
  }

  double choose_shift(const OwnedVector &k, const OwnedVector &m, const Communicator &communicator)
  {
    // Padding has no mass and does not count.
    double largest = 0;
    for (std::size_t i = 0; i < k.size(); ++i)
      if (m[i] > 0)
        largest = std::max(largest, k[i] / m[i]);
    return -1e-10 * communicator.max(largest);
  }

  ModalResult ModalSolver::solve(const FemMatrix                        &stiffness,
                                 const FemMatrix                        &mass,
                                 const double                            lowest,
                                 const std::vector<std::vector<double>> &rigid) const
  {
    // Below zero and below what spin may make of rigid motions: K - shift M is positive definite.
    const double shift = choose_shift(stiffness, mass) + 1.2 * std::min(lowest, 0.);
    Found        found = options_.eigen_solver == EigenSolverKind::lobpcg
                           ? find_by_lobpcg(stiffness, mass, shift)
                           : find_by_factorization(stiffness, mass, shift);
    EigenPairs  &pairs = found.pairs;
    ModalResult  result;
    result.highest = pairs.values.back();
    // Guards have served for the gap and for double modes; from here on only what was asked for.
    result.guards.assign(std::make_move_iterator(pairs.vectors.begin() + options_.n_modes),
                         std::make_move_iterator(pairs.vectors.end()));
    pairs.values.resize(options_.n_modes);
    pairs.vectors.resize(options_.n_modes);
    const std::vector<double> residuals = compute_residuals(stiffness, mass, pairs, shift);
    check_orthogonality(compute_orthogonality_defect(mass, pairs.vectors));

    const SparseMatrix M(mass);
    MassBasis          free(M);
    for (const std::vector<double> &motion : rigid)
      free.add(system_.restrict_field(motion));
    for (unsigned int k = 0; k < options_.n_modes; ++k)
      {
        Mode mode;
        mode.eigenvalue = pairs.values[k];
        mode.residual   = residuals[k];
        mode.shape      = system_.expand(pairs.vectors[k]);
        mode.is_rigid   = free.share(pairs.vectors[k]) > .5;
        result.n_rigid += mode.is_rigid;
        check_residual(mode.residual, mode.frequency());
        result.modes.push_back(std::move(mode));
      }
    result.rigid        = free.vectors();
    result.vectors      = std::move(pairs.vectors);
    result.n_unknowns   = system_.constraints().n();
    result.counted      = found.counted;
    result.n_iterations = pairs.n_iterations;
    result.memory       = found.memory;
    result.shift        = shift;
    if (system_.constraints().n_copies() == 1 && system_.space().sector_angle() == 0)
      add_effective_masses(result);
    return result;
  }

  ModalSolver::Found ModalSolver::find_by_factorization(const FemMatrix &stiffness,
                                                        const FemMatrix &mass,
                                                        const double     shift) const
  {
    Found        found;
    unsigned int n_wanted = options_.n_modes + n_guard_modes;
    for (unsigned int attempt = 0; attempt < 3; ++attempt)
      {
        {
          // In a scope of its own: these factors are given back before those for counting are made.
          const DirectSolver factors(add_scaled(stiffness, -shift, mass));
          if (factors.n_negative() > 0)
            throw NumericalError("the body is not stable: " + std::to_string(factors.n_negative()) +
                                 " motions have a negative stiffness (speed too high)");
          found.memory = factors.memory();
          found.pairs =
            solve_shift_invert(mass, factors, shift, n_wanted, options_.eigen_tolerance);
        }
        if (!options_.count_modes)
          return found;

        // The widest gap behind the modes asked for.
        const std::vector<double> &values = found.pairs.values;
        unsigned int               below  = options_.n_modes;
        for (unsigned int i = options_.n_modes; i < values.size(); ++i)
          if (values[i] - values[i - 1] > values[below] - values[below - 1])
            below = i;
        const DirectSolver count(
          add_scaled(stiffness, -.5 * (values[below] + values[below - 1]), mass));
        // By Sylvester's law of inertia as many negative pivots as eigenvalues below the shift,
        // here in the gap behind mode "below": none was missed.
        if (count.n_negative() == below)
          {
            found.counted = true;
            return found;
          }
        // Missed modes: a larger space finds them, or their further copies.
        n_wanted +=
          count.n_negative() > below ? count.n_negative() - below + n_guard_modes : n_guard_modes;
      }
    throw NumericalError("the modes are not complete: a factorization counts another number of "
                         "modes below the highest one, also after a second search");
  }

  ModalSolver::Found
  ModalSolver::find_by_lobpcg(FemMatrix stiffness, const FemMatrix &mass, const double shift) const
  {
    // Start vectors are zero at padding and nothing couples to it: it needs no mass.
    system_.set_padding(stiffness, system_.mean_diagonal(stiffness));
    Found found;
    found.pairs = solve_lobpcg(stiffness,
                               mass,
                               matrices_.near_kernel(),
                               shift,
                               options_.n_modes + n_guard_modes,
                               options_.eigen_tolerance);
    return found;
  }

  void ModalSolver::add_effective_masses(ModalResult &result) const
  {
    const FemSpace &d = system_.space();
    for (const FemSpace::Part &part : d.parts())
      {
        // Bodies of one space add up: the base moves all of them.
        const auto rigid = make_rigid_motions(d, part, d.model().bodies[part.body].axis.point);
        for (unsigned int r = 0; r < 6; ++r)
          {
            // (x^T M r)^2 with x^T M x = 1, r a unit motion along or about x, y, z
            const OwnedVector load = matrices_.apply_mass(rigid[r]);
            for (unsigned int k = 0; k < result.modes.size(); ++k)
              {
                const double factor = system_.dot(load, result.vectors[k]);
                result.modes[k].effective_mass[r] += factor * factor;
              }
          }
      }
  }
} // namespace vfife
