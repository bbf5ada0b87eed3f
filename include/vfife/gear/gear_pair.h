// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_gear_pair_h
#define vfife_gear_gear_pair_h

#include <vfife/gear/findings.h>
#include <vfife/gear/flank_contact.h>
#include <vfife/gear/gear_member.h>
#include <vfife/gear/pair_proposal.h>

#include <array>
#include <string>

namespace vfife
{
  /** What the user gives of one member: content of "Gear pair/Pinion" and "Gear pair/Gear". */
  struct GearMemberOptions
  {
    double          cutter_diameter = 0; ///< twice the mean of the point radii; 0: not given [mm]
    double          point_width     = 0; ///< outside less inside point radius; 0: not given [mm]
    Blank           blank;
    MachineSettings both{no_settings()}; ///< holds for both flanks where it is not 0
    MachineSettings concave{Blade::outside};
    MachineSettings convex{Blade::inside};

    void declare(dealii::ParameterHandler &prm);
    /** With the settings of both flanks, and point radii from diameter and width, in each flank. */
    GearMemberOptions spread() const;
    /** Whether one cutter in one position cuts both flanks of a slot at once. */
    bool is_spread_blade() const;
    /** Adds what is wrong with the member alone (@p section: path of its entries). */
    void examine(const std::string &section, Findings &findings) const;
    /** Adds contradictions between "Both flanks" and the sections of the flanks, as given. */
    void examine_spread(const std::string &section, Findings &findings) const;

  private:
    static MachineSettings no_settings();
  };

  /** What the user gives of a pair: content of "Gear pair" without the bodies and meshes. */
  struct GearPairOptions
  {
    PairProposal      proposal; ///< where given, blanks and settings follow from it
    GearMemberOptions pinion, gear;
    double            shaft_angle = pi / 2; ///< [rad]
    double            backlash    = 0.12;   ///< normal to the flanks at the mean point [mm]

    /** Mounting errors: they move the members after the pair has been designed without them. */
    double pinion_axial_shift = 0; ///< > 0 away from the apex [mm]
    double gear_axial_shift   = 0; ///< > 0 away from the apex [mm]
    double offset             = 0; ///< of the pinion axis along +y of the fixed frame [mm]
    double shaft_angle_error  = 0; ///< > 0 opens the shaft angle [rad]

    /** Declares Pinion and Gear {Blank, Concave flank, Convex flank} and Mounting in the present
     * section. */
    void declare(dealii::ParameterHandler &prm);

    /** With what follows from the rest: pitch angles, one point radius of a spread-blade gear, its
     * ratio of roll. */
    GearPairOptions completed() const;

    /** What is missing, impossible or contradictory, after completing; all of it, causes first. */
    Findings examine(const std::string &section = "Gear pair") const;

    /** Throws InputError for all findings that stop the program. */
    void check(const std::string &section = "Gear pair") const;
  };

  /** Pitch angle by the numbers of teeth: tan d = sin(shaft angle) / (other/own + cos(shaft angle))
   * [rad]. */
  double pitch_angle_of(double own_teeth, double other_teeth, double shaft_angle);

  /**
   * Sum of the dedendum angles with which slots cut by spread blades taper as the teeth do (duplex
   * taper) [rad]:
   *   (pi m / (2 A_m)) (1 - A_m sin b / r) / (tan al cos b),   m the transverse module at A_m
   */
  double duplex_dedendum_angles(const Blank &gear,
                                double       cutter_radius,
                                double       spiral_angle,
                                double       blade_angle);

  /** Ratio of roll with which cradle and blank share the velocity along the pitch generatrix: the
   * cradle's axis is normal to the root cone. */
  double conjugate_ratio_of_roll(const Blank &blank, const MachineSettings &settings);

  /** Drive: the pinion turns about + its axis (apex to back) and pushes the gear. */
  enum class MeshSide
  {
    drive,
    coast
  };

  /**
   * Where the unloaded flanks touch with the exact speed ratio, members mounted without errors.
   * Points are those of the *generated* flanks, in the body frames (the pinion's lower flank before
   * it is turned by thickness_turn()).
   */
  struct MeanContact
  {
    double       rot1 = 0, rot2 = 0; ///< rotations at which the generated flanks touch [rad]
    SurfacePoint pinion, gear;
    Vector2      pinion_L_h, gear_L_h; ///< cone coordinates (L, h) [mm]
    Vector3      position, normal;     ///< fixed frame; normal out of the gear, into the pinion
    double       arm           = 0;    ///< |(P x n)_z| about the gear axis [mm]
    double       ratio_of_roll = 0;    ///< of the pinion flank
  };

  /**
   * A mounted spiral bevel pair. Fixed frame: common apex at the origin, gear axis (apex to back)
   * +z, pinion axis in the plane y = 0 at the shaft angle, +x for 90 deg; positive rotations of the
   * placements turn about + the own axis, so the pair runs with rot2' = -rot1' z1/z2. Derivations
   * in doc/gear.md.
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

    /** The equations of contact between the generated flanks of a side. */
    FlankContact flank_contact(MeshSide side) const;

  private:
    /** What is derived before the members can be put together. */
    struct Design
    {
      GearPairOptions            options;
      FlankSide                  pinion_upper = FlankSide::concave, gear_upper = FlankSide::convex;
      std::array<MeanContact, 2> mean_contact;
      double                     thickness_turn = 0, backlash_angle = 0;

      MachineSettings &pinion_settings(FlankSide side);
      Flank            gear_flank(FlankSide side) const;
    };

    static Design derive(const GearPairOptions &options);
    /** Its upper flank turned to its place; where the backlash leaves no tooth, says so. */
    static GearMember make_pinion(const Design &design);
    /** Finds the mean contact of a side and fills in the pinion's ratio of roll if it is not given.
     */
    static MeanContact find_mean_contact(Design &design, MeshSide side);

    Design      design_;
    RigidMotion pinion_frame_, gear_frame_; ///< with the mounting errors
    GearMember  pinion_, gear_;
  };
} // namespace vfife

#endif
