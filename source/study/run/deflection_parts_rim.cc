// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What the bending of the rim has of a deflection.
#include <vfife/base/process/communicator.h>
#include <vfife/fem/cyclic/roots_of_unity.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/study/run/deflection_parts.h>

#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace vfife
{
  namespace
  {
    /** Numbers of a symmetric system of six unknowns and its right side. */
    constexpr unsigned int n_numbers = 42;
  } // namespace

  RimBending::RimBending(const Model &model, const unsigned int largest)
    : model_(model)
    , n_sectors_(model.bodies[model.transmission->driven].structure().n_sectors())
    , largest_(std::min(largest, (model.transmission->driven_teeth - 1) / 2))
  {
    const Transmission &t    = *model.transmission;
    const Body         &body = model.bodies[t.driven];
    if (n_sectors_ != t.driven_teeth)
      return;
    // Nodes of a sector lie around its middle: the sector whose undeformed angle is the nearest to
    // that of the contact has the contact's tooth. Nodes have the numbers of their sectors.
    double nearest = std::numeric_limits<double>::infinity();
    for (const unsigned int node :
         body.mesh().surfaces.at(model.contacts.front().master_surface).nodes)
      {
        const double distance =
          (body.placement(body.node_positions()[node]) - t.contact_point).norm();
        if (distance < nearest)
          {
            nearest         = distance;
            contact_sector_ = body.structure().sector_of(node);
          }
      }
    for (const unsigned int node : t.driven_rim)
      sectors_.push_back(body.structure().sector_of(node));
  }

  Vector3 RimBending::measure(const State &state, const Communicator &communicator) const
  {
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    if (sectors_.empty())
      return Vector3::Zero();
    const Transmission &t    = *model_.transmission;
    const Body         &body = model_.bodies[t.driven];
    // Sectors follow each other in the sense of the body's axis of rotation or against it.
    const double alpha = compute_sector_sense(body) * 2. * pi / n_sectors_;
    const auto   turn  = [&](const unsigned int sector) {
      return rotation_about(body.axis.direction, alpha * sector);
    };

    // 1. Least squares of u = shift + turn x r in each sector: as of the whole rim.
    std::vector<double> sums(n_numbers * n_sectors_, 0.);
    for (std::size_t i = 0; i < sectors_.size(); ++i)
      {
        const unsigned int  node  = t.driven_rim[i];
        const std::uint32_t local = state.partition->find_owned(body.first_node + node);
        if (local == Partition::absent)
          continue;
        const Vector3 start = body.placement(body.node_positions()[node]),
                      r     = start - body.axis.point;
        Eigen::Matrix<double, 3, 6> motion;
        motion.leftCols<3>() = Matrix3::Identity();
        for (unsigned int c = 0; c < 3; ++c)
          motion.col(3 + c) = Vector3::Unit(c).cross(r);
        double      *numbers = &sums[n_numbers * sectors_[i]];
        const double mass    = body.node_masses()[node];
        Eigen::Map<Matrix6>{numbers} += mass * motion.transpose() * motion;
        Eigen::Map<Vector6>{numbers + 36} +=
          mass * motion.transpose() * (state.node_position(local) - start);
      }
    communicator.sum(sums);

    // 2. Displacements of the sectors' own contact points, turned back onto sector 0, as waves.
    const Vector3 first = turn(contact_sector_).transpose() * (t.contact_point - body.axis.point);
    const RootsOfUnity phase(n_sectors_);
    Vector3            bending = Vector3::Zero();
    for (unsigned int k = 0; k < n_sectors_; ++k)
      {
        const double *numbers = &sums[n_numbers * k];
        const Vector6 motion  = Eigen::Map<const Matrix6>(numbers).fullPivLu().solve(
          Eigen::Map<const Vector6>(numbers + 36));
        const Matrix3 here = turn(k);
        const Vector3 d =
          here.transpose() * (motion.head<3>() + Vector3(motion.tail<3>()).cross(here * first));
        // What sector k has of the waves in the contact's sector.
        double weight = 0;
        for (unsigned int n = 2; n <= largest_; ++n)
          weight += 2. * phase(n, contact_sector_ - static_cast<int>(k)).real() / n_sectors_;
        bending += weight * d;
      }
    return turn(contact_sector_) * bending;
  }
} // namespace vfife
