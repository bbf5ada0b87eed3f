// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_unloaded_contact_unloaded_contact_h
#define vfife_gear_unloaded_contact_unloaded_contact_h

#include <vfife/gear/spiral_bevel/gear_pair.h>

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace vfife
{
  /** Where one tooth pair touches without load. */
  struct UnloadedContactPoint
  {
    int    pair = 0;           ///< see UnloadedContact
    double rot1 = 0, rot2 = 0; ///< placements of the members [rad]
    double lag =
      0; ///< of the driven member, at the gear, against the exact ratio from the mean contact [rad]
    GeneratedPoint pinion, gear;         ///< on the generated flanks (before the turn onto a tooth)
    Vector2        pinion_L_h, gear_L_h; ///< cone coordinates [mm]
    Vector3        position, normal; ///< fixed frame [mm]; normal out of the gear, into the pinion
    bool inside = false; ///< on both flanks: between toe and heel, below the tip, above the fillet
  };

  /** What bounds a flank. */
  enum class FlankBorder
  {
    toe,
    heel,
    tip,
    fillet
  };

  /** Distances of cone coordinates (L, h) inside a flank from its edges toe, heel, tip; negative
   * beyond them [mm]. */
  std::array<double, 3> edge_distances(const Blank &blank, const Vector2 &L_h);

  /** Distances of a point inside a flank from its borders, in the order of FlankBorder; negative
   * beyond them [mm]. */
  std::array<double, 4> border_distances(const Blank          &blank,
                                         const Flank          &flank,
                                         const GeneratedPoint &point,
                                         const Vector2        &L_h);

  /** A border of one of both flanks. */
  struct PairBorder
  {
    bool        on_pinion = false;
    FlankBorder border    = FlankBorder::toe;

    std::string name() const; ///< "gear tip", "pinion toe"...
  };

  /** The numbers of the teeth of tooth pair @p k (see UnloadedContact): pinion, gear. */
  std::pair<unsigned int, unsigned int> teeth_of_pair(const GearPair &pair, MeshSide side, int k);

  /**
   * Unloaded tooth contact analysis of one side of a pair (method: Litvin & Fuentes;
   * doc/theory/gear.md).
   *
   * Tooth pair k: pinion tooth k with gear tooth -k (drive) or 1 - k (coast); pair 0 touches at
   * the mean contact, pair k one pinion pitch of rotation earlier than pair k - 1. Teeth are taken
   * to be equal.
   */
  class UnloadedContact
  {
  public:
    /** @p teeth: the tooth pair of whose two teeth all flanks have the errors; nothing: the errors
     * that all teeth share. */
    explicit UnloadedContact(const GearPair    &pair,
                             MeshSide           side  = MeshSide::drive,
                             std::optional<int> teeth = {});

    /** The equations of contact of the flanks, errors included. */
    const FlankContact &equations() const;

    /** Rotation of the pinion from pitch to pitch, 2 pi / z1 [rad]. */
    double pitch() const;

    /** Pinion rotation at which pair 0 touches at the mean contact [rad]. */
    double reference() const;

    /**
     * Contact of a tooth pair on the flanks, continued beyond their borders, at pinion rotation @p
     * rot1 [rad]; NumericalError where they do not touch.
     */
    UnloadedContactPoint contact(double rot1, int pair) const;

    /**
     * The tooth pair that touches first when the gear is turned against the pinion at @p rot1
     * [rad], among those inside their flanks; NumericalError when there is none (edge contact).
     */
    UnloadedContactPoint touching(double rot1) const;

    /** Ellipse on which the flanks of @p point are @p separation [mm] apart. */
    ContactEllipse ellipse(const UnloadedContactPoint &point, double separation) const;

    /**
     * Pinion rotations, relative to reference(), between which pair 0 is inside both flanks [rad].
     * NumericalError when it is so nowhere within two pitches.
     */
    std::pair<double, double> path_range() const;

    /** The border of a flank beyond or nearest to which a contact lies. */
    PairBorder nearest_border(const UnloadedContactPoint &point) const;

  private:
    bool find(double rot1, int pair, UnloadedContactPoint &point) const;
    bool is_inside(const UnloadedContactPoint &point) const;

    MeshSide     side_;
    FlankContact contact_;
    Blank        pinion_blank_, gear_blank_;
    MeanContact  mean_;
    double       speed_ratio_;
    double       turn_; ///< of the pinion's generated flank onto tooth 0 [rad]
  };
} // namespace vfife

#endif
