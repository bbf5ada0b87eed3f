// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_rigid_walls_h
#define vfife_dynamics_loads_rigid_walls_h

#include <vfife/contact/pressure_solver.h>
#include <vfife/dynamics/loads/pressed_wall.h>

#include <array>
#include <string>
#include <vector>

namespace vfife
{
  class ByteStream;
  class Communicator;

  /**
   * The rigid walls of a model: what they do to the nodes of this rank, by the laws of contact
   * between bodies. A wall is a plane that does not give way; a node presses on it with the area of
   * the faces around it. In time its pressure is the mean over the step (PressureSolver), each node
   * by itself with all walls that it touches; at rest that of its depth.
   */
  class RigidWalls
  {
  public:
    /** Throws InputError for a wall whose nodes carry no face. */
    RigidWalls(const Model &model, const Partition &partition, const Communicator &communicator);

    bool empty() const
    {
      return walls_.empty();
    }

    /** Largest stable step [s] where everything else allows @p step: the springs of nodes that
     * stick have their share, 4/dt^2 >= 4/step^2 + k A/m. */
    double vote_on_step(double step) const;

    /** Sets the stiffness of nodes that stick for a step of @p dt [s]. */
    void set_step(double dt);

    /** Sentences: the penalty of each wall. */
    std::vector<std::string> describe_penalties() const;

    /** Adds the masses that the springs need in a relaxation with pseudo time step 1. */
    void add_relaxation_masses(double fraction, std::vector<double> &masses) const;

    /** Adds the forces on nodes at rest to @p forces (all copies of a node). Collective where there
     * are walls. */
    void add_forces(const NodeField &positions, NodeField &forces);

    /** The same in a step @p dt [s] of explicit dynamics: @p velocities are those half a step
     * before, @p forces all others on the nodes. Collective where there are walls. */
    void add_step_forces(const NodeField &positions,
                         const NodeField &velocities,
                         double           dt,
                         NodeField       &forces);

    /** Whether nodes that slide take their anchors along, see FrictionMode; they do at first. */
    void set_friction_mode(FrictionMode mode);

    /** Whether anything pressed at the last evaluation; all ranks. */
    bool is_pressed() const
    {
      return sums_[0] > 0;
    }

    /** Energy stored in the springs of penalty and stick at the last evaluation [mJ]; all ranks.
     * That of a step may be negative where a node comes or goes. */
    double energy() const
    {
      return sums_[1];
    }

    /** Lost in friction between the last two evaluations [mJ]; all ranks. */
    double friction_loss() const
    {
      return sums_[3];
    }

    /** Lost in gap-rate damping at the last evaluation [mJ/s]; all ranks. */
    double lost_power() const
    {
      return sums_[4];
    }

    /**
     * Whether a node was deeper behind a wall at the last evaluation than half the width of the
     * facets around it, all ranks. A penalty of the user's own makes a wall as soft as he wants it:
     * it has no such limit.
     */
    bool is_too_deep() const
    {
      return sums_[2] > 0;
    }

    /** In words: the deepest node of the last evaluation, over its limit. Collective. */
    std::string describe_deepest_node(const Model &model) const;

    /** Of the last evaluation, over all ranks; collective. */
    struct Results
    {
      double               force       = 0; ///< sum over the walls of the forces' magnitudes [N]
      double               energy      = 0; ///< stored in the springs of penalty and stick [mJ]
      double               penetration = 0; ///< largest [mm]
      std::vector<Vector3> forces;          ///< of each wall on its body [N]
    };
    Results collect_results() const;

    /** For checkpoints: where nodes stick, of all ranks. Collective. */
    void serialize(ByteStream &stream);

  private:
    using Node  = PressedWall::Node;
    using Touch = PressedWall::Touch;

    /** A node of a wall; nodes of the model at several walls have neighbouring places. */
    struct Place
    {
      unsigned int  wall, node;
      std::uint32_t local;
    };

    void collect_places(const Model &model);
    /** Begins an evaluation of a @p step [s]; 0: at rest. */
    void begin(double step);
    /** Finds the touches of a node of the model, at @p first to before @p last. */
    void find_step_touches(std::size_t      first,
                           std::size_t      last,
                           const NodeField &positions,
                           const NodeField &velocities,
                           double           dt,
                           const NodeField &forces);
    /** Forces of the touches. @p way: of a node since the evaluation before. */
    template <typename Way>
    void press(const NodeField &positions, const Way &way, NodeField &forces);

    const Communicator      &communicator_;
    std::vector<PressedWall> walls_;
    std::vector<Place>       places_;
    std::vector<Matrix3>
                   inverse_masses_; ///< of the places' nodes, zero along held directions [1/t]
    PressureSolver solver_{0., {}};
    std::vector<TouchingPoint> points_; ///< of one node
    /** Of the last evaluation, all ranks: normal force, energy, number of nodes that are too
     * deep, friction loss, power lost in damping. */
    std::array<double, 5> sums_ = {};
  };
} // namespace vfife

#endif
