// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_contact_contact_system_h
#define vfife_dynamics_loads_contact_contact_system_h

#include <vfife/contact/law/friction_law.h>
#include <vfife/contact/pass/point_list.h>
#include <vfife/contact/touching_point.h>
#include <vfife/dynamics/loads/contact/contact_ranks.h>
#include <vfife/dynamics/loads/contact/contact_sums.h>
#include <vfife/dynamics/loads/contact/implicit_pressures.h>
#include <vfife/dynamics/rigid_velocity.h>
#include <vfife/model/state.h>

#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  class ByteStream;
  class Communicator;
  class Contact;
  struct ContactTimes;

  /**
   * All contact pairs of a model in the explicit loop: brings the surface nodes that may touch
   * together on the ranks that work on them (ContactRanks), lets each of these treat its share of
   * the points, and returns the forces to all copies of the nodes.
   */
  class ContactSystem
  {
  public:
    /** @p safety: the step that elements allow over their largest stable one. */
    ContactSystem(const Model        &model,
                  const Partition    &partition,
                  const Communicator &communicator,
                  double              safety);
    ~ContactSystem();

    /**
     * Largest stable step [s] when elements alone allow @p element_step (safety included): the
     * contact springs' share of the largest frequency is added.
     */
    double vote_on_step(double element_step) const;

    /** Limits the stiffness of points that stick to what a step of @p dt [s] bears. */
    void set_step(double dt);

    /** Penalty of each pair, in the mean of its points [N/mm^3]. */
    std::vector<double> penalties() const;

    /**
     * Broad search: which surface groups (teeth) can touch during the next @p duration [s], from
     * the bodies' mean motion, its rates, and the deformation in @p positions. Collective.
     */
    void search(const std::vector<RigidMotion>   &body_motion,
                const std::vector<RigidVelocity> &rates,
                const NodeField                  &positions,
                double                            duration);

    /**
     * Adds contact forces to @p forces (all copies of a node). @p dt is the step of the explicit
     * integration. Collective.
     */
    void add_forces(const std::vector<RigidMotion> &body_motion,
                    const NodeField                &positions,
                    const NodeField                &velocities,
                    double                          dt,
                    NodeField                      &forces);

    /** Masses of this rank's nodes [t], which add_step_forces() reckons with. Collective. */
    void set_masses(const std::vector<double> &masses);

    /**
     * The same in a step of explicit dynamics, where pairs may be integrated implicitly: their
     * pressures follow from the gaps at both ends of the step (PressureSolver). @p forces: all
     * others on the nodes. Energy, powers and flags are those of this rank until append_sums() have
     * been summed over the ranks, with whatever else is summed in the step, and rethrow_failure()
     * has been called. Collective.
     */
    void add_step_forces(const std::vector<RigidMotion> &body_motion,
                         const NodeField                &positions,
                         const NodeField                &velocities,
                         double                          dt,
                         NodeField                      &forces);

    /** Appends the numbers that add_step_forces() leaves to be summed over the ranks, in place. */
    void append_sums(std::vector<double *> &numbers);

    /** Throws NumericalError on all ranks where add_step_forces() has failed on some. Collective if
     * it has. */
    void rethrow_failure() const;

    /** Remembers @p forces where add_step_forces() may add to them. */
    void save_forces(const NodeField &forces);

    /** Sets @p added, zero at first, to what has been added to @p forces since save_forces(). */
    void find_added(const NodeField &forces, NodeField &added);

    /** Of the last add_forces() or add_step_forces(). */
    const ContactSums &sums() const
    {
      return sums_;
    }

    /** Whether points that slide take their anchors along, see FrictionMode; they do at first. */
    void set_friction_mode(FrictionMode mode);

    /** Those of the model. */
    std::size_t n_contacts() const
    {
      return pairs_.size();
    }

    /** See contact_report.h; the first two are collective. */
    std::vector<ToothContact> collect_results() const;
    std::string               describe_deepest_point() const;
    std::vector<std::string>  describe_coarse_slaves() const;
    std::vector<std::string>  describe_rattling(double dt) const;

    /** For checkpoints: what this rank knows of the pairs that may touch. */
    void serialize(ByteStream &stream);
    /** For checkpoints: where points stick, of all ranks. Collective. */
    void serialize_friction(ByteStream &stream);

    /** Adds the stabilizing mass that penalty springs need in a relaxation with pseudo time step 1.
     */
    void add_relaxation_masses(double fraction, std::vector<double> &masses) const;

    /** From now on adds the processor time of the parts of search() and add_forces() to @p times,
     * which must outlive the object; nullptr ends it. */
    void measure_times(ContactTimes *times);

    /** Points kept for possible contact on this rank. */
    std::size_t n_listed_points() const;

  private:
    void bring_motion(const NodeField &positions,
                      const NodeField &velocities,
                      const NodeField *forces,
                      double           dt);
    /** Does the work of this rank, and notes where it fails. */
    void evaluate(const std::function<void()> &work);
    void press_explicitly(const std::vector<RigidMotion> &body_motion,
                          const NodeField                &positions,
                          const NodeField                &velocities,
                          double                          dt,
                          NodeField                      &forces);
    void press_implicitly(const std::vector<RigidMotion> &body_motion,
                          const NodeField                &positions,
                          const NodeField                &velocities,
                          double                          dt,
                          NodeField                      &forces);
    /** Forces of points, whose nodes go to touched_. */
    void press(ContactOfPair &pair, const std::vector<TouchingPoint> &points, double dt);
    void hand_over_forces(NodeField &forces);
    /** To the ranks that have been chosen. Collective. */
    void                       move_points();
    std::vector<AnchorOfPoint> gather_anchors(const Contact &contact) const;

    const Model             &model_;
    const Partition         &partition_;
    const Communicator      &communicator_;
    ContactPairs             pairs_;
    ContactRanks             ranks_;
    ImplicitPressures        implicit_;
    bool                     needs_velocities_ = false; ///< a pair has damping or friction
    bool                     is_implicit_      = false; ///< a pair is
    std::vector<ContactNode> touched_;                  ///< by this rank's points
    ContactSums              sums_;
    std::string              failure_; ///< of this rank
    /** Local nodes of save_forces(), what it has found there, and nodes set by find_added(). */
    std::vector<std::uint32_t> saved_nodes_, shown_nodes_;
    std::vector<Vector3>       saved_forces_;
    ContactTimes              *times_ = nullptr;
  };
} // namespace vfife

#endif
