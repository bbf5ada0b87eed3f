// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_cyclic_harmonic_unknowns_h
#define vfife_fem_cyclic_harmonic_unknowns_h

#include <vfife/fem/cyclic/cyclic_sector.h>
#include <vfife/fem/cyclic/roots_of_unity.h>
#include <vfife/fem/solvers/columns.h>

#include <complex>
#include <vector>

namespace vfife
{
  /**
   * Phasors z of a sector with h nodal diameters: on its second border exp(i h alpha) times those
   * on the first. Unknowns are the others, of h > 0 without angles of hubs; vectors of them have
   * real parts before imaginary ones, where 0 < h < N/2. On the open sector each vector has as many
   * columns as parts, one behind the other.
   */
  class HarmonicUnknowns
  {
  public:
    /** @p sector must outlive the object. */
    HarmonicUnknowns(const CyclicSector &sector, unsigned int number);

    /** Parts of a phasor: 1 where it is real, 2 otherwise. */
    unsigned int n_parts() const
    {
      return n_parts_;
    }
    /** Numbers in a vector. */
    unsigned int n() const
    {
      return n_parts_ * own_.size();
    }

    /** exp(i h k alpha) of @p sectors k. */
    std::complex<double> phase(const unsigned int sectors) const
    {
      return roots_(number_, sectors);
    }

    /** Displacements of the open sector. */
    Eigen::MatrixXd expand(const Columns &x) const;
    /** Their unknowns. */
    void take(const Eigen::MatrixXd &u, Columns &x) const;
    /** Forces on the unknowns of those on the open sector. */
    void fold(const Eigen::MatrixXd &forces, Columns &x) const;

    /** On the kept unknowns: the matrix @p S of the open sector with bearings and couplings. */
    Eigen::MatrixXcd make_matrix(const Eigen::MatrixXd &S) const;
    /** Forces (a column each) of those on the open sector. */
    Eigen::MatrixXcd fold_kept(const Eigen::MatrixXcd &forces) const;
    /** Displacements (a column each) of the open sector. */
    Eigen::MatrixXcd expand_kept(const Eigen::MatrixXcd &x) const;

    /** Adds what bearings and couplings exert on the open sector that is displaced by @p u, as the
     * parts of a stiffness times u. */
    void add_ring_forces(const Eigen::MatrixXd &u, Eigen::MatrixXd &forces) const;

    /** Parts as phasors, and back. */
    Eigen::MatrixXcd join_parts(const Eigen::MatrixXd &parts) const;
    Eigen::MatrixXd  split_parts(const Eigen::MatrixXcd &phasors) const;

  private:
    void find_rings();

    const CyclicSector       &sector_;
    unsigned int              number_;
    unsigned int              n_parts_;
    RootsOfUnity              roots_;
    std::vector<unsigned int> own_;    ///< unknowns of the open sector
    unsigned int              n_kept_; ///< of the harmonic
    /** Motions of rings of the open sector's kept unknowns, and their stiffness. */
    Eigen::MatrixXcd ring_motion_;
    Eigen::MatrixXd  ring_stiffness_;
  };
} // namespace vfife

#endif
