// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_reduced_pair_h
#define vfife_reduced_reduced_pair_h

#include <vfife/bearing/mean_motion.h>
#include <vfife/contact/contact_impulse.h>
#include <vfife/fem/pair/bearing_springs.h>
#include <vfife/fem/pair/pressed_pair.h>
#include <vfife/reduced/modal_motion.h>
#include <vfife/reduced/reduced_body.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace vfife
{
  class ByteStream;
  struct Model;
  struct Probe;
  struct State;

  struct ReducedPairOptions
  {
    double step         = 0; ///< [s]
    double damping      = 0; ///< zeta of the modes [1/s]
    double mesh_damping = 0; ///< zeta_k of the driven body's turn [1/s]
    /** Unbalanced forces over contact forces at the end of a step. */
    double tolerance = 1e-7;
  };

  /** Throws InputError where the model is no gear pair, and for friction or damping there. */
  void require_reducible(const Model &model);

  /** The equilibrium from which a reduced pair starts. */
  struct ReducedEquilibrium
  {
    double       turn       = 0; ///< of the driven body beyond its kinematic turn [rad]
    double       stiffness  = 0; ///< torque over rotation of the driven hub [N mm/rad]
    double       inertia    = 0; ///< of the shape of that slope, over its rotation [t mm^2]
    unsigned int iterations = 0;
  };

  /**
   * A gear pair of reduced bodies in true contact: its steps are those of the modes, exact for
   * forces that are the mean of both ends, and at the end of each the contact is in balance with
   * the flexibilities that act at once (doc/theory/reduced.md, Steps). No step is too long for
   * stability. The driver turns at its rate, the driven body carries the model's torque on it, both
   * over time as the model has them. Bodies on shafts have the whole laws of their bearings, in
   * balance like the contact (doc/theory/reduced.md, On bearings).
   */
  class ReducedPair
  {
  public:
    /** @p bodies: both, in the model's order. Throws as require_reducible(), and InputError where
     * the driven body does not turn freely. The model must outlive the object. */
    ReducedPair(const Model              &model,
                std::vector<ReducedBody>  bodies,
                const ReducedPairOptions &options);
    ~ReducedPair();

    /** The equilibrium at time zero, which stands still in space. @p part of the load on the
     * flanks, the rest accelerates the driven body, which has the @p rate [rad/s] beyond its
     * kinematic one. Throws NumericalError. */
    ReducedEquilibrium start(double part = 1., double rate = 0.);

    /** From now on a driver of constant rate turns at @p driver_rate [rad/s, drive direction], in
     * steps of @p step [s]; relative motion goes on. Throws NumericalError where unstable. */
    void set_speed(double driver_rate, double step);

    /** One step. Throws NumericalError with the position, also where flanks pass each other. */
    void step();

    /** One step of the drive at whose end both bodies stand still in space, in equilibrium: what
     * the present load and rate make of them without vibration, whatever the step is. set_speed()
     * leads back to motion. Throws NumericalError, naming the position. */
    void step_standing();

    /** Sets time, step and measurements; forces at the nodes where the field is not empty. */
    void measure(State &state);

    /** Over all steps since the start; checkpoints pass it beside serialize(). */
    ContactImpulse &contact_impulse()
    {
      return contact_impulse_;
    }

    /** The value of a reading (its place among those of the body) on a sector, spin included. */
    using Reader = std::function<double(unsigned int reading, unsigned int sector)>;

    /** Reads body @p b as it is now; the pair must outlive the function. */
    Reader reader(unsigned int b) const;

    /** What @p probes show, which are the model's or copies of them in other sectors. */
    std::vector<ProbeValue> measure_probes(const std::vector<Probe> &probes) const;

    /** Coefficients of the rim's waves [um] up to @p largest diameters, as RimWaves has them. */
    std::vector<double> measure_rim(unsigned int largest);

    /** What the contact does to the modes of a body now, in the order of ReducedBody::harmonics. */
    std::vector<Eigen::VectorXcd> measure_modal_forces(unsigned int body) const;

    /** Turn of a body's momentum about its axis beyond the kinematic one [rad]. */
    double measure_turn(unsigned int body) const;

    /** The mean motion of a ring (its name) of a body in bearings now, without rates. */
    MeanMotion::Motion measure_ring(unsigned int body, const std::string &name) const;

    /** Where flank nodes of a body are now (3 each), fixed frame [mm]. */
    std::vector<double> places_of(unsigned int b, const std::vector<unsigned int> &nodes) const;

    /** Mean motion of a body now, body frame to fixed frame. */
    RigidMotion body_motion(const unsigned int b) const
    {
      return pair_.body_motion(b);
    }

    /** Passes the motion; reading, of a pair of the same bodies with the same step, which goes on
     * as it would have but for round-off. */
    void serialize(ByteStream &stream);

    /** Newton iterations of all steps. */
    std::uint64_t n_iterations() const
    {
      return n_iterations_;
    }
    const ReducedBody &body(unsigned int b) const;
    /** Of Body::axis about the axis of the body's sectors: 1 or -1. */
    double sector_sense(unsigned int b) const;
    /** [s] */
    double time_step() const
    {
      return options_.step;
    }
    /** On the driven body about its axis now [N mm]. */
    double load() const
    {
      return load_;
    }

  private:
    struct Member;
    class Answers;
    using NodeOfBody = std::pair<unsigned int, unsigned int>;

    /** Of the driver since time zero after @p n_steps more steps [rad]. */
    double driver_turn(double n_steps) const;
    /** Rates now over those of the model at time zero. */
    double speed_factor() const;
    /** Turn, rates and torques go on to the end of the step that begins: returns their means in it,
     * by body. */
    std::vector<AxialLoad> advance_drive();
    /** Throws NumericalError where the driven body turns so far [rad] in a step beyond the driver.
     */
    void   check_turn(double turned) const;
    double driven_turn() const; ///< kinematic, in the drive direction [rad]
    /** Looks for what may touch in the steps until the next search. */
    void search();
    void search_when_due();
    /** Finds the contact at the end of a step, with more nodes where it comes upon some that were
     * not looked at. */
    void balance_widely(const std::vector<std::vector<Eigen::VectorXcd>> &coordinates,
                        const TurnLoad                                   &load);
    /** Coordinates of all modes under the axial loads alone where they stand still in space. */
    std::vector<std::vector<Eigen::VectorXcd>> standing_coordinates() const;
    /** Modes and turn become those that stand still under the present contact. */
    void stand();
    /** From now on rows are of these nodes; forces at nodes that stay go with them. */
    void set_rows(std::vector<NodeOfBody> nodes);
    /** Where nodes are displaced to now (3 each, axes of time zero) [mm]. */
    Eigen::VectorXd displace_nodes(const std::vector<NodeOfBody> &nodes) const;
    /** Those of body @p b, in their order. */
    static std::vector<unsigned int> nodes_of(const std::vector<NodeOfBody> &nodes, unsigned int b);
    /** Of a node's rows, in the axes of time zero. */
    Matrix3 axes_of(unsigned int body, unsigned int node) const;
    /** Rows in the state of spin, under the torques, and with the modes' @p coordinates by body. */
    Eigen::VectorXd displace(const std::vector<std::vector<Eigen::VectorXcd>> &coordinates) const;
    Eigen::VectorXd rows_of(const Member &member, const Eigen::VectorXd &x) const;
    Eigen::Index    n_rows() const
    {
      return owners_.size();
    }
    /** Bearings without contact, from the linear ones. */
    PressedState settle(Answers &answers, const Eigen::VectorXd &base);
    /** Takes the bearings at the displacements @p u of the rows as their state, without dampers. */
    void set_bearings(const Eigen::VectorXd &u);
    /** Throws NumericalError where bearings let the flanks move farther than contact is looked for;
     * @p u: of the candidates @p nodes, axes of time zero. */
    void check_reach(const std::vector<NodeOfBody> &nodes, const Eigen::VectorXd &u) const;
    /** Finds the contact at the end of a step, were the modes then at @p coordinates without it;
     * not where it comes upon nodes without rows. */
    bool balance(const std::vector<std::vector<Eigen::VectorXcd>> &coordinates,
                 const TurnLoad                                   &load);
    /** What the contact does to the modes and the turn of each body. */
    std::vector<ModalForces> project(const PressedState &state) const;
    ReducedEquilibrium       find_slope(Answers &answers, const Eigen::VectorXd &u);
    /** Way of the torque about the axis, of the driven body's turn and of its bore [rad]. */
    double torque_way() const;
    /** Of a step, with the mean @p torque on the driven body. */
    void add_work(double torque, double way_before, const EnergyLedger &powers_before);
    /** Powers now: of what drives and what is lost [mJ/s]. */
    EnergyLedger find_powers() const;
    /** Of the dampers of bearings in a step from the state @p before. */
    void   add_damping(const BearingSprings::Response &before);
    void   measure_transmission(Measurements &measured) const;
    void   measure_bearings(Measurements &measured) const;
    double measure_drive_torque() const;
    void   measure_contact(State &state) const;
    void   add_contact_impulse();
    void   measure_energy();
    void   restart_energy();
    /** Mean rotation of bore or rim about the axis beyond the kinematic turn [rad]. */
    double read_turn(const Member &member, const char *reading) const;

    const Model                         &model_;
    ReducedPairOptions                   options_;
    std::vector<std::unique_ptr<Member>> members_; ///< by body
    PressedPair                          pair_;
    std::unique_ptr<Answers>             answers_;
    std::vector<NodeOfBody>              nodes_; ///< of the rows, sorted
    /** Body of each row and its place among that body's rows; those of bearings are the last. */
    std::vector<std::pair<unsigned int, Eigen::Index>> owners_;
    BearingSprings                                     springs_;
    BearingSprings::Response bearings_; ///< as they are now, dampers left out
    BearingSprings::Response damped_;   ///< with those of the last step
    Eigen::VectorXd          rows_;     ///< displacements of all rows at its end
    PressedState             now_;
    Eigen::VectorXd          earlier_force_; ///< a step before, at the rows, or empty
    double                   earlier_torque_ = 0;
    double                   load_           = 0; ///< torque on the driven body now [N mm]
    double                   driver_rate_    = 0; ///< at time zero [rad/s]
    double                   driver_turn_    = 0; ///< since time zero [rad]
    double                   time_           = 0;
    std::uint64_t            step_           = 0;
    std::uint64_t            n_iterations_   = 0;
    unsigned int             search_steps_ = 1, since_search_ = 0;
    double                   searched_from_ = 0, searched_to_ = 0; ///< turns of the driver [rad]
    Eigen::VectorXd          held_;         ///< displacements of candidates then, or empty [mm]
    unsigned int             widening_ = 0; ///< doublings of the distance looked at
    bool           stands_ = false; ///< the rows' flexibility is that of forces that stand in space
    EnergyLedger   energy_, first_energy_;
    ContactImpulse contact_impulse_;
  };
} // namespace vfife

#endif
