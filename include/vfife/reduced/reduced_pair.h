// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_reduced_pair_h
#define vfife_reduced_reduced_pair_h

#include <vfife/contact/contact_impulse.h>
#include <vfife/fem/pair/pressed_pair.h>
#include <vfife/reduced/pair/pair_energy.h>
#include <vfife/reduced/pair/pair_reader.h>
#include <vfife/reduced/pair/pair_rows.h>
#include <vfife/reduced/reduced_body.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace vfife
{
  class ByteStream;
  class PressedBalance;
  struct Model;
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
    ReducedPair(const ReducedPair &) = delete; // its parts refer to each other

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

    /** Of the bodies as they are now. */
    const PairReader &reader() const
    {
      return reader_;
    }
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
    const ReducedBody &body(const unsigned int b) const
    {
      return members_[b]->body;
    }
    /** Of Body::axis about the axis of the body's sectors: 1 or -1. */
    double sector_sense(const unsigned int b) const
    {
      return members_[b]->sense;
    }
    /** [s] */
    double time_step() const
    {
      return drive_.step;
    }
    /** On the driven body about its axis now [N mm]. */
    double load() const
    {
      return drive_.load;
    }

  private:
    /** The drive goes on to the end of the step that begins: returns the mean loads of bodies. */
    std::vector<AxialLoad> advance_drive();
    /** Finds the contact at the end of a step, were the modes then at @p coordinates without it,
     * with more nodes where it comes upon some that were not looked at. */
    void balance(const std::vector<std::vector<Eigen::VectorXcd>> &coordinates,
                 const TurnLoad                                   &load);
    /** The same; returns false where the contact comes upon nodes without rows. */
    bool balance_at_rows(const std::vector<std::vector<Eigen::VectorXcd>> &coordinates,
                         const TurnLoad                                   &load);
    /** Coordinates of all modes under the axial loads alone where they stand still in space. */
    std::vector<std::vector<Eigen::VectorXcd>> standing_coordinates() const;
    /** Modes and turn become those that stand still under the present contact. */
    void stand();
    /** Bearings without contact, from the linear ones. */
    PressedState settle(PairAnswers &answers, const Eigen::VectorXd &base);
    /** Takes the bearings at the end of the step as their state, without dampers. */
    void set_bearings();
    /** What the present contact does to the modes and the turn of each body. */
    std::vector<ModalForces> project() const;
    ReducedEquilibrium       find_slope(PressedBalance &equilibrium) const;
    void                     measure_angles(Measurements &measured) const;
    void                     measure_contact(State &state) const;
    double                   measure_drive_torque() const;
    void                     add_contact_impulse();

    const Model                 &model_;
    double                       tolerance_;
    PressedPair                  pair_;
    PairMembers                  members_;
    PairDrive                    drive_;
    PairRows                     rows_;
    PairBearings                 bearings_;
    PressedState                 now_;
    PairEnergy                   energy_;
    PairReader                   reader_;
    std::unique_ptr<PairAnswers> answers_;
    Eigen::VectorXd              displacements_; ///< of all rows at the end of the last step
    Eigen::VectorXd              earlier_force_; ///< a step before, at the rows, or empty
    double                       earlier_torque_ = 0;
    std::uint64_t                n_iterations_   = 0;
    bool           stands_ = false; ///< the rows' flexibility is that of forces that stand in space
    ContactImpulse contact_impulse_;
  };
} // namespace vfife

#endif
