// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/solvers/sparse_matrix.h>
#include <vfife/fem/statics/standing_motion.h>
#include <vfife/fem/system/fem_constraints.h>

#include <Eigen/LU>

#include <algorithm>

namespace vfife
{
  namespace
  {
    constexpr unsigned int n_motions = 4;

    bool hangs_in_bearings(const Model &model, const unsigned int body)
    {
      const auto of_body = [body](const auto &part) { return part.body == body; };
      return std::any_of(model.bearings.begin(), model.bearings.end(), of_body) &&
             std::none_of(model.constraints.begin(), model.constraints.end(), of_body);
    }

    /** Shifts across the axis and tilts, these with 1 mm at the farthest point. */
    std::vector<std::vector<double>> make_motions(const FemSpace &d, const FemSpace::Part &part)
    {
      const Axis &axis = d.model().bodies[part.body].axis;
      double      size = 0;
      for (unsigned int p = part.first_point; p < part.first_point + part.n_points; ++p)
        size = std::max(size, (d.points()[p] - axis.point).norm());
      const auto                       rigid  = make_rigid_motions(d, part, axis.point);
      const Matrix3                    across = axes_along(axis.direction);
      std::vector<std::vector<double>> motions(n_motions,
                                               std::vector<double>(rigid.front().size(), 0.));
      for (unsigned int m = 0; m < n_motions; ++m)
        for (unsigned int c = 0; c < 3; ++c)
          for (std::size_t i = 0; i < motions[m].size(); ++i)
            motions[m][i] += across(c, m % 2) * (m < 2 ? rigid[c][i] : rigid[3 + c][i] / size);
      return motions;
    }

    /** Values at the points of a part. */
    Eigen::Map<const Eigen::RowVectorXd> of_part(const std::vector<double> &field,
                                                 const FemSpace::Part      &part)
    {
      return {field.data() + 3 * std::size_t(part.first_point), 3 * Eigen::Index(part.n_points)};
    }
  } // namespace

  std::vector<StandingMotion> find_standing_motions(const SystemMatrices       &matrices,
                                                    const FemMatrix            &stiffness,
                                                    const SystemMatrices::Rate &rate)
  {
    const FemSystem            &system   = matrices.system();
    const FemSpace             &d        = system.space();
    const Eigen::MatrixXd       bearings = system.rings().stiffness(rate);
    std::vector<StandingMotion> all;
    for (const FemSpace::Part &part : d.parts())
      {
        if (rate(part.body) == 0. || !hangs_in_bearings(d.model(), part.body))
          continue;
        const SparseMatrix K(stiffness);
        const auto         motions = make_motions(d, part);
        const Eigen::Index n       = 3 * Eigen::Index(part.n_points);
        Eigen::MatrixXd    r(n_motions, n), w(n_motions, n), mean(n_motions, n);
        for (unsigned int m = 0; m < n_motions; ++m)
          {
            // 1. Forces of the motion but for those of the bearings. A body without constraints has
            // its displacements for unknowns.
            std::vector<double> forces = system.expand(K.apply(system.restrict_field(motions[m])));
            system.rings().add_forces(-bearings * system.rings().displacement(motions[m]), forces);
            r.row(m)    = of_part(motions[m], part);
            w.row(m)    = of_part(forces, part);
            mean.row(m) = of_part(system.expand(matrices.apply_mass(motions[m])), part);
          }
        // 2. Mean motions, weighted with mass: Phi = (r^T M r)^-1 r^T M.
        mean                          = (mean * r.transpose()).eval().inverse() * mean;
        const Eigen::MatrixXd work    = r * w.transpose();
        const double          measure = work.cwiseAbs().maxCoeff();
        if (measure == 0.)
          continue;
        // 3. Rows Phi u and, in the same unit, w u.
        StandingMotion standing;
        standing.body = part.body;
        for (unsigned int p = part.first_point; p < part.first_point + part.n_points; ++p)
          standing.points.push_back(p);
        standing.motion.resize(2 * n_motions, n);
        standing.motion << mean, w / measure;
        const Eigen::MatrixXd one = measure * Eigen::MatrixXd::Identity(n_motions, n_motions);
        standing.stiffness.resize(2 * n_motions, 2 * n_motions);
        standing.stiffness << .5 * (work + work.transpose()), -one, -one,
          Eigen::MatrixXd::Zero(n_motions, n_motions);
        all.push_back(standing);
      }
    return all;
  }
} // namespace vfife
