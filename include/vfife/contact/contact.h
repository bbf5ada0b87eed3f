// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_contact_h
#define vfife_contact_contact_h

#include <vfife/contact/contact_results.h>
#include <vfife/contact/law/contact_interaction.h>
#include <vfife/contact/law/contact_options.h>
#include <vfife/contact/node_springs.h>
#include <vfife/contact/pass/contact_pass.h>
#include <vfife/contact/search/broad_search.h>

#include <utility>
#include <vector>

namespace vfife
{
  class ByteStream;

  /**
   * Contact between two surfaces by unilateral penalty; the formulation is derived in
   * doc/theory/contact.md.
   *
   * Quadrature points x_s of the slave's facets are projected onto the master along its continuous
   * normal field, x_s = y(xi, eta) + lambda n(xi, eta), and pressed with p(-g) of the contact law
   * (p = eps (-g) of the linear one) where the gap
   *   g = n.(x_s - y) - delta_master(xi, eta) - delta_slave < 0.
   * As x_s - y is parallel to n, forces on both bodies are equal and opposite in force and in
   * moment. Areas are those of the undeformed slave. Units mm, s, t, N, MPa.
   * Use: find_candidates() now and then; every step make positions and velocities of the active
   * nodes available and call add_forces().
   */
  class Contact
  {
  public:
    /** Copies what it needs of the surfaces. Throws InputError on unusable surfaces or options. */
    Contact(const FacetSurface &slave, const FacetSurface &master, const ContactOptions &options);

    /**
     * Finds the pairs of groups (teeth) whose facets come nearer than @p margin [mm] when the
     * undeformed surfaces move rigidly; it must cover deformation and relative motion until the
     * next call, and search_skin(). What is known of pairs that remain is kept. Deterministic: all
     * ranks find the same from the same input.
     */
    void find_candidates(const RigidMotion &slave, const RigidMotion &master, double margin);

    /** The same on the way to where the bodies will be at the next call, which @p margin then need
     * not cover. */
    void find_candidates(const RigidMotion &slave,
                         const RigidMotion &master,
                         const RigidMotion &slave_later,
                         const RigidMotion &master_later,
                         double             margin);

    /** Surface nodes whose positions and velocities must be valid in add_forces(), sorted. */
    const std::vector<unsigned int> &active_slave_nodes() const
    {
      return active_slave_nodes_;
    }
    const std::vector<unsigned int> &active_master_nodes() const
    {
      return active_master_nodes_;
    }

    /** (slave group, master group), sorted. */
    const std::vector<std::pair<unsigned int, unsigned int>> &candidate_pairs() const
    {
      return candidate_pairs_;
    }

    /**
     * Penalty [N/mm^3] and the least nodal mass per tributary area [t/mm^2], which scales the
     * gap-rate damping c = 2 ratio sqrt(eps m/A). Without it (0) that of
     * PenaltyOptions::mass_per_area_for the step is taken.
     */
    void set_penalty(const double penalty, const double mass_per_area = 0.)
    {
      interaction_.set_penalty(penalty, mass_per_area);
    }
    double penalty() const
    {
      return interaction_.penalty();
    }
    /** See ContactInteraction::limit_tangential_penalty, ContactInteraction::at_step. */
    void limit_tangential_penalty(const double limit)
    {
      interaction_.limit_tangential_penalty(limit);
    }
    SurfaceInteraction interaction(const double dt) const
    {
      return interaction_.at_step(dt);
    }

    /** From now on the penalty goes with 1/h, h the width of a facet; set_penalty() sets that of
     * the narrowest, whose width [mm] is returned. */
    double vary_penalty();
    /** From now on a factor of the penalty per point of a slave's group. Throws InputError. */
    void set_stiffness(const std::vector<double> &of_group_points);

    /** The points as springs on the nodes of the surfaces; refers to this contact. */
    NodeSprings node_springs() const
    {
      return NodeSprings(passes_);
    }

    /** Which points of each candidate pair, in their order, are this rank's (in the second of two
     * passes by the master's facets); a pair that is found is this rank's alone at first. A change
     * costs a wide search, and where points stick is forgotten (restore_anchors()). */
    void set_shares(const std::vector<PointShare> &shares);

    /** What each candidate pair has cost on this rank since the last call, in the cost of finding
     * where a point lies. */
    std::vector<double> take_work();

