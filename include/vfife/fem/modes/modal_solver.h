// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_modes_modal_solver_h
#define vfife_fem_modes_modal_solver_h

#include <vfife/fem/fem_options.h>
#include <vfife/fem/system/system_matrices.h>

#include <array>
#include <vector>

namespace vfife
{
  class Log;

  /** One natural vibration, in axes that turn with the body. */
  struct Mode
  {
    double eigenvalue = 0;     ///< omega^2 [rad^2/s^2]
    double residual   = 0;     ///< |K x - lambda M x| over max(|lambda|, |shift|) |M x|
    bool   is_rigid   = false; ///< more than half of it is a rigid motion that nothing opposes
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
    std::vector<OwnedVector> guards;  ///< of further modes, found beyond those asked for
    std::vector<OwnedVector> rigid;   ///< rigid motions that nothing opposes
    unsigned int             n_unknowns   = 0;
    unsigned int             n_rigid      = 0;     ///< rigid ones of the modes
    bool                     counted      = false; ///< completeness was checked by a factorization
    double                   highest      = 0;     ///< eigenvalue, guards included [rad^2/s^2]
    unsigned int             n_iterations = 0;
    double                   memory       = 0; ///< of the factors [MB]
    double                   shift        = 0; ///< [rad^2/s^2]
  };

  /** Throws NumericalError for a mode whose residual is not below 1e-3: it is as exact as the
   * square of that, and beyond it may not be a mode. @p frequency [Hz] names it. */
  void check_residual(double residual, double frequency);

  /** Throws NumericalError for modes that are not orthogonal, by compute_orthogonality_defect(). */
  void check_orthogonality(double defect);

  /** -1e-10 of the largest K_ii/M_ii [rad^2/s^2]: far above the round-off of eigenvalues, far below
   * the modes that a mesh resolves. Collective. */
  double choose_shift(const FemMatrix &stiffness, const FemMatrix &mass);
  /** The same of the owned diagonals. */
  double choose_shift(const OwnedVector  &stiffness,
                      const OwnedVector  &mass,
                      const Communicator &communicator);

  /** Modes beyond those asked for: among them the gap for counting is looked for, and a double mode
   * at the end is not cut in two. */
  constexpr unsigned int n_guard_modes = 6;

  /**
   * The lowest modes of K x = omega^2 M x. The shift is that of choose_shift(), so that free bodies
   * need nothing else: rigid motions come out near zero. They are told by their shapes, never by
   * their frequency: soft mounts and critical speeds have real modes there. Always checked: number,
   * residuals, M-orthogonality; and, with shift-invert, that a factorization of K - s M counts as
   * many eigenvalues below s as were found, s between two modes (missed ones are searched for
   * again). Throws NumericalError where a check fails in the end. Collective.
   */
  class ModalSolver
  {
  public:
    /** @p system has padded unknowns exactly where @p options asks for LOBPCG. Throws InputError,
     * in the name of Fem/modes, where more modes are asked for than largest_number(). */
    ModalSolver(const FemSystem &system, const FemOptions &options);

    /**
     * Modes of matrices on the pattern of the system; @p lowest is a guess of the
     * lowest eigenvalue [rad^2/s^2], 0 or what motions are softened to; @p rigid are the motions
     * that nothing opposes, as displacements of all points (each copy).
     */
    ModalResult solve(const FemMatrix                        &stiffness,
                      const FemMatrix                        &mass,
                      double                                  lowest,
                      const std::vector<std::vector<double>> &rigid = {}) const;

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
    Found
    find_by_factorization(const FemMatrix &stiffness, const FemMatrix &mass, double shift) const;
    Found find_by_lobpcg(FemMatrix stiffness, const FemMatrix &mass, double shift) const;
    void  add_effective_masses(ModalResult &result) const;

    const FemSystem &system_;
    FemOptions       options_;
    SystemMatrices   matrices_;
  };
} // namespace vfife

#endif
