// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_bearing_loads_h
#define vfife_dynamics_loads_bearing_loads_h

#include <vfife/bearing/bearing_system.h>
#include <vfife/bearing/shaft_seat.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <vector>

namespace vfife
{
  class Communicator;

  /** The forces of Model::bearings and Model::couplings on the nodes of this rank. */
  class BearingLoads
  {
  public:
    /** Throws InputError for a seat whose nodes lie on a line. */
    BearingLoads(const Model &model, const Partition &partition, const Communicator &communicator);

    /** Largest stable step [s] where everything else allows @p step: springs have their share of
     * the largest frequency, and dampers, whose rates lag by half a step, theirs of the step. */
    double vote_on_step(double step) const;

    /** Adds the masses that the springs need in a relaxation with pseudo time step 1. */
    void add_relaxation_masses(double fraction, std::vector<double> &masses) const;

    /**
     * Adds the forces on bodies that have turned for @p time [s] at their rates to @p forces (all
     * copies of a node); remembers them for powers and add_reactions(). Windings of couplings go on
     * from those remembered. Collective.
     */
    void add_forces(double           time,
                    const NodeField &positions,
                    const NodeField &velocities,
                    NodeField       &forces);

    /** The same of bodies at rest in axes that have not turned yet: of springs alone. */
    void add_forces_at_rest(const NodeField &positions, NodeField &forces);

    /** Of the couplings at the last add_forces(), whole turns counted [rad]; equal on all ranks. */
    std::vector<double> windings() const;
    /** Where they go on from. */
    void set_windings(const std::vector<double> &windings);

    /** What the springs store at the positions of add_forces() [mJ]; equal on all ranks. */
    double energy() const;

    /** What the remembered forces take from the drives through couplings and for rolling cages on
     * their way between two times [mJ/s]; equal on all ranks. */
    double drive_power(double from, double to) const;
    /** The part of that which goes through the couplings' dampers. */
    double damper_drive_power(double from, double to) const;

    /** Half of what all dampers' forces do on this rank's nodes with these velocities [mJ/s]:
     * called before and after the update. */
    double half_damper_power(const NodeField &velocities) const;

    /** Adds the remembered forces on this rank's nodes to those of @p reactions from @p first on,
     * in the order of list_supports(). */
    void add_reactions(const NodeField       &positions,
                       std::size_t            first,
                       std::vector<Reaction> &reactions) const;

    /** Of each bearing at the last add_forces(), its damper included; equal on all ranks. */
    std::vector<SeatState> bearing_states() const;

  private:
    struct Node
    {
      std::uint32_t local;
      std::uint32_t of_set; ///< place in the list of nodes
      bool          owned;
    };
    struct Seat
    {
      Seat(const Partition                 &partition,
           const Body                      &of_body,
           const std::vector<unsigned int> &of_nodes,
           const SelectedFaces             &faces,
           const Matrix3                   &axes,
           const std::string               &owner);

      /** In the fixed frame's axes, of displacement and turn. */
      Eigen::Matrix<double, 6, 6> stiffness_bound() const;
      Eigen::Matrix<double, 6, 6> damping_matrix() const;

      const Bearing            *bearing  = nullptr; ///< or
      const Coupling           *coupling = nullptr; ///< either of them
      const Body               *body;
      ShaftSeat                 seat;
      MeanMotion                set;
      std::vector<unsigned int> all_nodes;      ///< of the body
      std::vector<Node>         nodes;          ///< on this rank
      double                    frequency2 = 0; ///< largest k/m [1/s^2]
      double                    decay      = 0; ///< largest c/m [1/s]
      // At the last add_forces():
      MeanMotion::Motion motion;
      SeatState          state;             ///< of a bearing
      Wrench             elastic, damping;  ///< on the shaft
      double             drive_torque  = 0; ///< of a coupling, or on a bearing's cage [N mm]
      double             damper_torque = 0; ///< of the damper alone
      double             winding       = 0; ///< of a coupling, whole turns counted [rad]
    };

    /** Largest frequency and decay of the springs and dampers of a seat on the nodes' masses. */
    static void find_limits(Seat &seat);
    void        read_motions(const NodeField &positions, const NodeField *velocities);
    /** Of all seats whose motions are known. */
    void respond(double time, bool at_rest);
    void respond_bearings(double time, bool at_rest);
    void respond_coupling(double time, bool at_rest, Seat &seat);
    void add_to(NodeField &forces) const;

    const Communicator &communicator_;
    BearingSystem       system_;
    std::vector<Seat>   seats_;          ///< of bearings, then of couplings
    double              energy_     = 0; ///< of all springs at the last add_forces() [mJ]
    double              frequency2_ = 0; ///< largest k/m of all springs together [1/s^2]
    double              decay_      = 0; ///< largest c/m of all dampers together [1/s]
  };
} // namespace vfife

#endif
