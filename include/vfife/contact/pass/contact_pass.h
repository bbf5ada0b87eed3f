// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_pass_contact_pass_h
#define vfife_contact_pass_contact_pass_h

#include <vfife/base/types.h>
#include <vfife/contact/contact_results.h>
#include <vfife/contact/law/surface_interaction.h>
#include <vfife/contact/pass/pass_surfaces.h>
#include <vfife/contact/pass/point_lists.h>
#include <vfife/contact/pass/stick_slip.h>
#include <vfife/contact/touching_point.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace vfife
{
  class ByteStream;

  /**
   * A contact point under pressure as a spring. With g the gap and w the weight of the edge, small
   * motions of the corners change g sqrt(w) by
   *   direction . (sum N_k dx_k of the slave's facet - sum N_k dx_k of the master's facet),
   * and the tangent of the contact forces is k direction direction^T on the weighted corners, k the
   * tangent of the contact law times the area. Left out is what turns the normal under pressure
   * (the gap over the radius of curvature) and, in the strip where w < 1, what a law that is not
   * linear adds: Newton's method with a line search gets along with it.
   */
  struct ContactSpring
  {
    bool                        swapped = false; ///< second pass: the pair's master is the slave
    std::array<unsigned int, 4> slave_nodes, master_nodes; ///< surface nodes
    std::array<double, 4>       slave_weights, master_weights;
    Vector3                     direction;     ///< on the slave, fixed frame [-]
    double                      stiffness = 0; ///< tangent of the law times area [N/mm]
  };

  /** Processor time of the parts of a contact's evaluations, added up [s]. */
  struct ContactTimes
  {
    double broad_search = 0.; ///< which groups (teeth) may touch
    double motion       = 0.; ///< how far the groups have moved since their lists were made
    double wide_search  = 0.; ///< which points may touch
    double projection   = 0.; ///< where the points lie, and their gaps
    double forces       = 0.; ///< of the points that touch
  };

  /** One direction of a contact: the quadrature points of the slave against the facets of the
   * master. It describes the points that touch, and turns their pressures into forces. */
  class ContactPass
  {
  public:
    /** @p area_factor scales all areas (one half for each of two passes). */
    ContactPass(const FacetSurface   &slave,
                const FacetSurface   &master,
                const ContactOptions &options,
                double                area_factor);

    /** See PointLists::set_pairs, PointLists::set_shares, PointLists::take_work. */
    void set_pairs(const std::vector<std::pair<unsigned int, unsigned int>> &pairs);
    void set_shares(const std::vector<PointShare> &shares);
    void take_work(std::vector<double> &of_pairs)
    {
      lists_.take_work(of_pairs);
    }

    /**
     * The points that touch, of this rank's share: those with a gap below zero, and those that
     * close or have been closed within @p look_ahead [s]. The velocities of the surfaces are read
     * where there is damping or where @p look_ahead is not 0.
     */
    void locate(const SurfaceMotion      &slave,
                const SurfaceMotion      &master,
                const SurfaceInteraction &interaction,
                double                    look_ahead);

    /** Found by locate(); press() reads the pressures here. */
    std::vector<TouchingPoint> &touching()
    {
      return touching_;
    }

    /** Adds the forces of the touching points at their pressures, and makes the results. */
    void press(const SurfaceInteraction &interaction, double *slave_forces, double *master_forces);

    const std::vector<GroupPairResult> &results() const
    {
      return results_;
    }

    /** See Contact::smallest_gap, Contact::find_near_nodes (adds them). */
    ContactPoint smallest_gap(const SurfaceMotion &slave,
                              const SurfaceMotion &master,
                              double               reach,
                              const PointShare    &share);
    void         add_near_nodes(const SurfaceMotion       &slave,
                                const SurfaceMotion       &master,
                                double                     reach,
                                std::vector<unsigned int> &slave_nodes,
                                std::vector<unsigned int> &master_nodes);

    /** Append the points with pressure of the last add_forces(), and their springs. */
    void append_points(std::vector<ContactPoint> &points, bool swapped) const;
    void append_springs(const ContactLaw           &law,
                        double                      penalty,
                        bool                        swapped,
                        std::vector<ContactSpring> &springs);

    /** For checkpoints: lists with their last projections, and paths. */
    void serialize(ByteStream &stream)
    {
      lists_.serialize(stream);
    }

    /** See Contact::set_friction_mode, Contact::anchors. */
    void set_friction_mode(FrictionMode mode);
    void append_anchors(unsigned int pass, std::vector<AnchorOfPoint> &anchors) const;
    void restore_anchors(const std::vector<AnchorOfPoint> &anchors)
    {
      friction_.restore(anchors);
    }
    bool has_restored_anchors() const
    {
      return !friction_.restored().empty();
    }

    /** See Contact::place; the slave's undeformed frame into the master's. */
    void place(const RigidMotion &slave_to_master);

    /** Area of points that a node of the master carries at most [mm^2] (CarriedArea). */
    const std::vector<double> &master_carried_areas() const
    {
      return master_carried_areas_;
    }

    /** The slave's points, with their stiffness; the lists of those that may touch. */
    SlavePoints &slave_points()
    {
      return surfaces_->slave;
    }
    const SlavePoints &slave_points() const
    {
      return surfaces_->slave;
    }
    const PointLists &lists() const
    {
      return lists_;
    }
    const SurfaceGeometry &slave() const
    {
      return surfaces_->slave.surface();
    }
    const SurfaceGeometry &master() const
    {
      return surfaces_->master;
    }

    /** From now on adds the processor time of the parts of add_forces(); nullptr ends it. */
    void measure_times(ContactTimes *times)
    {
      times_ = times;
    }

  private:
    void clear_results();
    void describe(unsigned int number, bool with_rates);
    void describe(const ListedPoint &point, const Touch &touch, bool with_rates);
    /** Returns false for a point without pressure. */
    bool press(std::size_t               number,
               const SurfaceInteraction &interaction,
               double                   *slave_forces,
               double                   *master_forces);

    std::unique_ptr<PassSurfaces> surfaces_; ///< at one place: the parts refer to them
    PointLists                    lists_;
    StickSlip                     friction_;
    std::vector<double>           master_carried_areas_; ///< by node
    std::vector<GroupPairResult>  results_;
    std::vector<TouchingPoint>    touching_; ///< of all pairs, in their order
    std::vector<Touch>            touches_;  ///< of the same
    ContactTimes                 *times_ = nullptr;
  };
} // namespace vfife

#endif
