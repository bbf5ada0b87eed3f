// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_motion_constraint_motion_h
#define vfife_dynamics_motion_constraint_motion_h

#include <vfife/dynamics/motion/constrained_group.h>
#include <vfife/dynamics/motion/nodal_update.h>
#include <vfife/model/constraints/node_constraints.h>
#include <vfife/model/state.h>

#include <vector>

namespace vfife
{
  class ByteStream;
  class Communicator;

  /** Frame in which a solver moves the nodes. */
  enum class MotionFrame
  {
    fixed,   ///< prescribed rotations turn
    rotating ///< relaxation: they stand still
  };

  /**
   * The nodes that constraints hold or lead. After update_nodes() has moved all nodes, apply() puts
   * these where they belong: prescribed rotations by position, X -> p + R(rate t)(X - p), so that
   * nothing drifts; free rotations on their circles with one angle a node, or one angle for all
   * (rigid hub); nodes prescribed in some directions where these and their free motion put them.
   * Constraints that share a node act together (NodeConstraints).
   */
  class ConstraintMotion
  {
  public:
    /** Throws InputError where constraints of one node contradict each other; as apply() does
     * where they come to in time. */
    ConstraintMotion(const Model        &model,
                     const Partition    &partition,
                     const Communicator &communicator);

    /** The masses that tangential motion accelerates (lumped ones, or those of a relaxation), by
     * local node. */
    void set_masses(const std::vector<double> &masses);

    /** The lines that moments of the bodies are about, where they are not UpdateAxis::of(). */
    void set_axes(const std::vector<UpdateAxis> &axes);

    /** Sets mass and inverse mass of the constrained nodes in the fields of @p state to zero. */
    void clear_masses(State &state) const;

    /** Takes over angles and angular velocities of free rotations from positions and velocities of
     * the state; nodes of a rigid hub share their mean. Collective. */
    void read(const State &state, MotionFrame frame);

    /** Turns the mean rigid motion of bodies with a free rotation, in the rotating frame, to the
     * mean angle of the nodes that turn freely. Collective. */
    void turn_bodies(const Model &model, State &state) const;

    /** For checkpoints: angles and angular velocities of free rotations by node of the model, for
     * any number of ranks. Collective. */
    void serialize(ByteStream &stream, const Partition &partition);

    /** In the rotating frame: what part of the prescribed displacements and angles is taken,
     * instead of their histories at time zero. */
    void set_part(double part);

    /** Remembers the old positions and velocities, before update_nodes(). */
    void save(const NodeField &positions, const NodeField &velocities);

    /**
     * Moves the constrained nodes from the saved state at @p time to time + dt. @p damping: one
     * entry a body. Adds power and moments of the constrained nodes to @p sums (one a body).
     * Collective where there is a rigid hub.
     */
    void apply(double                          time,
               double                          dt,
               MotionFrame                     frame,
               const std::vector<BodyDamping> &damping,
               const NodeField                &forces,
               NodeField                      &positions,
               NodeField                      &velocities,
               std::vector<BodySums>          &sums);

    /** Leaves of the forces at constrained nodes the tangential part where the node may turn (@p
     * rotation_is_free), of a rigid hub its share of the hub's torque; else nothing. Collective. */
    void project(const NodeField &positions, NodeField &forces, bool rotation_is_free) const;

    /** Adds the nodes that this rank owns to the motion of their bodies, at the time before the
     * last apply(). @p velocities: v+. */
    void add_motion(const NodeField &velocities, std::vector<NodalMotion> &motions) const;

    /**
     * Adds to @p reactions (one a constraint) what the constraints exerted on this rank's nodes at
     * the time before the last apply(), with its @p damping and @p forces: m (v+ - v-)/dt less
     * these forces and, where the node is free to move, its damping. @p velocities: v+.
     */
    void add_reactions(double                          dt,
                       const std::vector<BodyDamping> &damping,
                       const NodeField                &forces,
                       const NodeField                &velocities,
                       std::vector<Reaction>          &reactions) const;

    /** The same at rest, in the frames that turn with the bodies: what project() has taken out of
     * @p forces and left as @p projected, with the other sign. */
    void add_static_reactions(const NodeField       &positions,
                              const NodeField       &forces,
                              const NodeField       &projected,
                              std::vector<Reaction> &reactions) const;

  private:
    using Node  = ConstrainedNode;
    using Group = ConstrainedGroup;

    void   add_nodes(unsigned int body, const Partition &partition);
    void   compare_first_values() const;
    double factor(const Constraint &constraint) const;
    /** Reads the histories and compares the values of nodes that have several. */
    void    update_factors(double time, MotionFrame frame);
    Vector3 move_led(const Group       &group,
                     Node              &node,
                     double             dt,
                     const BodyDamping &damping,
                     const Vector3     &force) const;
    double  turned_angle(const Group &group, double time, MotionFrame frame) const;

    void add_reaction(const Group           &group,
                      const Node            &node,
                      const Vector3         &place,
                      const Vector3         &reaction,
                      std::vector<Reaction> &reactions) const;
    /** The velocity of the step with which the node has got where it is, of which @p chord has the
     * digits of places alone. */
    Vector3 find_way(const Group &group, const Node &node, double dt, const Vector3 &chord) const;
    static void add_sums(const Group       &group,
                         const Node        &node,
                         double             dt,
                         const BodyDamping &damping,
                         const Vector3     &force,
                         const Vector3     &x,
                         const Vector3     &v,
                         const UpdateAxis  &axis,
                         BodySums          &sums);

    const Communicator          &communicator_;
    const Model                 &model_;
    std::vector<Group>           groups_;   ///< one a constraint
    std::vector<UpdateAxis>      axes_;     ///< per body
    std::vector<double>          factors_;  ///< of each constraint's values at present
    std::vector<NodeConstraints> shared_;   ///< of this rank's nodes in several constraints
    std::vector<NodeConstraints> compared_; ///< nodes whose values may come to contradict
    std::optional<double>        part_;
  };
} // namespace vfife

#endif
