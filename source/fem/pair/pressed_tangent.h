// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pair_pressed_tangent_h
#define vfife_fem_pair_pressed_tangent_h

#include <vfife/fem/pair/pressed_pair.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <utility>
#include <vector>

namespace vfife
{
  /** A pressed pair in small changes of its state: springs of the contact, force = B f,
   * f = -stiffness h, and behind them the rows behind the nodes', all at those rows alone at which
   * one of them acts. */
  class PressedTangent
  {
  public:
    /** Of @p n_rows rows; @p arm: scale of the turn [mm]. */
    PressedTangent(std::vector<PressedPair::Spring> springs,
                   PressedSprings                   others,
                   Eigen::Index                     n_rows,
                   double                           arm);

    /** At which something acts, ascending. */
    const std::vector<unsigned int> &rows() const
    {
      return rows_;
    }
    /** Takes the @p flexibility of the bodies at rows(), and what resists the turn as a way at the
     * arm, @p turn_stiffness [N/mm]. */
    void factorize(Eigen::MatrixXd flexibility, double turn_stiffness);

    /** Of a vector over all rows. */
    Eigen::VectorXd at_rows(const Eigen::VectorXd &x) const;
    /** What the bodies' answer to forces at rows() is beyond a deflection, both over all rows. */
    Eigen::VectorXd find_imbalance(const Eigen::VectorXd &force,
                                   const Eigen::VectorXd &deflection) const;
    /** Change of the springs' forces at all rows (first) and of the turn (second) for an imbalance
     * of displacements at rows() and of torque. */
    std::pair<Eigen::VectorXd, double> solve(const Eigen::VectorXd &u, double torque) const;

  private:
    /** A spring's directions by place among the rows at which something acts. */
    struct Entry
    {
      unsigned int row, spring;
      double       value;
    };

    Eigen::Index n_springs() const
    {
      return springs_.size();
    }
    Eigen::Index n_forces() const
    {
      return springs_.size() + others_.stiffness.rows();
    }
    /** Ways along the springs of displacements at rows(), and of the forces that the other rows
     * lose; with the torque that these lose, over the arm, as the last. */
    Eigen::VectorXd respond(const Eigen::Ref<const Eigen::VectorXd> &u) const;
    /** Forces at all rows of those of springs and other rows. */
    Eigen::VectorXd spread(const Eigen::VectorXd &f) const;

    std::vector<PressedPair::Spring> springs_;
    PressedSprings                   others_;
    Eigen::Index                     n_rows_;
    double                           arm_;
    std::vector<unsigned int>        rows_;
    std::vector<Entry>               entries_;
    Eigen::MatrixXd                  flexibility_;
    Eigen::VectorXd by_turn_; ///< change of h with the turn as a way at the arm [-]
    double          turn_stiffness_ = 0;

    bool                                 symmetric_ = false; ///< no rows behind the nodes'
    Eigen::LLT<Eigen::MatrixXd>          factor_;            ///< of the springs alone
    Eigen::VectorXd                      turned_;            ///< factor^-1 by_turn
    Eigen::PartialPivLU<Eigen::MatrixXd> system_;            ///< of all
  };
} // namespace vfife

#endif
