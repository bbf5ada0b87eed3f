// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_contact_pass_h
#define vfife_contact_contact_pass_h

#include <vfife/contact/contact_anchor.h>
#include <vfife/contact/contact_results.h>
#include <vfife/contact/contact_times.h>
#include <vfife/contact/law/contact_spring.h>
#include <vfife/contact/law/surface_interaction.h>
#include <vfife/contact/listed_point.h>
#include <vfife/contact/point_share.h>
#include <vfife/contact/search/broad_search.h>
#include <vfife/contact/search/carried_area.h>
#include <vfife/contact/search/group_path.h>
#include <vfife/contact/search/local_search.h>
#include <vfife/contact/touch_geometry.h>
#include <vfife/contact/touching_point.h>

#include <utility>
#include <vector>

namespace vfife
{
  class ByteStream;

  /**
   * One direction of a contact: the quadrature points of the slave against the facets of the
   * master.
   *
   * Every pair of groups keeps a list of the points that may touch before the groups have moved by
   * the skin, each with its last projection. A point with gap g sleeps until the path of its groups
   * has grown by 0.8 g, a point beyond the border until half the way to the border: so most of a
   * list costs one comparison a step.
   */
  class ContactPass
  {
  public:
    /** @p area_factor scales all areas (one half for each of two passes). */
    ContactPass(const FacetSurface   &slave,
                const FacetSurface   &master,
                const ContactOptions &options,
                double                area_factor);

    /** Pairs of groups to look at (sorted); lists of pairs that remain are kept. */
    void set_pairs(const std::vector<std::pair<unsigned int, unsigned int>> &pairs);

    /** See Contact::set_shares, Contact::take_work (adds it). */
    void set_shares(const std::vector<PointShare> &shares);
    void take_work(std::vector<double> &of_pairs);

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

    const std::vector<GroupPairResult> &results() const
    {
      return results_;
    }

    /** Append the points with pressure of the last add_forces(), and their springs. */
    void append_points(std::vector<ContactPoint> &points, bool swapped) const;
    void append_springs(const ContactLaw           &law,
                        double                      penalty,
                        bool                        swapped,
                        std::vector<ContactSpring> &springs);

    /** For checkpoints: lists with their last projections, and paths. */
    void serialize(ByteStream &stream);
    /** See Contact::set_friction_mode, Contact::anchors. */
    void set_friction_mode(FrictionMode mode);
    void append_anchors(unsigned int pass, std::vector<AnchorOfPoint> &anchors) const;
    void restore_anchors(const std::vector<AnchorOfPoint> &anchors);
    bool has_restored_anchors() const;
    /** See Contact::place; the slave's undeformed frame into the master's. */
    void place(const RigidMotion &slave_to_master);
    /** Area of points that a node carries at most [mm^2] (CarriedArea). */
    const std::vector<double> &slave_carried_areas() const
    {
      return slave_carried_areas_;
    }
    const std::vector<double> &master_carried_areas() const
    {
      return master_carried_areas_;
    }
    /** As those of Contact; penalty at a point of a slave's facet over the contact's [-]. */
    void   vary_penalty(double least_width);
    void   set_stiffness(const std::vector<double> &of_group_points);
    double stiffness_of(const unsigned int slave_facet, const unsigned int rule_point) const
    {
      return point_stiffness_[slave_facet * rule_.size() + rule_point];
    }
    double                 largest_stiffness_of(unsigned int slave_facet) const;
    const SurfaceGeometry &slave() const
    {
      return slave_;
    }
    const SurfaceGeometry &master() const
    {
      return master_;
    }
    double skin() const
    {
      return skin_;
    }
    double depth_limit() const
    {
      return depth_limit_;
    }
    /** Points listed for the current pairs, wide searches made so far (for timing and tests). */
    std::size_t n_listed_points() const;
    std::size_t n_wide_searches() const
    {
      return n_wide_searches_;
    }

    /** From now on adds the processor time of the parts of add_forces(); nullptr ends it. */
    void measure_times(ContactTimes *times)
    {
      times_ = times;
    }

