// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_cyclic_cyclic_harmonic_h
#define vfife_fem_cyclic_cyclic_harmonic_h

#include <vfife/fem/cyclic/cyclic_body.h>

#include <memory>
#include <vector>

namespace vfife
{
  class DirectSolver;

  /**
   * Modes of one harmonic: complex phasors z at the points of sector 0, Hermitian-orthogonal with
   * the kinetic energy of the whole body |c'|^2/2 (ReducedBody). Real for h = 0 and N/2. The rigid
   * turn of a free hub is none of them.
   */
  struct CyclicModes
  {
    Eigen::VectorXd          eigenvalues; ///< ascending [1/s^2]
    std::vector<OwnedVector> vectors;     ///< unknowns of a real basis
    Eigen::MatrixXcd         combination; ///< the modes' phasors are those of the basis times this
  };

  /**
   * Small motions of a cyclic body with h nodal diameters: sector 0 with the phase h alpha from one
   * sector to the next. Collective.
   */
  class CyclicHarmonic
  {
  public:
    CyclicHarmonic(const CyclicBody &body, unsigned int number);
    ~CyclicHarmonic();

    /**
     * All modes below @p cutoff [rad/s]: as many as a factorization there counts. Throws
     * InputError where the mesh has too few unknowns for so many, NumericalError where the body is
     * not stable or modes are not found.
     */
    CyclicModes find_modes(double cutoff);

    /** z_j^H A z_l of all modes over the whole body, A a matrix of the whole body. */
    Eigen::MatrixXcd project(const CyclicModes &modes, const FemMatrix &A) const;
    /** Coriolis matrix G of a unit rate. */
    FemMatrix coriolis() const;
    /** The change of K - Omega^2 S + hub curvature over that of Omega^2, from the body's state of
     * spin to that of @p rate [rad/s] with the displacements @p equilibrium. */
    FemMatrix spin_stiffness(const std::vector<double> &equilibrium, double rate) const;

    /** What rows read of the modes: phasors, a row each. */
    Eigen::MatrixXcd read(const CyclicModes &modes, const std::vector<SectorRow> &rows) const;

    /** What rows read of the phasors of static displacements: under unit forces along @p forces,
     * the same in all sectors but for the phase (a column each). Without the rigid turn of a free
     * hub, whose inertia balances the moments of forces. */
    Eigen::MatrixXcd answers(const std::vector<SectorRow> &forces,
                             const std::vector<SectorRow> &rows);

    /** h = 0: forces at all points (3 a point of sector 0), the same in all sectors: what the rows
     * read of the static displacements, without the rigid turn. */
    Eigen::VectorXd answer(const std::vector<double> &forces, const std::vector<SectorRow> &rows);

    /** h = 0: z_j^T f of the whole body. */
    Eigen::VectorXd modal_forces(const CyclicModes &modes, const std::vector<double> &forces) const;
    /** h = 0: z_j^T f of the whole body, f = -M r the Euler force of a unit angular acceleration
     * about the axis. Zero where the body turns freely: its turn takes all of that force. */
    Eigen::VectorXd euler_forces(const CyclicModes &modes) const;
    /** h = 0: what the rows read of the static displacements under the Euler force. */
    Eigen::VectorXd euler_answer(const std::vector<SectorRow> &rows);
    /** h = 0: r^T G z_j of the whole body, r the rigid turn. */
    Eigen::VectorXd turn_coriolis(const CyclicModes &modes) const;

    unsigned int n_unknowns() const
    {
      return system_.constraints().n();
    }
    double memory() const
    {
      return memory_; ///< of the largest factors so far [MB]
    }

  private:
    unsigned int count_modes(double &limit);
    void         factorize();
    /** The unknowns under forces on them with these moments about the axis, which the inertia of
     * the turn balances; a column each, in place. */
    void solve(Eigen::MatrixXd &q, const Eigen::VectorXd &moments) const;
    /** How much of the turn is in them. */
    Eigen::VectorXd turn_in(const Eigen::MatrixXd &q) const;
    Eigen::VectorXd read_turn(const std::vector<SectorRow> &rows) const;
    /** Of real modes with a vector on the unknowns. */
    Eigen::VectorXd  product(const CyclicModes &modes, const OwnedVector &load) const;
    const FemSystem &static_system() const
    {
      return pinned_ ? *pinned_ : system_;
    }
    CyclicModes make_complex(const std::vector<OwnedVector> &vectors) const;
    CyclicModes without_turn(std::vector<OwnedVector>   vectors,
                             const std::vector<double> &eigenvalues) const;
    double      scale() const; ///< of phasors with z^H M z = 1 to the kinetic energy of the body

    const CyclicBody             &body_;
    unsigned int                  number_;
    FemSystem                     system_;
    SystemMatrices                matrices_;
    FemMatrix                     K_, M_;
    std::unique_ptr<FemSystem>    pinned_; ///< h = 0 with a free hub: for static displacements
    std::unique_ptr<DirectSolver> factors_;
    Eigen::VectorXd               momentum_; ///< of the turn, on the pinned unknowns
    double                        memory_ = 0;
  };
} // namespace vfife

#endif
