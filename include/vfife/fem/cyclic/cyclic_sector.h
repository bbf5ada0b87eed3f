// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_cyclic_cyclic_sector_h
#define vfife_fem_cyclic_cyclic_sector_h

#include <vfife/fem/cyclic/cyclic_body.h>
#include <vfife/fem/solvers/condensation.h>

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace vfife
{
  using SectorMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /** Unknowns of a sector with open borders (FemConstraints::Options::open) by what harmonics make
   * of them. */
  struct SectorUnknowns
  {
    /** On the border to the sector before, and on that to the next one in the same order. */
    std::array<std::vector<unsigned int>, 2> borders;
    std::vector<unsigned int>                seats; ///< further ones of bearings and couplings
    std::vector<unsigned int>                hubs;  ///< angles of rigid hubs

    explicit SectorUnknowns(const FemSystem &sector);

    /** All of these, which condensation leaves, in this order. */
    std::vector<unsigned int> kept() const;
  };

  /**
   * One sector of a CyclicBody with open borders, condensed onto them: what its harmonics
   * (CyclicHarmonic) have in common, so that each of them is small and dense
   * (doc/theory/reduced.md, From one sector). On this rank alone.
   */
  class CyclicSector
  {
  public:
    /** @p cutoff: of modes [rad/s]. @p rows: readings; forces act along them. The body must outlive
     * the object. Throws NumericalError where the sector between held borders is not stable. */
    CyclicSector(const CyclicBody &body, double cutoff, const std::vector<SectorRow> &rows);

    const CyclicBody &body() const
    {
      return body_;
    }
    const FemSystem &system() const
    {
      return system_;
    }
    const SystemMatrices &matrices() const
    {
      return matrices_;
    }
    const SectorUnknowns &unknowns() const
    {
      return unknowns_;
    }
    double cutoff() const
    {
      return cutoff_;
    }

    /** Of the body about its state of spin, without bearings and couplings. */
    const SectorMatrix &stiffness() const
    {
      return K_;
    }
    const SectorMatrix &mass() const
    {
      return M_;
    }
    /** Coriolis matrix G of a unit rate. */
    SectorMatrix coriolis() const;
    /** The change of K - Omega^2 S + hub curvature over that of Omega^2, from the body's state of
     * spin to that of @p rate [rad/s] with the displacements @p equilibrium. */
    SectorMatrix spin_stiffness(const std::vector<double> &equilibrium, double rate) const;

    /** K without what is kept. */
    const Condensation &condensed() const
    {
      return condensed_;
    }
    /** Of K - cutoff^2 M: what is left on the kept unknowns. */
    const Eigen::MatrixXd &border_matrix_at_cutoff() const
    {
      return at_cutoff_;
    }
    /** Modes of the sector between held borders below the cut-off. */
    unsigned int n_held_modes() const
    {
      return n_held_modes_;
    }

    /** What a row reads of the displacements @p sector sectors further on. */
    struct RowPart
    {
      unsigned int row, sector;
    };
    unsigned int n_rows() const
    {
      return n_rows_;
    }
    const std::vector<RowPart> &parts() const
    {
      return parts_;
    }
    /** A row for each part. */
    const SectorMatrix &reads() const
    {
      return reads_;
    }
    /** Unit forces along the parts, a column each: on the kept unknowns, condensed. */
    const Eigen::MatrixXd &part_loads() const
    {
      return part_loads_;
    }
    /** What the parts read under unit forces along them, the kept unknowns held. */
    const Eigen::MatrixXd &part_flexibility() const
    {
      return part_flexibility_;
    }

    /** Of the factors [MB]. */
    double memory() const
    {
      return memory_;
    }

  private:
    void add_rows(const std::vector<SectorRow> &rows);
    void condense_rows();
    void condense_at_cutoff(const FemMatrix &K, const FemMatrix &M);

    const CyclicBody    &body_;
    double               cutoff_;
    FemSystem            system_;
    SystemMatrices       matrices_;
    SectorUnknowns       unknowns_;
    FemMatrix            stiffness_;
    SectorMatrix         K_, M_;
    Condensation         condensed_;
    Eigen::MatrixXd      at_cutoff_;
    unsigned int         n_held_modes_ = 0;
    unsigned int         n_rows_;
    std::vector<RowPart> parts_;
    SectorMatrix         reads_;
    Eigen::MatrixXd      part_loads_, part_flexibility_;
    double               memory_ = 0;
  };
} // namespace vfife

#endif
