// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_gear_pair_h
#define vfife_gear_spiral_bevel_gear_pair_h

#include <vfife/gear/spiral_bevel/gear_member.h>
#include <vfife/gear/spiral_bevel/mean_contact.h>

#include <array>

namespace vfife
{
  /**
   * A mounted spiral bevel pair. Fixed frame: common apex at the origin, gear axis (apex to back)
   * +z, pinion axis in the plane y = 0 at the shaft angle, +x for 90 deg; positive rotations of the
   * placements turn about + the own axis, so the pair runs with rot2' = -rot1' z1/z2. Derivations
   * in doc/theory/gear.md.
   */
  class GearPair
  {
  public:
    /** Completes and checks the options, derives what is missing; InputError when the flanks cannot
     * mesh. */
    explicit GearPair(const GearPairOptions &options);

    /** The options with everything derived filled in. */
    const GearPairOptions &options() const;

    /** Tooth 0 of both members are the teeth of the drive side's mean contact. */
    const GearMember &pinion() const;
    const GearMember &gear() const;
    FlankSide         pinion_side(MeshSide side) const;
    FlankSide         gear_side(MeshSide side) const;

    /** Gear speed over pinion speed, z1/z2. */
    double speed_ratio() const;

    const MeanContact &mean_contact(MeshSide side) const;

    /** Rotations at the drive side's mean contact: without mounting errors both members touch there
     * [rad]. */
    double rot1_reference() const;
    double rot2_reference() const;

    /** DELTA: turn of the pinion's lower flank against the upper one, which sets the backlash
     * [rad]. */
    double thickness_turn() const;

    /** Gear rotation from drive to coast contact with the pinion held, at the mean point [rad]. */
    double backlash_angle() const;

    /** Body frame to fixed frame; rotation is rot1 or rot2 [rad]. */
    RigidMotion pinion_placement(double rotation) const;
    RigidMotion gear_placement(double rotation) const;

    /** The equations of contact between the flanks of a side, with the errors that all teeth
     * share. */
    FlankContact flank_contact(MeshSide side) const;

    /** The same with all errors of two teeth; each flank stands where the generated one does. */
    FlankContact
    flank_contact(MeshSide side, unsigned int pinion_tooth, unsigned int gear_tooth) const;

  private:
    /** What is derived before the members can be put together. */
    struct Design
    {
      GearPairOptions            options;
      FlankSide                  pinion_upper = FlankSide::concave, gear_upper = FlankSide::convex;
      std::array<MeanContact, 2> mean_contact;
      double                     thickness_turn = 0, backlash_angle = 0;

      Flank gear_flank(FlankSide side) const;
    };

    FlankContact contact_of(const Flank &pinion, const Flank &gear) const;

    static Design derive(const GearPairOptions &options);
    /** Its upper flank turned to its place; where the backlash leaves no tooth, says so. */
    static GearMember make_pinion(const Design &design);

    Design      design_;
    RigidMotion pinion_frame_, gear_frame_; ///< with the mounting errors
    GearMember  pinion_, gear_;
  };
} // namespace vfife

#endif
