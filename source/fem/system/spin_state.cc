// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/system/spin_state.h>

#include <cmath>
#include <numeric>

namespace vfife
{
  namespace
  {
    constexpr unsigned int largest_steps = 40;
    /** Of the displacements: where the matrix becomes that of the state, and where steps end. */
    constexpr double near = 1e-5, tolerance = 1e-7;
    /** A step longer than this part of the one before asks for the matrix of the state. */
    constexpr double slow = .2;

    double norm(const std::vector<double> &u)
    {
      return std::sqrt(std::inner_product(u.begin(), u.end(), u.begin(), 0.));
    }
  } // namespace

  SpinState find_spin_state(const SystemMatrices       &matrices,
                            const SystemMatrices::Rate &rate,
                            const bool                  softening,
                            const double                bed,
                            const std::string          &name,
                            const PrepareSolve         &prepare)
  {
    const FemSystem &system = matrices.system();
    SpinState        state;
    state.displacements.assign(3 * static_cast<std::size_t>(system.space().n_points()), 0.);
    const auto refuse = [&name]() {
      throw NumericalError(name + ": no stable equilibrium (the speed is too high)");
    };
    // At rest, and at the state: the bed is under both.
    const auto with_bed = [&](FemMatrix K) {
      return bed > 0 ? add_scaled(std::move(K), bed, matrices.mass()) : K;
    };
    // Bodies that are softened may be stable under their stresses only: the stiffness at rest is
    // not softened, and brings the state within reach of its own tangent.
    state.solve                    = prepare(with_bed(matrices.stiffness(rate)));
    bool                is_at_rest = true;
    std::vector<double> prepared; // displacements of the tangent
    const auto          prepare_tangent = [&]() {
      state.solve = nullptr; // its memory first
      state.solve = prepare(
        with_bed(softening ? matrices.spinning_stiffness(state.displacements, rate)
                           : add_scaled(matrices.spinning_stiffness(state.displacements, rate),
                                        1.,
                                        matrices.spin_mass(rate))));
      prepared   = state.displacements;
      is_at_rest = false;
    };
    double before = 0;
    for (unsigned int step = 0; step < largest_steps; ++step)
      {
        OwnedVector q = matrices.spinning_residual(state.displacements, rate, softening);
        if (bed > 0)
          q = add_scaled(std::move(q), -bed, matrices.apply_mass(state.displacements));
        state.solve(q);
        const std::vector<double> change = system.expand(q);
        state.displacements              = add_scaled(std::move(state.displacements), 1., change);
        const double length = norm(change), size = norm(state.displacements);
        if (!std::isfinite(size))
          refuse();
        if (!is_at_rest && length <= tolerance * size)
          {
            // Whoever solves with it next asks for the tangent of the state itself.
            if (norm(add_scaled(std::move(prepared), -1., state.displacements)) > near * size)
              prepare_tangent();
            return state;
          }
        // The first step has none before it; it comes near where strains are small.
        const bool is_slow = step > 0 && length > slow * before;
        if ((is_at_rest && length <= near * size) || is_slow)
          prepare_tangent();
        before = length;
      }
    refuse();
    return state;
  }
} // namespace vfife
