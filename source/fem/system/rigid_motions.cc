// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/system/bearing_rings.h>
#include <vfife/fem/system/rigid_motions.h>
#include <vfife/model/constraints/held_direction.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <cmath>

namespace vfife
{
  namespace
  {
    Eigen::MatrixXd as_columns(const std::vector<std::vector<double>> &fields)
    {
      Eigen::MatrixXd columns(fields.empty() ? 0 : fields.front().size(), fields.size());
      for (std::size_t k = 0; k < fields.size(); ++k)
        columns.col(k) = Eigen::Map<const Eigen::VectorXd>(fields[k].data(), fields[k].size());
      return columns;
    }
  } // namespace

  Eigen::MatrixXd
  find_free_coefficients(const FemSpace &space, const FemSpace::Part &part, const Vector3 &centre)
  {
    const auto free = find_free_motions(space, part);
    if (free.empty())
      return Eigen::MatrixXd(6, 0);
    return as_columns(make_rigid_motions(space, part, centre))
      .colPivHouseholderQr()
      .solve(as_columns(free));
  }

  std::vector<std::vector<double>>
  make_rigid_motions(const FemSpace &space, const FemSpace::Part &part, const Vector3 &centre)
  {
    std::vector<std::vector<double>> motions(
      6, std::vector<double>(3 * static_cast<std::size_t>(space.n_points()), 0.));
    for (std::size_t p = part.first_point; p < part.first_point + part.n_points; ++p)
      for (unsigned int d = 0; d < 3; ++d)
        {
          // A way of 1 mm along d, and a small turn of 1 rad about d.
          motions[d][3 * p + d] = 1.;
          const Vector3 turn    = Vector3::Unit(d).cross(space.points()[p] - centre);
          for (unsigned int c = 0; c < 3; ++c)
            motions[3 + d][3 * p + c] = turn[c];
        }
    return motions;
  }

  std::vector<std::vector<double>> find_free_motions(const FemSpace       &space,
                                                     const FemSpace::Part &part)
  {
    const Model &model  = space.model();
    Vector3      centre = Vector3::Zero();
    for (unsigned int p = part.first_point; p < part.first_point + part.n_points; ++p)
      centre += space.points()[p] / part.n_points;
    // Rotations are divided by the largest distance from the centre:
    // all six have the same magnitude.
    double size = 0;
    for (unsigned int p = part.first_point; p < part.first_point + part.n_points; ++p)
      size = std::max(size, (space.points()[p] - centre).norm());

    // Sum of squares of what the constraints forbid, for translations and rotations times size.
    // A hub that turns rigidly forbids nothing more than free rotation: rigid motions turn all
    // nodes by one angle anyway.
    Eigen::Matrix<double, 6, 6> forbidden = Eigen::Matrix<double, 6, 6>::Zero();
    const auto                  forbid    = [&](const unsigned int p, const Matrix3 &held) {
      Eigen::Matrix<double, 3, 6> motion;
      for (unsigned int d = 0; d < 3; ++d)
        {
          motion.col(d) = Vector3::Unit(d);
          motion.col(3 + d) = Vector3::Unit(d).cross(space.points()[p] - centre) / size;
        }
      forbidden += motion.transpose() * held * motion / part.n_points;
    };
    for (const Constraint &constraint : model.constraints)
      if (constraint.body == part.body)
        for (const unsigned int p : space.points_of(part, constraint.nodes))
          forbid(p, compute_held_projector(constraint, model.bodies[part.body], space.points()[p]));
    for (const Load &load : model.loads)
      if (load.kind == LoadKind::spring && load.body == part.body)
        for (const unsigned int p : space.points_of(part, load.nodes))
          forbid(p, Matrix3(load.vector.cwiseSign().asDiagonal()));
    const auto rigid = make_rigid_motions(space, part, centre);
    // Bearings and couplings hold what has a stiffness, each by its own measure of it: one of ways
    // and one of turns, whatever the axes of the bearing are.
    if (space.sector_angle() == 0)
      {
        const BearingRings    rings(space, HousingLaw::own_seats);
        const Eigen::MatrixXd K = rings.stiffness([](unsigned int) { return 0.; });
        for (std::size_t r = 0; r < rings.list().size(); ++r)
          {
            const BearingRing &ring = rings.list()[r];
            if (ring.body != part.body)
              continue;
            const Eigen::Matrix<double, 6, 6> stiffness = K.block<6, 6>(6 * r, 6 * r);
            Eigen::Matrix<double, 6, 6>       motion;
            for (unsigned int d = 0; d < 6; ++d)
              motion.col(d) = ring.displacement(rigid[d]) / (d < 3 ? 1. : size);
            // Turns in units of the body's size, as the motions are.
            Eigen::Matrix<double, 6, 1> scale = Eigen::Matrix<double, 6, 1>::Zero();
            for (unsigned int block = 0; block < 6; block += 3)
              {
                const double measure = stiffness.diagonal().segment<3>(block).maxCoeff();
                if (measure > 0)
                  scale.segment<3>(block).setConstant((block == 0 ? 1. : size) /
                                                      std::sqrt(measure));
              }
            forbidden += motion.transpose() * scale.asDiagonal() * stiffness * scale.asDiagonal() *
                         motion / part.n_points;
          }
      }
    // Motions that nothing forbids are its kernel.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> modes(forbidden);
    std::vector<std::vector<double>>                                 motions;
    for (unsigned int m = 0; m < 6; ++m)
      {
        // Far below what one held node gives, far above round-off.
        if (modes.eigenvalues()[m] > 1e-11 / part.n_points)
          continue;
        motions.emplace_back(rigid[0].size(), 0.);
        for (unsigned int d = 0; d < 6; ++d)
          for (std::size_t i = 0; i < motions.back().size(); ++i)
            motions.back()[i] +=
              modes.eigenvectors()(d, m) * (d < 3 ? 1. : 1. / size) * rigid[d][i];
      }
    return motions;
  }
} // namespace vfife
