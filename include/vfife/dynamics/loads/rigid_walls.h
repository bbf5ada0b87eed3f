// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_rigid_walls_h
#define vfife_dynamics_loads_rigid_walls_h

#include <vfife/contact/law/coulomb_slider.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  class ByteStream;
  class Communicator;

  /** The rigid walls of a model: unilateral penalty forces and friction on the nodes of this rank.
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

    /** Largest stable step [s] where everything else allows @p step: a spring to the ground adds
     * k/m to omega^2, 4/dt^2 >= 4/step^2 + eps A/m. */
    double vote_on_step(double step) const;

    /** Sets the penalties for a step of @p dt [s]. */
    void set_penalties(double dt);

    /** Adds the masses that the springs need in a relaxation with pseudo time step 1. */
    void add_relaxation_masses(double fraction, std::vector<double> &masses) const;

    /** Adds the forces to @p forces (all copies of a node). Collective where there are walls. */
    void add_forces(const NodeField &positions, NodeField &forces);

    /** Whether nodes that slide take their anchors along, see FrictionMode; they do at first. */
    void set_friction_mode(FrictionMode mode)
    {
      mode_ = mode;
    }

    /** Energy stored in the springs of penalty and stick at the last add_forces() [mJ]; all ranks.
     */
    double energy() const
    {
      return sums_[1];
    }

    /** Lost in friction between the last two add_forces() [mJ]; all ranks. */
    double friction_loss() const
    {
      return sums_[3];
    }

    /**
     * Whether a node was deeper behind a wall at the last add_forces() than half the width of the
     * facets around it, all ranks. Of walls whose penalty follows from the step, which is meant to
     * be stiff; a penalty of the user's own makes a wall as soft as he wants it.
     */
    bool is_too_deep() const
    {
      return sums_[2] > 0;
    }

    /** In words: the deepest node of the last add_forces() over its limit. Collective. */
    std::string describe_deepest_node(const Model &model) const;

    /** Of the last add_forces(), over all ranks; collective. */
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
    struct Node
    {
      std::uint32_t local;
      bool          owned;
      double        area;
      unsigned int  node;  ///< of the body
      std::size_t   index; ///< in the wall's definition
      /** Where it sticks while it touches; displacement from there and energy of the spring when it
       * last moved on [mm], [mJ]. */
      bool    sticks  = false;
      Vector3 anchor  = Vector3::Zero();
      double  elastic = 0, energy = 0;
    };
    struct Wall
    {
      explicit Wall(const RigidWall &definition);

      const PenaltyOptions &options() const
      {
        return definition->penalty;
      }

      const RigidWall                  *definition;
      std::unique_ptr<const ContactLaw> law;
      double                            mass_per_area; ///< least of its nodes [t/mm^2]
      double                            penalty;       ///< [N/mm^3]
      double                            depth_limit;   ///< see is_too_deep() [mm]
      std::vector<Node>                 nodes;

      /** Of the last add_forces(), this rank: nodes behind the wall and what the law says of them,
       * with the penalty times their area; sums. */
      std::vector<Node *>       touching;
      std::vector<PressedPoint> pressed;
      double                    force = 0, energy = 0, penetration = 0, friction_loss = 0;
      Vector3                   friction = Vector3::Zero(); ///< [N]
    };

    void    open(Wall &wall, Node &node, const Vector3 &x);
    Vector3 stick(Wall &wall, Node &node, const PressedPoint &pressed, const Vector3 &x);

    const Communicator &communicator_;
    std::vector<Wall>   walls_;
    FrictionMode        mode_ = FrictionMode::follows;
    /** Of the last add_forces(), all ranks: normal force, energy, number of nodes that are too
     * deep, friction loss. */
    std::array<double, 4> sums_ = {{0., 0., 0., 0.}};
  };
} // namespace vfife

#endif
