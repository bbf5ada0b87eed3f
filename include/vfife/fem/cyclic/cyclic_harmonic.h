// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_cyclic_cyclic_harmonic_h
#define vfife_fem_cyclic_cyclic_harmonic_h

#include <vfife/fem/cyclic/harmonic_unknowns.h>
#include <vfife/fem/solvers/hermitian_solver.h>

#include <optional>
#include <vector>

namespace vfife
{
  struct EigenPairs;

  /**
   * Modes of one harmonic: complex phasors z on the unknowns of the open sector 0,
   * Hermitian-orthogonal with the kinetic energy of the whole body |c'|^2/2 (ReducedBody). Real for
   * h = 0 and N/2. The rigid turn of a free hub is none of them.
   */
  struct CyclicModes
  {
    Eigen::VectorXd  eigenvalues; ///< ascending [1/s^2]
    Eigen::MatrixXcd phasors;     ///< a column each
  };

  /**
   * Small motions of a cyclic body with h nodal diameters: sector 0 with the phase h alpha from one
   * sector to the next. The interior of the sector is condensed once for all of them
   * (CyclicSector). On this rank alone.
   */
  class CyclicHarmonic
  {
  public:
    /** @p sector must outlive the object. Throws NumericalError where the body is not stable. */
    CyclicHarmonic(const CyclicSector &sector, unsigned int number);

    /**
     * All modes below the cut-off of the sector: as many as a factorization there counts. Throws
     * InputError where the mesh has too few unknowns for so many, NumericalError where modes are
     * not found.
     */
    CyclicModes find_modes();

    /** z_j^H A z_l of all modes over the whole body, A a matrix of each sector. */
    Eigen::MatrixXcd project(const CyclicModes &modes, const SectorMatrix &A) const;

    /** What the rows of the sector read of the modes: phasors, a row each. */
    Eigen::MatrixXcd read(const CyclicModes &modes) const;

    /** What the rows of the sector read of the phasors of static displacements: under unit forces
     * along @p n rows from @p first on, the same in all sectors but for the phase (a column each).
     * Without the rigid turn of a free hub, whose inertia balances the moments of forces. */
    Eigen::MatrixXcd answers(unsigned int first, unsigned int n) const;

    /** h = 0: forces at all points (3 a point of sector 0), the same in all sectors: what the rows
     * read of the static displacements, without the rigid turn. */
    Eigen::VectorXd answer(const std::vector<double> &forces) const;

    /** h = 0: z_j^T f of the whole body. */
    Eigen::VectorXd modal_forces(const CyclicModes &modes, const std::vector<double> &forces) const;
    /** h = 0: z_j^T f of the whole body, f = -M r the Euler force of a unit angular acceleration
     * about the axis. Zero where the body turns freely: its turn takes all of that force. */
    Eigen::VectorXd euler_forces(const CyclicModes &modes) const;
    /** h = 0: what the rows read of the static displacements under the Euler force. */
    Eigen::VectorXd euler_answer() const;
    /** h = 0: r^T G z_j of the whole body, r the rigid turn, @p G the Coriolis matrix of a unit
     * rate. */
    Eigen::VectorXd turn_coriolis(const CyclicModes &modes, const SectorMatrix &G) const;

    unsigned int n_unknowns() const
    {
      return unknowns_.n();
    }
    double memory() const ///< of the factors [MB]
    {
      return sector_.memory() + borders_->memory();
    }

  private:
    /** The rigid turn of a free hub in h = 0: M-orthogonal to all fields, of which forces with a
     * moment about the axis are freed. */
    struct Turn
    {
      Eigen::VectorXd motion, momentum; ///< r and M r on the open sector
      double          inertia;          ///< of a sector [t mm^2]
    };

    void         find_turn();
    void         factorize();
    unsigned int count_modes() const;
    /** The @p n vectors below the cut-off, of @p most that can be found. */
    EigenPairs  find_pairs(unsigned int n, unsigned int most) const;
    CyclicModes make_complex(const EigenPairs &pairs) const;
    /** Displacements of the open sector under forces on it, parts of phasors (a column each). */
    Eigen::MatrixXd solve(Eigen::MatrixXd forces) const;
    /** The same, with forces whose moment the turn does not take: K + s b b^T, b the turn of the
     * borders, is factorized, since K alone has no stiffness against it. */
    Eigen::MatrixXd solve_pinned(Eigen::MatrixXd forces) const;
    /** Phasors of rows from those of their parts. */
    Eigen::MatrixXcd sum_parts(const Eigen::MatrixXcd &parts) const;
    double           scale() const;

    const CyclicSector            &sector_;
    unsigned int                   number_;
    HarmonicUnknowns               unknowns_;
    std::optional<Turn>            turn_;
    std::optional<HermitianSolver> borders_;
  };
} // namespace vfife

#endif
