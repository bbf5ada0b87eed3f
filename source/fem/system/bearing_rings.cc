// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/system/bearing_rings.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/constraints/supports.h>
#include <vfife/model/load_shares.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    using Matrix6 = Eigen::Matrix<double, 6, 6>;

    /** A on displacements and turns alike. */
    Matrix6 on_both(const Matrix3 &A)
    {
      Matrix6 both                   = Matrix6::Zero();
      both.topLeftCorner<3, 3>()     = A;
      both.bottomRightCorner<3, 3>() = A;
      return both;
    }
  } // namespace

  Eigen::VectorXd PointMotion::displacement(const std::vector<double> &u) const
  {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(motion.rows());
    for (std::size_t i = 0; i < points.size(); ++i)
      sum += motion.middleCols<3>(3 * i) *
             Eigen::Map<const Vector3>(u.data() + 3 * std::size_t(points[i]));
    return sum;
  }

  void PointMotion::add_forces(const Eigen::VectorXd &load, std::vector<double> &forces) const
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      Eigen::Map<Vector3>(forces.data() + 3 * std::size_t(points[i])) +=
        motion.middleCols<3>(3 * i).transpose() * load;
  }

  BearingRings::BearingRings(const FemSpace    &space,
                             const HousingLaw   housing,
                             const unsigned int harmonic)
    : space_(space)
    , harmonic_(harmonic)
  {
    // Sums over the sectors leave nothing of a ring's mean motion in higher harmonics.
    if (harmonic > 1)
      return;
    add_bearings(housing);
    add_couplings();
  }

  BearingRing BearingRings::make_ring(const unsigned int               b,
                                      const std::vector<unsigned int> &nodes,
                                      const SelectedFaces             &faces,
                                      const std::string               &owner) const
  {
    const FemSpace::Part &part = *space_.find_part(b);
    const Body           &body = space_.model().bodies[b];
    BearingRing           ring;
    ring.body = b;
    if (space_.sector_angle() > 0)
      {
        take_sector(body, nodes, faces, owner, ring);
        return ring;
      }
    std::vector<double>  shares;
    std::vector<Vector3> places;
    for (const auto &share : point_area_shares(body, nodes, faces, space_, part))
      {
        ring.points.push_back(share.first);
        shares.push_back(share.second);
        places.push_back(space_.points()[share.first]);
      }
    const MeanMotion         set(shares, places, owner);
    const MeanMotion::Motion at_rest = set.at_rest();
    ring.centre                      = set.centre();
    ring.motion.resize(6, 3 * ring.points.size());
    for (std::size_t i = 0; i < ring.points.size(); ++i)
      ring.motion.middleCols<3>(3 * i) = set.derivative(i, at_rest);
    return ring;
  }

  void BearingRings::take_sector(const Body                      &body,
                                 const std::vector<unsigned int> &nodes,
                                 const SelectedFaces             &faces,
                                 const std::string               &owner,
                                 BearingRing                     &ring) const
  {
    require_all_copies(body, nodes, owner);
    const MeanMotion         set(compute_area_shares(body, nodes, faces),
                         find_undeformed_places(body, nodes),
                         owner);
    const MeanMotion::Motion at_rest = set.at_rest();
    ring.centre                      = set.centre();
    // The whole ring moves by the sum over the sectors of Re(R^k B z exp(i h k alpha)), B the part
    // of sector 0: along the axis a with h = 0, in h = 1 along e = (x + i y)/sqrt(2) across it,
    // R e = e exp(-i alpha). Its energy in springs alike across the axis is that of sqrt(N) a a^T B
    // z, and of sqrt(2 N) Re(e e^H B z), in the sector.
    const double  n     = body.structure().n_sectors();
    const Vector3 a     = compute_sector_axis(body).direction;
    const Matrix3 axes  = axes_along(a);
    const Matrix6 along = on_both(std::sqrt(n) * a * a.transpose());
    const Matrix6 real =
      on_both(std::sqrt(2. * n) * .5 * (Matrix3::Identity() - a * a.transpose()));
    const Matrix6 quarter =
      on_both(std::sqrt(2. * n) * .5 *
              (axes.col(1) * axes.col(0).transpose() - axes.col(0) * axes.col(1).transpose()));
    const unsigned int                       n_points = space_.n_points();
    std::vector<Eigen::Matrix<double, 6, 3>> columns;
    const auto add = [&](const unsigned int point, const Eigen::Matrix<double, 6, 3> &motion) {
      ring.points.push_back(point);
      columns.push_back(motion);
    };
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (body.structure().sector_of(nodes[i]) == 0)
        {
          const Eigen::Matrix<double, 6, 3> B = set.derivative(i, at_rest);
          if (harmonic_ == 0)
            add(nodes[i], along * B);
          else
            {
              // Re((real + i quarter) B (u + i v))
              add(nodes[i], real * B);
              add(n_points + nodes[i], -quarter * B);
            }
        }
    ring.motion.resize(6, 3 * ring.points.size());
    for (std::size_t i = 0; i < columns.size(); ++i)
      ring.motion.middleCols<3>(3 * i) = columns[i];
  }

  void BearingRings::add_bearings(const HousingLaw housing)
  {
    const Model                &model = space_.model();
    const std::size_t           first = first_bearing(model);
    const BearingSystem::Linear law   = make_bearing_system(model).linearized();
    std::vector<std::size_t>    seats;
    for (std::size_t b = 0; b < model.bearings.size(); ++b)
      if (const Bearing &bearing = model.bearings[b]; space_.find_part(bearing.body) != nullptr)
        {
          rings_.push_back(make_ring(
            bearing.body, bearing.nodes, bearing.faces, "bearing \"" + bearing.name + "\""));
          rings_.back().support = first + b;
          seats.push_back(b);
        }
    const std::size_t n = seats.size();
    if (housing == HousingLaw::joins_seats && model.housing.size() > 0)
      n_joined_ = n;
    stiffness_ = Eigen::MatrixXd::Zero(6 * n, 6 * n);
    preload_   = Eigen::VectorXd::Zero(6 * n);
    for (std::size_t i = 0; i < n; ++i)
      {
        preload_.segment<6>(6 * i) = law.load.segment<6>(6 * seats[i]);
        for (std::size_t j = 0; j < n; ++j)
          if (joins(i, j))
            stiffness_.block<6, 6>(6 * i, 6 * j) =
              law.stiffness.block<6, 6>(6 * seats[i], 6 * seats[j]);
      }
  }

  void BearingRings::add_couplings()
  {
    const Model      &model = space_.model();
    const std::size_t first = first_bearing(model) + model.bearings.size();
    for (std::size_t c = 0; c < model.couplings.size(); ++c)
      {
        const Coupling &coupling = model.couplings[c];
        if (space_.find_part(coupling.body) == nullptr)
          continue;
        const auto row = static_cast<Eigen::Index>(6 * rings_.size());
        rings_.push_back(make_ring(
          coupling.body, coupling.nodes, coupling.faces, "coupling \"" + coupling.name + "\""));
        rings_.back().support = first + c;
        stiffness_.conservativeResizeLike(Eigen::MatrixXd::Zero(row + 6, row + 6));
        preload_.conservativeResizeLike(Eigen::VectorXd::Zero(row + 6));
        const Vector3 &axis                  = model.bodies[coupling.body].axis.direction;
        stiffness_.bottomRightCorner<3, 3>() = coupling.stiffness * axis * axis.transpose();
      }
  }

  Eigen::MatrixXd BearingRings::mean_over_turns(const Eigen::MatrixXd &K, const Rate &rate) const
  {
    const Model    &model = space_.model();
    Eigen::MatrixXd mean  = K;
    for (std::size_t i = 0; i < rings_.size(); ++i)
      for (std::size_t j = 0; j < rings_.size(); ++j)
        {
          const unsigned int of[2] = {rings_[i].body, rings_[j].body};
          Matrix6            block = K.block<6, 6>(6 * i, 6 * j);
          if (of[0] == of[1] && rate(of[0]) != 0)
            {
              // T K T^T has harmonics up to the second: four turns are all.
              Matrix6 sum = Matrix6::Zero();
              for (unsigned int k = 0; k < 4; ++k)
                {
                  const Matrix6 T =
                    on_both(rotation_about(model.bodies[of[0]].axis.direction, .5 * pi * k));
                  sum += .25 * T * block * T.transpose();
                }
              block = sum;
            }
          else if (of[0] != of[1])
            {
              // Of bodies that turn by themselves only what lies along the axis is always there.
              const auto lasting = [&](const unsigned int body) {
                const Vector3 &a = model.bodies[body].axis.direction;
                return on_both(rate(body) != 0 ? Matrix3(a * a.transpose())
                                               : Matrix3(Matrix3::Identity()));
              };
              block = (lasting(of[0]) * block * lasting(of[1])).eval();
            }
          mean.block<6, 6>(6 * i, 6 * j) = block;
        }
    return mean;
  }

  Eigen::MatrixXd BearingRings::stiffness(const Rate &rate) const
  {
    const Eigen::MatrixXd K = mean_over_turns(stiffness_, rate);
    if (space_.sector_angle() > 0)
      require_isotropic(K);
    return K;
  }

  void BearingRings::require_isotropic(const Eigen::MatrixXd &K) const
  {
    const Eigen::MatrixXd mean  = mean_over_turns(K, [](unsigned int) { return 1.; });
    const auto            first = first_bearing(space_.model());
    for (std::size_t i = 0; i < rings_.size(); ++i)
      {
        // Displacements, turns and what joins them have units of their own.
        const double way  = K.diagonal().segment<3>(6 * i).maxCoeff(),
                     turn = K.diagonal().segment<3>(6 * i + 3).maxCoeff();
        for (std::size_t j = 0; j < rings_.size(); ++j)
          for (unsigned int c = 0; c < 36; ++c)
            {
              const std::size_t row = 6 * i + c / 6, column = 6 * j + c % 6;
              const double      other =
                (c % 6 < 3 ? K.diagonal().segment<3>(6 * j) : K.diagonal().segment<3>(6 * j + 3))
                  .maxCoeff();
              if (std::abs(K(row, column) - mean(row, column)) >
                  1e-6 * std::sqrt((c < 18 ? way : turn) * other))
                throw InputError("bearing \"" +
                                 space_.model().bearings[rings_[i].support - first].name +
                                 "\": its stiffness differs between directions across the axis, so "
                                 "that it couples harmonics of one sector. At rest use the whole "
                                 "body (cyclic symmetry = no)");
            }
      }
  }

  Eigen::VectorXd BearingRings::displacement(const std::vector<double> &u) const
  {
    Eigen::VectorXd all(6 * rings_.size());
    for (std::size_t i = 0; i < rings_.size(); ++i)
      all.segment<6>(6 * i) = rings_[i].displacement(u);
    return all;
  }

  void BearingRings::add_forces(const Eigen::VectorXd &load, std::vector<double> &forces) const
  {
    for (std::size_t i = 0; i < rings_.size(); ++i)
      rings_[i].add_forces(load.segment<6>(6 * i), forces);
  }
} // namespace vfife