  private:
    struct Pair
    {
      unsigned int             slave_group, master_group;
      PointShare               share;
      double                   work     = 0.; ///< since take_work()
      bool                     listed   = false;
      double                   built_at = 0.; ///< path at the wide search [mm]
      std::vector<ListedPoint> points;
      /** Path of the pair at which each point must be looked at again [mm]. */
      std::vector<double>       awake_at;
      std::vector<unsigned int> touching; ///< points that touch in this step
      /** Of each point, where there is friction; energy of those that have opened [mJ]. */
      std::vector<ContactAnchor> anchors;
      double                     released = 0.;
    };
    /** What press() needs of a touching point beside it. */
    struct Touch
    {
      unsigned int pair, point;
      Vector3      x, normal;
      Fading       fade;
      TangentBasis basis;
    };
    /** Smallest gap over a slave facet, from its smallest sample on. */
    ContactPoint refined_gap(const ListedPoint &sample);
    void         bound_master_areas(const FacetDirections &directions);
    /** Throws InputError when lists that a checkpoint has given are of other surfaces. */
    void    check_lists(const ByteStream &stream) const;
    void    update_paths(const SurfaceMotion &slave, const SurfaceMotion &master);
    Vector3 slave_point(unsigned int facet, unsigned int rule_point) const;
    void    find_points(Pair &pair, double open_reach, double depth_reach);
    /** Groups whose motion is measured: those of pairs that this rank has points of. */
    void follow_groups();
    /** Boxes of the master's facets of a group, in their order. */
    std::vector<Box> facet_boxes(unsigned int group) const;
    /** The nearest foot on the facets @p near of @p group; the one found goes to their front. */
    bool find_closest(const std::vector<unsigned int> &group,
                      const std::vector<Box>          &boxes,
                      std::vector<unsigned int>       &near,
                      const Vector3                   &x,
                      const Vector3                   &slave_normal,
                      double                           reach,
                      Projection                      &projection);
    void list_points();
    void clear_results();
    void find_gaps(Pair &pair, double look_ahead);
    bool
    locate(const Pair &pair, ListedPoint &point, const Vector3 &x, double path, double &awake_at);
    void open(Pair &pair, unsigned int i, bool located); ///< located: its projection is known
    /** Along the master in the @p time [s] of the velocities of now [mm]; zero for no time. */
    Vector3 slip_way(const ListedPoint  &point,
                     const Vector3      &normal,
                     const TangentBasis &basis,
                     double              time) const;
    /** Friction force on the slave [N]. */
    Vector3 stick(const ListedPoint        &point,
                  const Vector3            &normal,
                  const TangentBasis       &basis,
                  double                    pressure,
                  double                    area,
                  const SurfaceInteraction &interaction,
                  ContactAnchor            &anchor,
                  GroupPairResult          &result);
    static void
           append_anchors(unsigned int pass, const Pair &pair, std::vector<AnchorOfPoint> &anchors);
    void   place_anchors(const std::vector<AnchorOfPoint> &anchors, Pair &pair) const;
    Fading find_fading(const Projection &projection) const;
    /** Gap below which a point touches within @p look_ahead [mm]. */
    double        find_reach(const ListedPoint &point, double look_ahead) const;
    void          describe(unsigned int pair, bool with_rates);
    bool          press(const TouchingPoint      &touching,
                        const Touch              &touch,
                        const SurfaceInteraction &interaction,
                        ListedPoint              &point,
                        ContactAnchor            *anchor,
                        GroupPairResult          &result,
                        double                   *slave_forces,
                        double                   *master_forces);
    ContactSpring make_spring(const ListedPoint &point, const PressedPoint &elastic);

    SurfaceGeometry                   slave_, master_;
    std::vector<FacetQuadraturePoint> rule_;
    std::vector<double>               point_areas_, point_offsets_; ///< facet by facet
    std::vector<double>               slave_carried_areas_, master_carried_areas_; ///< by node
    std::vector<double>               point_stiffness_; ///< stiffness_of()
    double                            area_factor_, edge_fading_, skin_, depth_limit_;
    double                            step_ = 0.; ///< between evaluations of implicit contact [s]
    GroupPath                         slave_path_, master_path_;
    std::vector<Pair>                 pairs_;
    std::vector<GroupPairResult>      results_;
    std::vector<TouchingPoint>        touching_; ///< of all pairs, in their order
    std::vector<Touch>                touches_;  ///< of the same
    std::size_t                       n_wide_searches_ = 0;
    ContactTimes                     *times_           = nullptr;
    FrictionMode                      mode_            = FrictionMode::follows;
    bool                              has_friction_    = false; ///< in this evaluation
    std::vector<AnchorOfPoint>        restored_; ///< of a checkpoint, until they are used
  };
} // namespace vfife

#endif
