// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/system/bearing_rings.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/model/constraints/supports.h>

namespace vfife
{
  namespace
  {
    BearingRing make_ring(const Discretization            &discretization,
                          const Discretization::Part      &part,
                          const std::vector<unsigned int> &nodes,
                          const std::string               &owner)
    {
      if (discretization.sector_angle() > 0)
        throw InputError(owner + ": a ring needs the whole body, not one sector of it");
      BearingRing ring;
      ring.body = part.body;
      std::vector<double>  shares;
      std::vector<Vector3> places;
      for (const auto &share :
           point_area_shares(discretization.model().bodies[part.body], nodes, discretization, part))
        {
          ring.points.push_back(share.first);
          shares.push_back(share.second);
          places.push_back(discretization.points()[share.first]);
        }
      const MeanMotion         set(shares, places, owner);
      const MeanMotion::Motion at_rest = set.at_rest();
      ring.motion.resize(6, 3 * ring.points.size());
      for (std::size_t i = 0; i < ring.points.size(); ++i)
        {
          ring.motion.middleCols<3>(3 * i) = set.derivative(i, at_rest);
          // Its first three rows are the share of the point.
          ring.centre += ring.motion(0, 3 * i) * places[i];
        }
      return ring;
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

  std::vector<BearingRing> find_bearing_rings(const Discretization &discretization)
  {
    std::vector<BearingRing>   rings;
    const Model               &model     = discretization.model();
    const std::size_t          bearings  = first_bearing(model);
    const std::size_t          couplings = bearings + model.bearings.size();
    const std::vector<Matrix5> own       = model.housing.size() > 0
                                             ? make_bearing_system(model).own_stiffness()
                                             : std::vector<Matrix5>();
    for (const Bearing &bearing : model.bearings)
      if (const auto *part = discretization.find_part(bearing.body))
        {
          rings.push_back(
            make_ring(discretization, *part, bearing.nodes, "bearing \"" + bearing.name + "\""));
          BearingRing    &ring     = rings.back();
          BearingResponse response = bearing.law->linearized();
          if (!own.empty())
            response.stiffness = own[&bearing - model.bearings.data()];
          const ShaftSeat seat(bearing.axes);
          ring.support        = bearings + (&bearing - model.bearings.data());
          ring.stiffness      = seat.in_space(response.stiffness, 0.);
          ring.mean_stiffness = seat.in_space(mean_over_turns(response.stiffness), 0.);
          // Undisplaced, a load is force and moment along the axes.
          const Wrench preload   = seat.of_load(response.load, MeanMotion::Motion());
          ring.preload.head<3>() = preload.force;
          ring.preload.tail<3>() = preload.moment;
        }
    for (const Coupling &coupling : model.couplings)
      if (const auto *part = discretization.find_part(coupling.body))
        {
          rings.push_back(
            make_ring(discretization, *part, coupling.nodes, "coupling \"" + coupling.name + "\""));
          BearingRing &ring = rings.back();
          ring.support      = couplings + (&coupling - model.couplings.data());
          // About the axis: the same in all axes that turn about it.
          const Vector3 &axis = model.bodies[coupling.body].axis.direction;
          ring.stiffness.setZero();
          ring.stiffness.bottomRightCorner<3, 3>() = coupling.stiffness * axis * axis.transpose();
          ring.mean_stiffness                      = ring.stiffness;
        }
    return rings;
  }
} // namespace vfife
