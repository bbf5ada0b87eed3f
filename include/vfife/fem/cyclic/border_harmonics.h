// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_cyclic_border_harmonics_h
#define vfife_fem_cyclic_border_harmonics_h

#include <vfife/base/process/communicator.h>
#include <vfife/fem/cyclic/roots_of_unity.h>
#include <vfife/fem/solvers/hermitian_factor.h>

#include <map>
#include <set>
#include <vector>

namespace vfife
{
  /** A stiffness that is added against a motion of all borders, x_k = Re(motion exp(i h k alpha))
   * on border k: in this harmonic stiffness motion motion^H. */
  struct BorderBrace
  {
    unsigned int     harmonic = 0;
    Eigen::VectorXcd motion; ///< of border 0
    double           stiffness = 0;
  };

  /**
   * The borders between N equal sectors: border 0 of a sector is border 1 of the one before. Their
   * stiffness falls into harmonics x_(k+1) = x_k exp(i h alpha), each with a factor of its own.
   * Ranks share the harmonics; solve() and find_flexibility() are collective.
   */
  class BorderHarmonics
  {
  public:
    /** @p S: stiffness of one sector's borders, those of border 0 first. The communicator must
     * outlive the object. */
    BorderHarmonics(const Eigen::MatrixXd          &S,
                    unsigned int                    n_sectors,
                    const std::vector<BorderBrace> &braces,
                    const Communicator             &communicator);

    /** Whether all matrices of this rank are positive definite; otherwise nothing can be solved. */
    bool is_positive() const
    {
      return positive_;
    }
    /** Of one border. */
    unsigned int n_unknowns() const
    {
      return n_border_;
    }
    /** Displacements of both borders of all sectors (a column each) under loads on them. */
    Eigen::MatrixXd solve(const Eigen::MatrixXd &loads) const;

    /** loads^T x of the displacements x under @p loads on the borders of one sector (a column
     * each), by the @p distances from that sector to the one where x is taken. */
    std::map<unsigned int, Eigen::MatrixXd>
    find_flexibility(const Eigen::MatrixXd &loads, const std::set<unsigned int> &distances) const;

    /** Of the factors, on this rank [MB]. */
    double memory() const;

  private:
    struct Harmonic
    {
      unsigned int    number;
      HermitianFactor factor;
    };
    Eigen::MatrixXcd make_matrix(const Eigen::MatrixXd          &S,
                                 unsigned int                    number,
                                 const std::vector<BorderBrace> &braces) const;
    /** Of the harmonic's real part in a sum over all of them. */
    double weight(unsigned int harmonic) const;

    unsigned int          n_border_; ///< unknowns of one border
    unsigned int          n_sectors_;
    RootsOfUnity          phase_;
    const Communicator   &communicator_;
    std::vector<Harmonic> harmonics_; ///< of this rank
    bool                  positive_ = true;
  };
} // namespace vfife

#endif
