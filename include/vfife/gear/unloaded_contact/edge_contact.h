// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_unloaded_contact_edge_contact_h
#define vfife_gear_unloaded_contact_edge_contact_h

#include <vfife/gear/unloaded_contact/unloaded_contact.h>

#include <optional>
#include <vector>

namespace vfife
{
  /** Where an edge of one member touches the flank of the other, without load. */
  struct EdgeContactPoint
  {
    double         rot1 = 0, rot2 = 0;   ///< placements of the members [rad]
    double         lag = 0;              ///< as in UnloadedContactPoint [rad]
    GeneratedPoint pinion, gear;         ///< on the generated flanks
    Vector2        pinion_L_h, gear_L_h; ///< cone coordinates [mm]
  };

  /**
   * Contact of tooth pair 0 beyond an end of its path: where the path leaves one flank over an edge
   * (tip, toe, heel) that edge stays in contact with the other flank. Points coincide and the
   * normal of that flank is normal to the edge (doc/theory/gear.md). Over a fillet there is no
   * edge.
   */
  class EdgeContact
  {
  public:
    /** @p flanks: the contact of the same side; @p end: its contact at the path's end of pair 0, on
     * or next to the border; @p direction: +1 where the path ends at increasing rotations of the
     * pinion, -1 where it starts. */
    EdgeContact(const GearPair             &pair,
                MeshSide                    side,
                const UnloadedContact      &flanks,
                const UnloadedContactPoint &end,
                double                      direction);

    /** "gear tip", "pinion heel" ...: the border that the path leaves over. */
    const std::string &border() const;

    /** Followed from the path's end until a point leaves the edge or the other flank, in steps;
     * empty at a fillet. */
    const std::vector<EdgeContactPoint> &points() const;

    /** At a rotation of the pinion; nothing where points() does not reach. */
    std::optional<EdgeContactPoint> at(double rot1) const;

  private:
    using Unknowns = Eigen::Matrix<double, 5, 1>; ///< t, phi of pinion and gear, rotation of gear
    using Jacobian = Eigen::Matrix<double, 5, 5>;

    void evaluate(double rotation, const Unknowns &x, Unknowns &residual, Jacobian &jacobian) const;
    /** Derivatives by (t, phi) of the distance from the edge on the flank that has it. */
    Vector2 distance_gradient(const SurfaceDerivatives &d) const;
    /** Product of the edge's unit tangent and the other flank's normal. */
    double           tangency(double rotation, const Unknowns &x) const;
    double           edge_distance(const Vector2 &L_h) const;
    bool             solve(double rotation, Unknowns &x) const;
    EdgeContactPoint point_of(double rotation, const Unknowns &x) const;
    bool             is_on_flanks(const EdgeContactPoint &point) const;

    FlankContact contact_;
    Blank        pinion_blank_, gear_blank_;
    MeanContact  mean_;
    MeshSide     side_;
    double       speed_ratio_, turn_, pitch_;
    bool         on_pinion_ = false; ///< the edge is the pinion's
    FlankBorder  edge_      = FlankBorder::tip;
    std::string  border_;

    std::vector<EdgeContactPoint> points_;
    std::vector<Unknowns>         unknowns_; ///< of the points
  };

  /** Flank contact of pair 0 on its path, and edge contact beyond both ends. */
  class PairContact
  {
  public:
    /** @p teeth: as in UnloadedContact. */
    PairContact(const GearPair &pair, MeshSide side, std::optional<int> teeth = {});

    const UnloadedContact &flanks() const;
    const EdgeContact     &edge(unsigned int end) const;
    /** Ends of the path [pitches], and of it together with the edges. */
    const Vector2 &path() const;
    const Vector2 &whole() const;

    /** Lag of pair 0 at a rotation of the pinion from the mean contact, infinite outside whole()
     * [rad]. */
    double lag(double pitches) const;
    /** The least lag over all pairs: that of the pair that touches; infinite where none does. */
    double least_lag(double pitches) const;

  private:
    UnloadedContact          contact_;
    Vector2                  path_, whole_;
    std::vector<EdgeContact> edges_;
  };
} // namespace vfife

#endif
