// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_support_leads_h
#define vfife_output_measures_support_leads_h

#include <vfife/model/model.h>
#include <vfife/output/measures/body_ring.h>

#include <array>
#include <optional>
#include <vector>

namespace vfife
{
  /** Parts of the transmission error of a loaded pair on shafts [rad]: what the shafts of both
   * members do without turning about their axes, taken to the mean contact. */
  struct SupportParts
  {
    double bearings = 0; ///< the rigid motion of each shaft that its bearings' displacements make
    double bending  = 0; ///< the motion of the bores beyond that
  };

  /** What shafts in bearings make of the transmission error, of one state; differences of two
   * states are the parts. Bodies without bearings make nothing. */
  class SupportLeads
  {
  public:
    /** The model must have a transmission and outlive this. */
    explicit SupportLeads(const Model &model);

    /** In the drive direction, at the mean contact [rad]. */
    struct Leads
    {
      double hub        = 0; ///< of the rigid motions of both bores
      double bearings   = 0; ///< of those that the displacements in the bearings make
      double driven_hub = 0; ///< of hub, the driven member's
    };

    /** Turns about the axes count for nothing. */
    Leads measure(const RingMotions &motion_of) const;

    /** From the spun, unloaded state to the loaded one. */
    static SupportParts find_parts(const Leads &spun, const Leads &loaded);

  private:
    /** Of a bearing. */
    struct Seat
    {
      BodyRing                    ring;
      Eigen::Matrix<double, 6, 6> stiffness; ///< fixed frame
    };
    struct Member
    {
      std::optional<BodyRing> bore;
      std::vector<Seat>       seats;
    };

    void add_member(unsigned int body, const std::vector<unsigned int> &bore);

    const Model          &model_;
    std::array<Member, 2> members_; ///< by body
  };
} // namespace vfife

#endif
