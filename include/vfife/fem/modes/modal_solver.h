// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_modes_modal_solver_h
#define vfife_fem_modes_modal_solver_h

#include <vfife/fem/fem_options.h>
#include <vfife/fem/system/system_matrices.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace vfife
{
  class Log;

  /** One natural vibration, in axes that turn with the body. */
  struct Mode
  {
    double eigenvalue = 0; ///< omega^2 [rad^2/s^2]
    double residual   = 0; ///< |K x - lambda M x| over max(|lambda|, |shift|) |M x|
    /** Displacements of all points (each copy), 3 a point, modal mass 1 t [mm]; on all ranks. */
    std::vector<double> shape;
    /**
     * (shape^T M r)^2 for the six rigid motions r of make_rigid_motions() about the body's axis
     * point: effective masses [t] and inertias [t mm^2]. Of whole bodies.
     */
    std::array<double, 6> effective_mass = {};

    /** [Hz]; with the sign of the eigenvalue, which round-off gives to rigid motions. */
    double frequency() const;
  };

  struct ModalResult
  {
    std::vector<Mode>        modes;   ///< ascending
    std::vector<OwnedVector> vectors; ///< unknowns of each mode, owned part
    unsigned int             n_unknowns   = 0;
    double                   rigid_rate   = 0;     ///< slower motions are taken as rigid [rad/s]
    unsigned int             n_rigid      = 0;     ///< modes slower than that
    bool                     counted      = false; ///< completeness was checked by a factorization
    unsigned int             n_iterations = 0;
    double                   memory       = 0; ///< of the factors [MB]
    double                   shift        = 0; ///< [rad^2/s^2]

    bool is_rigid(const Mode &mode) const
    {
      return std::abs(mode.eigenvalue) < rigid_rate * rigid_rate;
    }
  };

  /** -1e-10 of the largest K_ii/M_ii [rad^2/s^2]: far above the round-off of eigenvalues, far below
   * the modes that a mesh resolves. Collective. */
  double
  choose_shift(const Assembly &assembly, const SparseValues &stiffness, const SparseValues &mass);

  /**
   * The lowest modes of K x = omega^2 M x. The shift is that of choose_shift(), so that free bodies
   * need nothing else: rigid motions come out at zero. Always checked: number, residuals,
   * M-orthogonality; and, with shift-invert, that a factorization of K - s M counts as many
   * eigenvalues below s as were found, s between two modes (missed ones are searched for again).
   * Throws NumericalError where a check fails in the end. Collective.
   */
  class ModalSolver
  {
  public:
    /** @p assembly has padded unknowns exactly where @p options asks for LOBPCG. Throws InputError,
     * in the name of Fem/modes, where more modes are asked for than largest_number(). */
    ModalSolver(const Assembly &assembly, const FemOptions &options);

    /** Modes of the body at rest. */
    ModalResult solve() const;

    /**
     * Modes of other matrices on the same pattern, e.g. at speed; @p lowest is a guess of the
     * lowest eigenvalue [rad^2/s^2], 0 or what motions are softened to. Eigenvalues of rigid
     * motions are below @p rigid, unless given the size of the lowest one.
     */
    ModalResult solve(const SparseValues   &stiffness,
                      const SparseValues   &mass,
                      double                lowest,
                      std::optional<double> rigid = {}) const;

    const SystemMatrices &matrices() const
    {
      return matrices_;
    }

    /** How many modes can be asked for of a system with that number of unknowns. */
    static unsigned int largest_number(unsigned int n_unknowns);
    /** The least number of unknowns of which so many modes can be found. */
    static unsigned int least_unknowns(unsigned int n_modes);

    static bool needs_padding(const FemOptions &options)
    {
      return options.eigen_solver == EigenSolverKind::lobpcg;
    }

  private:
    struct Found;
    Found find_by_factorization(const SparseValues &stiffness,
                                const SparseValues &mass,
                                double              shift) const;
    Found find_by_lobpcg(SparseValues stiffness, SparseValues mass, double shift) const;
    void  add_effective_masses(ModalResult &result) const;
    void  check_orthogonality(const SparseValues &mass, const std::vector<OwnedVector> &x) const;

    const Assembly &assembly_;
    FemOptions      options_;
    SystemMatrices  matrices_;
  };
} // namespace vfife

#endif
