// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_residual_sum_h
#define vfife_reduced_residual_sum_h

#include <Eigen/Core>

#include <vector>

namespace vfife
{
  class Communicator;

  /**
   * Sums phasors of the harmonics to what a unit force on sector 0 alone does on sectors around it:
   * f on one of N sectors is the sum of w_h Re(f exp(i h d alpha)) over h = 0 ... N/2, with w_h =
   * 1/N at both ends and 2/N between them. Columns are forces, which are the first rows.
   */
  class ResidualSum
  {
  public:
    ResidualSum(unsigned int n_sectors,
                unsigned int reach,
                unsigned int n_rows,
                unsigned int n_columns);

    /** Phasors of a harmonic: @p answers to forces on all sectors, less the part of @p modes under
     * a force on one sector. */
    void add(unsigned int harmonic, const Eigen::MatrixXcd &answers, const Eigen::MatrixXcd &modes);

    /** Over the ranks. Collective. */
    void sum(const Communicator &communicator);

    /** By sector, -reach first. */
    std::vector<Eigen::MatrixXd> take_near()
    {
      return std::move(near_);
    }
    /** The sum over all sectors. */
    const Eigen::MatrixXd &summed() const
    {
      return summed_;
    }
    /** Largest entry at the forces' rows on sectors beyond the reach over that within, among a
     * sample of the forces. */
    double left() const;

  private:
    unsigned int                 n_sectors_, reach_;
    std::vector<int>             sample_; ///< forces, three by three
    std::vector<Eigen::MatrixXd> near_, far_;
    Eigen::MatrixXd              summed_;
  };
} // namespace vfife

#endif
