// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/statics/standing_motion.h>
#include <vfife/fem/system/rigid_motions.h>
#include <vfife/model/model.h>

#include <Eigen/LU>

#include <algorithm>

namespace vfife
{
  namespace
  {
    constexpr unsigned int n_motions = 4;

    /** Shifts across the axis and tilts, these with 1 mm at the farthest point; a row each. */
    Eigen::MatrixXd make_motions(const FemSpace &space, const FemSpace::Part &part)
    {
      const Axis &axis = space.model().bodies[part.body].axis;
      double      size = 0;
      for (unsigned int p = part.first_point; p < part.first_point + part.n_points; ++p)
        size = std::max(size, (space.points()[p] - axis.point).norm());
      const auto      rigid  = make_rigid_motions(space, part, axis.point);
      const Matrix3   across = axes_along(axis.direction);
      Eigen::MatrixXd motions =
        Eigen::MatrixXd::Zero(n_motions, 3 * static_cast<Eigen::Index>(part.n_points));
      for (unsigned int m = 0; m < n_motions; ++m)
        for (unsigned int c = 0; c < 3; ++c)
          motions.row(m) +=
            across(c, m % 2) * (m < 2 ? 1. : 1. / size) *
            Eigen::Map<const Eigen::RowVectorXd>(rigid[m < 2 ? c : 3 + c].data() +
                                                   3 * std::size_t(part.first_point),
                                                 motions.cols());
      return motions;
    }
  } // namespace

  bool hangs_in_bearings(const Model &model, const unsigned int body)
  {
    const auto of_body = [body](const auto &part) { return part.body == body; };
    return std::any_of(model.bearings.begin(), model.bearings.end(), of_body) &&
           std::none_of(model.constraints.begin(), model.constraints.end(), of_body);
  }

  std::optional<StandingMotion> find_standing_motion(const FemSpace       &space,
                                                     const FemSpace::Part &part,
                                                     const BodyOperator   &stiffness,
                                                     const BodyOperator   &mass)
  {
    // 1. Forces of the motions.
    const Eigen::MatrixXd r = make_motions(space, part);
    Eigen::MatrixXd       w(n_motions, r.cols()), mean(n_motions, r.cols());
    for (unsigned int m = 0; m < n_motions; ++m)
      {
        const Eigen::RowVectorXd  row = r.row(m);
        const std::vector<double> motion(row.data(), row.data() + row.size());
        const std::vector<double> forces = stiffness(motion), momentum = mass(motion);
        w.row(m)    = Eigen::Map<const Eigen::RowVectorXd>(forces.data(), r.cols());
        mean.row(m) = Eigen::Map<const Eigen::RowVectorXd>(momentum.data(), r.cols());
      }
    // 2. Mean motions, weighted with mass: Phi = (r^T M r)^-1 r^T M.
    mean                          = (mean * r.transpose()).eval().inverse() * mean;
    const Eigen::MatrixXd work    = r * w.transpose();
    const double          measure = work.cwiseAbs().maxCoeff();
    if (measure == 0.)
      return std::nullopt;
    // 3. Rows Phi u and, in the same unit, w u.
    StandingMotion standing;
    standing.body = part.body;
    for (unsigned int p = part.first_point; p < part.first_point + part.n_points; ++p)
      standing.points.push_back(p);
    standing.motion.resize(2 * n_motions, r.cols());
    standing.motion << mean, w / measure;
    const Eigen::MatrixXd one = measure * Eigen::MatrixXd::Identity(n_motions, n_motions);
    standing.stiffness.resize(2 * n_motions, 2 * n_motions);
    standing.stiffness << .5 * (work + work.transpose()), -one, -one,
      Eigen::MatrixXd::Zero(n_motions, n_motions);
    return standing;
  }
} // namespace vfife