    /**
     * Adds the contact forces [N] of this rank's points to 3 doubles per surface node. @p dt is the
     * time step [s]. Throws NumericalError when a position is not finite.
     */
    void add_forces(const SurfaceMotion &slave,
                    const SurfaceMotion &master,
                    double               dt,
                    double              *slave_forces,
                    double              *master_forces);

    /** The first part of add_forces(): the points of this rank that touch, or that may within
     * @p look_ahead [s], their pressures those of the evaluation before. */
    std::vector<TouchingPoint>
    locate(const SurfaceMotion &slave, const SurfaceMotion &master, double dt, double look_ahead);

    /** The pressures of the gaps as they are. */
    void find_explicit_pressures(double dt, std::vector<TouchingPoint> &points) const;

    /** The forces of what locate() has found, with pressures, in the same order. */
    void press(const std::vector<TouchingPoint> &points,
               double                            dt,
               double                           *slave_forces,
               double                           *master_forces);

    /** Of this rank in the last add_forces(), in the order of candidate_pairs(). */
    const std::vector<GroupPairResult> &results() const
    {
      return results_;
    }

    /**
     * The point with the smallest gap (negative: penetration) over all candidate pairs, of the @p
     * share of each, also when open: gaps within +- @p reach [mm] are looked at, found without warm
     * start. The gap is infinite when there is none.
     */
    ContactPoint smallest_gap(const SurfaceMotion &slave,
                              const SurfaceMotion &master,
                              double               reach,
                              const PointShare    &share = PointShare());

    /** Surface nodes (slave's, master's, each sorted) of facets of candidate pairs with a point
     * nearer than @p reach [mm] to the other surface, found without warm start. */
    std::pair<std::vector<unsigned int>, std::vector<unsigned int>>
    find_near_nodes(const SurfaceMotion &slave, const SurfaceMotion &master, double reach);

    /** Where the bodies are at the start: carried areas then reckon with how the facets lie to each
     * other there, without it also with any other direction. */
    void place(const RigidMotion &slave, const RigidMotion &master);

    /** Mean facet size of the slave over that of the master; one that is much larger than 1 costs
     * penalty, see NodeSprings::mass_per_area(). */
    double coarseness() const
    {
      return passes_.front().slave().mean_facet_size() / passes_.front().master().mean_facet_size();
    }

    /** Points under pressure in the last add_forces() of this rank, whose arrays are still valid.
     */
    std::vector<ContactPoint> points() const;

    /** Tangent of the elastic forces of the last add_forces() (this rank, no friction, no
     * damping); its position arrays must still be valid. */
    std::vector<ContactSpring> springs();

    /** For checkpoints: what is known of the candidate pairs. An object of the same surfaces and
     * options that reads it goes on to the last digit, if its rank is the same. */
    void serialize(ByteStream &stream);

    /** Whether points that slide take their anchors along (as it is at first), see FrictionMode. */
    void set_friction_mode(FrictionMode mode);

    /** Where the points of this rank stick; those of all ranks from restore_anchors() on until
     * add_forces() uses them, which is asked for then. */
    std::vector<AnchorOfPoint> anchors() const;
    bool                       has_restored_anchors() const;

    /** Whether there is such a place: what a checkpoint holds must be looked at. */
    bool has_place(const AnchorOfPoint &anchor) const;

    /** Goes on with the @p anchors of all ranks in the next add_forces(). */
    void restore_anchors(const std::vector<AnchorOfPoint> &anchors);

    /** Motion between wide searches [mm]. */
    double search_skin() const;

    /** Penetrations beyond it are no contact: a largest_penetration near it is runaway [mm]. */
    double depth_limit() const;

    /** From now on adds processor times of add_forces() to @p times; nullptr ends it. */
    void measure_times(ContactTimes *times)
    {
      for (ContactPass &pass : passes_)
        pass.measure_times(times);
    }

    /** Points kept for possible contact; wide searches so far. */
    std::size_t n_listed_points() const;
    std::size_t n_wide_searches() const;

  private:
    void find_active_nodes();

    ContactInteraction       interaction_;
    std::vector<ContactPass> passes_; ///< one, or two with swapped roles
    BroadSearch              broad_search_;

    std::vector<std::pair<unsigned int, unsigned int>> candidate_pairs_;
    std::vector<unsigned int>                          active_slave_nodes_, active_master_nodes_;
    std::vector<GroupPairResult>                       results_;
  };
} // namespace vfife

#endif
