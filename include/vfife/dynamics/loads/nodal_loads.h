// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_nodal_loads_h
#define vfife_dynamics_loads_nodal_loads_h

#include <vfife/bearing/mean_motion.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <optional>
#include <vector>

namespace vfife
{
  class Communicator;
  class VfifeOperator;

  /** The forces of Model::loads on the nodes of this rank. */
  class NodalLoads
  {
  public:
    /** Throws InputError for a load that its nodes cannot carry (no face, all on a line). */
    NodalLoads(const Model &model, VfifeOperator &vfife, const Communicator &communicator);

    /** Largest stable step [s] where elements and contact allow @p step: springs have their share
     * of the largest frequency, 4/dt^2 >= 4/step^2 + k/m, k of all springs of a node together. */
    double vote_on_step(double step) const;

    /** Adds the masses that springs need in a relaxation with pseudo time step 1. */
    void add_relaxation_masses(double fraction, std::vector<double> &masses) const;

    /** Adds the forces at @p time to @p forces (all copies of a node); remembers them for
     * half_power(), all but those of springs. Collective. */
    void add_forces(double time, const NodeField &positions, NodeField &forces);

    /** The same with @p part of the values, whatever their histories. Collective. */
    void add_part(double part, const NodeField &positions, NodeField &forces);

    /** Energy that springs to the ground store, k_i (x_i - X_i)^2/2 over all directions [mJ].
     * Collective. */
    double compute_spring_energy(const NodeField &positions) const;

    /** Adds what the model's springs exert on this rank's nodes, to those of @p reactions that
     * follow the constraints'. */
    void add_spring_reactions(const NodeField &positions, std::vector<Reaction> &reactions) const;

    /** Half of the power of the remembered forces with these velocities on this rank [mJ/s]. */
    double half_power(const NodeField &velocities) const;

  private:
    struct Node
    {
      std::uint32_t local;
      std::uint32_t of_set; ///< place in the load's list of nodes
      bool          owned;
      double        weight; ///< area, share of one, or mass
      Vector3       start;  ///< fixed frame, undeformed
    };
    struct Face
    {
      std::uint32_t local[4]; ///< in turn, seen from outside counter-clockwise
    };
    struct Group
    {
      const Load               *load;
      std::vector<Node>         nodes;
      std::vector<Face>         faces;  ///< of elements on this rank
      std::optional<MeanMotion> motion; ///< of a moment's set
    };

    void find_spring_frequency();
    void add_faces(const Load &load, Group &group) const;
    void add(const Group &group, double factor, const NodeField &positions);
    void add_moment(const Group &group, const Vector3 &moment, const NodeField &positions);
    void add_pressure(const Group &group, double pressure, const NodeField &positions);
    void add_springs(const NodeField &positions, NodeField &forces) const;
    void finish(const NodeField &positions, NodeField &forces);

    const Model        &model_;
    VfifeOperator      &operator_;
    const Communicator &communicator_;
    std::vector<Group>  groups_;
    NodeField           forces_;      ///< of all loads but springs; empty without loads
    NodeField           face_forces_; ///< of this rank's elements
    bool                has_pressure_       = false;
    double              largest_frequency2_ = 0; ///< k/m of springs [1/s^2]
  };
} // namespace vfife

#endif
