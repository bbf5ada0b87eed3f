// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_pass_stick_slip_h
#define vfife_contact_pass_stick_slip_h

#include <vfife/contact/law/friction_law.h>
#include <vfife/contact/law/surface_interaction.h>
#include <vfife/contact/pass/pass_surfaces.h>
#include <vfife/contact/pass/point_list.h>
#include <vfife/contact/touch_geometry.h>
#include <vfife/contact/touching_point.h>

#include <vector>

namespace vfife
{
  /** Geometry of a touching point that its forces need beside the TouchingPoint. */
  struct Touch
  {
    unsigned int list, point; ///< numbers of the list and of its point
    Vector3      x;           ///< position on the slave's facet [mm]
    Fading       fade;
    TangentBasis basis;
  };

  /** Friction at a point in one evaluation. */
  struct FrictionForce
  {
    Vector3 force;       ///< on the slave [N]
    double  energy = 0.; ///< of the spring [mJ]
    double  loss   = 0.; ///< of the slider since the evaluation before [mJ]
  };

  /** Stick and slip of the points. A point that comes to touch gets an anchor on the master; its
   * friction is a spring from there to its foot, behind a slider. The lists keep the anchors. */
  class StickSlip
  {
  public:
    explicit StickSlip(PassSurfaces &surfaces)
      : surfaces_(surfaces)
    {
    }

    /** FrictionMode says how anchors move. Returns whether the mode changes. */
    bool set_mode(FrictionMode mode);

    /** Begins an evaluation: makes room for the anchors of the @p lists, none without friction. @p
     * step: time since the evaluation before, where its contact is implicit, else 0 [s]. */
    void begin(const SurfaceInteraction &interaction, double step, std::vector<PointList> &lists);

    /** Whether there is friction in this evaluation. */
    bool acts() const
    {
      return acts_;
    }

    /** Gives the points of the @p lists the anchors of restore(), which are gone then. */
    void use_restored(std::vector<PointList> &lists);

    /** A point of the list does not touch; @p located: its projection is up to date. */
    void open(PointList &list, const unsigned int point, const bool located)
    {
      if (acts_)
        open_anchor(list, point, located);
    }

    /** Friction of a point under pressure, whose anchor follows; call it only where friction acts.
     */
    FrictionForce stick(PointList                &list,
                        const Touch              &touch,
                        const TouchingPoint      &touching,
                        const SurfaceInteraction &interaction);

    /** Appends the anchors of the points of a @p list, for the @p pass of a contact. */
    static void
    append_anchors(unsigned int pass, const PointList &list, std::vector<AnchorOfPoint> &anchors);

    /** One anchor per point of the @p list: that of the same point among @p anchors, else none. */
    void renew_anchors(const std::vector<AnchorOfPoint> &anchors, PointList &list) const;

    /** Anchors of a checkpoint until use_restored(): points have none before the first forces. */
    void restore(const std::vector<AnchorOfPoint> &anchors)
    {
      restored_ = anchors;
    }
    const std::vector<AnchorOfPoint> &restored() const
    {
      return restored_;
    }

  private:
    void open_anchor(PointList &list, unsigned int point, bool located);
    void place_anchors(const std::vector<AnchorOfPoint> &anchors, PointList &list) const;

    /** Way along the master in the @p time [s] at the current velocities [mm]; zero for no time. */
    Vector3 slip_way(const ListedPoint &point, const TangentBasis &basis, double time) const;

    PassSurfaces              &surfaces_;
    FrictionMode               mode_ = FrictionMode::follows;
    bool                       acts_ = false; ///< in this evaluation
    double                     step_ = 0.;    ///< between evaluations of implicit contact [s]
    std::vector<AnchorOfPoint> restored_;
  };
} // namespace vfife

#endif
