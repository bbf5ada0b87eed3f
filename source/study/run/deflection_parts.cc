// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/watch/transmission_measurement.h>
#include <vfife/fem/cyclic/roots_of_unity.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>
#include <vfife/study/run/deflection_parts.h>

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  namespace
  {
    /** Standard deviation of the patch of flank whose displacement is that of the contact, over the
     * distance 2 pi p/z of flanks along their normal: 3 mm in the reference pair. */
    constexpr double patch_width = 0.42;

    /** Numbers of a symmetric system of six unknowns and its right side. */
    constexpr unsigned int n_numbers = 42;
  } // namespace

  DeflectionProbe::DeflectionProbe(const Model &model, const Communicator &communicator)
    : model_(model)
    , communicator_(communicator)
    , supports_of_(model)
    , rim_bending_of_(model, largest_wave)
  {
  }

  Vector3 DeflectionProbe::flank_displacement(const State       &state,
                                              const unsigned int b,
                                              const std::string &surface) const
  {
    // Mean over the flank around the contact: a patch of some elements, wide against the local
    // indentation and within a tooth, whatever the size of the gear.
    const Transmission &t       = *model_.only_transmission();
    const double        width   = patch_width * 2 * pi * t.arm / t.driven_teeth; // [mm]
    const Body         &body    = model_.bodies[b];
    const Vector3      &contact = t.contact_point;
    std::vector<double> sums(4, 0.);
    // u = sum w u/sum w over the nodes, w = exp(-d^2/2 width^2), d the distance from the mean
    // contact. Each node counts on the rank that owns it.
    for (const unsigned int node : body.mesh().surfaces.at(surface).nodes)
      {
        const std::uint32_t local = state.partition->find_owned(body.first_node + node);
        if (local == Partition::absent)
          continue;
        const Vector3 start  = body.placement(body.node_positions()[node]);
        const double  weight = std::exp(-0.5 * (start - contact).squaredNorm() / (width * width));
        const Vector3 u      = state.node_position(local) - start;
        for (unsigned int c = 0; c < 3; ++c)
          sums[c] += weight * u[c];
        sums[3] += weight;
      }
    communicator_.sum(sums);
    return Vector3(sums[0], sums[1], sums[2]) / sums[3];
  }

  void DeflectionProbe::fit_rim(const State &state, Shape &shape) const
  {
    const Transmission &t    = *model_.only_transmission();
    const Body         &body = model_.bodies[t.driven];
    // Least squares of u = shift + turn x r over the rim's masses: a symmetric 6 x 6 system.
    // With M = (1, e_x x r, e_y x r, e_z x r): sum m M^T M (shift, turn) = sum m M^T u, [mm],
    // [rad].
    Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> right  = Eigen::Matrix<double, 6, 1>::Zero();
    for (const unsigned int node : t.driven_rim)
      {
        const std::uint32_t local = state.partition->find_owned(body.first_node + node);
        if (local == Partition::absent)
          continue;
        const double                mass  = body.node_masses()[node];
        const Vector3               start = body.placement(body.node_positions()[node]);
        const Vector3               r     = start - body.axis.point;
        Eigen::Matrix<double, 3, 6> motion;
        motion.leftCols<3>() = Matrix3::Identity();
        for (unsigned int c = 0; c < 3; ++c)
          motion.col(3 + c) = Vector3::Unit(c).cross(r);
        matrix += mass * motion.transpose() * motion;
        right += mass * motion.transpose() * (state.node_position(local) - start);
      }
    // Both sides in one sum over the ranks: all ranks solve the same system.
    std::vector<double> sums(matrix.data(), matrix.data() + 36);
    sums.insert(sums.end(), right.data(), right.data() + 6);
    communicator_.sum(sums);
    const Eigen::Matrix<double, 6, 1> solution =
      Eigen::Map<const Eigen::Matrix<double, 6, 6>>(sums.data())
        .fullPivLu()
        .solve(Eigen::Map<const Eigen::Matrix<double, 6, 1>>(sums.data() + 36));
    shape.rim_shift = solution.head<3>();
    shape.rim_turn  = solution.tail<3>();
  }

  DeflectionProbe::Shape DeflectionProbe::measure(State &state) const
  {
    const Transmission &t = *model_.only_transmission();
    // Leads of the driven member's bore and rim from the kinematic turn [rad], the rim's rigid
    // motion and the approach of the flanks, which the arm turns into an angle.
    TransmissionMeasurement(model_, *state.partition).measure(state, communicator_);

    Shape shape;
    shape.hub_lead    = state.measured.transmission_error;
    shape.rim_lead    = state.measured.rim_transmission_error;
    shape.driven_turn = state.measured.driven_angle;
    // psi = (n . u_g - n . u_p)/p: the master flank is the driven one, the normal comes out of it.
    const ContactPair &drive = model_.contacts.front();
    shape.contact = t.contact_normal.dot(flank_displacement(state, t.driven, drive.master_surface) -
                                         flank_displacement(state, t.driver, drive.slave_surface)) /
                    t.arm;
    fit_rim(state, shape);
    shape.rim_bending = t.contact_normal.dot(rim_bending_of_.measure(state, communicator_)) / t.arm;
    shape.supports    = supports_of_.measure(
      [&](const unsigned int, const BodyRing &ring) { return ring.measure(state, communicator_); });
    return shape;
  }

  void DeflectionProbe::take_spun(State &state)
  {
    spun_ = measure(state);
  }

  void DeflectionProbe::take_partly_loaded(State &state, const double torque)
  {
    // Kept with the places of all nodes: the swing's shape is what the rest of the torque adds.
    partial_torque_   = torque;
    partial_turn_     = measure(state).driven_turn;
    partial_position_ = state.position;
  }

  Swing DeflectionProbe::compute_swing(const State &loaded, const double torque) const
  {
    // J psi^2 = sum m u . u over both bodies, u from the partly loaded state to the loaded one: the
    // driver deforms in the swing too.
    double sum = 0;
    for (const Body &body : model_.bodies)
      for (unsigned int node = 0; node < body.n_nodes(); ++node)
        {
          const std::uint32_t local = loaded.partition->find_owned(body.first_node + node);
          if (local == Partition::absent)
            continue;
          const Vector3 before = partial_position_.value(local);
          sum += body.node_masses()[node] * (loaded.node_position(local) - before).squaredNorm();
        }
    // The lag grows with the torque: positive, as is k = dT/psi.
    const double psi = partial_turn_ - loaded_turn_;
    return {(torque - partial_torque_) / psi, communicator_.sum(sum) / (psi * psi)};
  }

  double Swing::frequency() const
  {
    // f = (1/2 pi) sqrt(k/J)
    return stiffness > 0 && inertia > 0 ? std::sqrt(stiffness / inertia) / (2 * pi) : 0.;
  }

  DeflectionParts DeflectionProbe::take_loaded(State &state)
  {
    const Transmission &t      = *model_.only_transmission();
    const Axis         &axis   = model_.bodies[t.driven].axis;
    const Shape         loaded = measure(state);

    loaded_turn_ = loaded.driven_turn;

    // Differences of the loaded and the spun shape; signs and the arm as in the header.
    DeflectionParts parts;
    parts.total       = loaded.hub_lead;
    parts.centrifugal = spun_.contact;
    // Lead of the hub before its rim: what the torque adds to that of the spun state.
    parts.web_windup = (loaded.hub_lead - loaded.rim_lead) - (spun_.hub_lead - spun_.rim_lead);
    // Of the rim's rigid motion only what is no rotation about the axis, taken to the contact
    // point.
    const Vector3 turn = loaded.rim_turn - spun_.rim_turn;
    const Vector3 tilt = turn - axis.direction.dot(turn) * axis.direction;
    const Vector3 shift =
      loaded.rim_shift - spun_.rim_shift + tilt.cross(t.contact_point - axis.point);
    const double driven_hub = loaded.supports.driven_hub - spun_.supports.driven_hub;
    parts.rim_tilt          = t.contact_normal.dot(shift) / t.arm - driven_hub;
    supports_               = SupportLeads::find_parts(spun_.supports, loaded.supports);
    rim_bending_            = loaded.rim_bending - spun_.rim_bending;
    // The parts add up by definition: what the split cannot tell apart, is here.
    parts.teeth = parts.total - parts.centrifugal - parts.web_windup - parts.rim_tilt -
                  rim_bending_ - supports_.bearings - supports_.bending;
    return parts;
  }

  RimBending::RimBending(const Model &model, const unsigned int largest)
    : model_(model)
    , n_sectors_(model.bodies[model.only_transmission()->driven].structure().n_sectors())
    , largest_(std::min(largest, (model.only_transmission()->driven_teeth - 1) / 2))
  {
    const Transmission &t    = *model.only_transmission();
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
    const Transmission &t    = *model_.only_transmission();
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
