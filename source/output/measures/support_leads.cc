// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/bearing/shaft_seat.h>
#include <vfife/model/load_shares.h>
#include <vfife/output/measures/support_leads.h>

#include <Eigen/QR>

namespace vfife
{
  SupportLeads::SupportLeads(const Model &model)
    : model_(model)
  {
    const Transmission &t = *model.only_transmission();
    add_member(t.driver, t.driver_bore);
    add_member(t.driven, t.driven_bore);
  }

  void SupportLeads::add_member(const unsigned int b, const std::vector<unsigned int> &bore)
  {
    // Bodies that no bearing holds have bores that turn only.
    const Body &body = model_.bodies[b];
    if (!body.floats)
      return;
    members_[b].bore.emplace(body, bore, "bore of the " + body.name());
    for (const Bearing &bearing : model_.bearings)
      if (bearing.body == b)
        members_[b].seats.push_back(
          {BodyRing(body,
                    bearing.nodes,
                    compute_area_shares(body, bearing.nodes, bearing.faces),
                    "bearing \"" + bearing.name + "\""),
           ShaftSeat(bearing.axes).in_space(bearing.law->linearized().stiffness, 0.)});
  }

  SupportLeads::Leads SupportLeads::measure(const RingMotions &motion_of) const
  {
    Leads leads;
    using Vector6         = Eigen::Matrix<double, 6, 1>;
    const Transmission &t = *model_.only_transmission();
    for (const unsigned int b : {t.driver, t.driven})
      {
        const Member &member = members_[b];
        if (!member.bore)
          continue;
        const Vector3 &axis = model_.bodies[b].axis.direction;
        // Way of the mean contact along the normal where a body moves by d at a centre and its axis
        // tilts, in the drive direction; the driver's opens what the driven one's closes.
        const auto lead = [&](const Vector3 &centre, const Vector3 &d, const Vector3 &tilt) {
          return (b == t.driven ? 1. : -1.) *
                 t.contact_normal.dot(d + tilt.cross(t.contact_point - centre)) / t.arm;
        };
        const auto tilt = [&axis](const MeanMotion::Motion &motion) {
          return Vector3(axis.cross(motion.rotation * axis));
        };
        // 1. The bore.
        const MeanMotion::Motion motion = motion_of(b, *member.bore);
        const double hub = lead(member.bore->centre(), motion.displacement, tilt(motion));
        leads.hub += hub;
        leads.driven_hub += b == t.driven ? hub : 0.;
        // 2. The rigid motion (u at the bore's centre, turn) that fits the seats' best, in the
        // energy of the bearings: sum D^T K D (u, turn) = sum D^T K q.
        Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
        Vector6                     right  = Vector6::Zero();
        for (const Seat &seat : member.seats)
          {
            const MeanMotion::Motion    at_seat = motion_of(b, seat.ring);
            const Vector3               r       = seat.ring.centre() - member.bore->centre();
            Eigen::Matrix<double, 6, 6> D       = Eigen::Matrix<double, 6, 6>::Identity();
            for (unsigned int c = 0; c < 3; ++c)
              D.block<3, 1>(0, 3 + c) = Vector3::Unit(c).cross(r);
            Vector6 q;
            q << at_seat.displacement, tilt(at_seat);
            matrix += D.transpose() * seat.stiffness * D;
            right += D.transpose() * seat.stiffness * q;
          }
        // Nothing holds the turn about the axis.
        const Vector6 rigid = matrix.completeOrthogonalDecomposition().solve(right);
        leads.bearings += lead(member.bore->centre(), rigid.head<3>(), rigid.tail<3>());
      }
    return leads;
  }

  SupportParts SupportLeads::find_parts(const Leads &spun, const Leads &loaded)
  {
    const double bearings = loaded.bearings - spun.bearings;
    return {bearings, loaded.hub - spun.hub - bearings};
  }
} // namespace vfife
