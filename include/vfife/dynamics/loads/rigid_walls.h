// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_rigid_walls_h
#define vfife_dynamics_loads_rigid_walls_h

#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <memory>
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

    /** Adds the forces to @p forces (all copies of a node). */
    void add_forces(const NodeField &positions, NodeField &forces);

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
      std::vector<Node>                 nodes;

      /** Of the last add_forces(), this rank: nodes behind the wall and what the law says of them,
       * with the penalty times their area; sums. */
      std::vector<const Node *> touching;
      std::vector<PressedPoint> pressed;
      double                    force = 0, energy = 0, penetration = 0;
    };

    const Communicator &communicator_;
    std::vector<Wall>   walls_;
  };
} // namespace vfife

#endif
