// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_rigid_walls_h
#define vfife_dynamics_loads_rigid_walls_h

#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  class Communicator;

  /** The rigid walls of a model: unilateral penalty forces on the nodes of this rank. */
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

    /** Energy stored in the penalty springs at the last add_forces() [mJ]; all ranks. */
    double energy() const
    {
      return sums_[1];
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
      double force       = 0; ///< sum over the walls of the forces' magnitudes [N]
      double energy      = 0; ///< stored in the penalty springs [mJ]
      double penetration = 0; ///< largest [mm]
    };
    Results collect_results() const;

  private:
    struct Node
    {
      std::uint32_t local;
      bool          owned;
      double        area;
      unsigned int  node; ///< of the body
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
      std::vector<const Node *> touching;
      std::vector<PressedPoint> pressed;
      double                    force = 0, energy = 0, penetration = 0;
    };

    const Communicator &communicator_;
    std::vector<Wall>   walls_;
    /** Of the last add_forces(), all ranks: force, energy, number of nodes that are too deep. */
    std::array<double, 3> sums_ = {{0., 0., 0.}};
  };
} // namespace vfife

#endif
