// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_bearing_mean_motion_h
#define vfife_bearing_mean_motion_h

#include <vfife/base/types.h>

#include <string>
#include <vector>

namespace vfife
{
  /**
   * The mean motion of a set of nodes, which itself may deform: its centre c = sum A x, and the
   * rotation R that minimizes sum A |x - c - R r|^2, r from the undeformed centre to the undeformed
   * node (the polar factor of sum A x r^T). A spin w of R needs J w = sum A (R r) x dx with
   * J = tr(S) I - S, S = sum A x (R r)^T.
   *
   * A force F and a moment M of this motion are f_i = A_i (F + (J^-1 M) x (R r_i)): they sum to F
   * and M, and their power is F . dc + M . w, so that the deformation of the set within itself
   * gains nothing (doc/theory/model.md, doc/theory/bearing.md).
   */
  class MeanMotion
  {
  public:
    /** Shares A, scaled to the sum one, and undeformed places [mm] of the whole set. Throws
     * InputError for nodes on a line, with the @p owner in words. */
    MeanMotion(std::vector<double>         shares,
               const std::vector<Vector3> &places,
               const std::string          &owner);

    /** Where the set is, and how it moves. */
    struct Motion
    {
      Vector3 displacement    = Vector3::Zero();     ///< of the centre [mm]
      Matrix3 rotation        = Matrix3::Identity(); ///< R
      Matrix3 inverse_inertia = Matrix3::Zero();     ///< J^-1 [1/mm^2]
      Vector3 velocity        = Vector3::Zero();     ///< of the centre [mm/s]
      Vector3 spin            = Vector3::Zero();     ///< w [rad/s]
    };

    /** Zero sums. */
    static std::vector<double> make_sums();

    /** Adds node @p i at its present place [mm], with its velocity [mm/s], to @p sums. Sums of
     * ranks add up. */
    void add(std::size_t          i,
             const Vector3       &place,
             const Vector3       &velocity,
             std::vector<double> &sums) const;

    /** Of the nodes whose @p sums these are. Throws NumericalError, naming the owner, where the set
     * has shrunk to a line. */
    Motion solve(const std::vector<double> &sums) const;

    /** Of the undeformed places. */
    Motion at_rest() const;

    /** Force on node @p i [N] of the force @p force [N] and the moment @p moment [N mm]. */
    Vector3
    force(std::size_t i, const Motion &motion, const Vector3 &force, const Vector3 &moment) const
    {
      return shares_[i] *
             (force + (motion.inverse_inertia * moment).cross(motion.rotation * arms_[i]));
    }

    /** What a small displacement of node @p i adds to that of the centre and to the rotation, about
     * the undeformed places: (A I; A J^-1 [r]x). */
    Eigen::Matrix<double, 6, 3> derivative(std::size_t i, const Motion &at_rest) const;

    /** Of the undeformed places [mm]. */
    const Vector3 &centre() const
    {
      return centre_;
    }

    std::size_t size() const
    {
      return shares_.size();
    }

  private:
    std::vector<double>  shares_;
    std::vector<Vector3> arms_;
    Vector3              centre_;
    std::string          owner_;
  };
} // namespace vfife

#endif
