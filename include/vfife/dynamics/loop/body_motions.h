// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loop_body_motions_h
#define vfife_dynamics_loop_body_motions_h

#include <vfife/dynamics/dynamics_options.h>
#include <vfife/dynamics/motion/damping_reference.h>
#include <vfife/dynamics/motion/nodal_update.h>
#include <vfife/dynamics/update_sums.h>
#include <vfife/dynamics/watch/energy_book.h>

#include <vector>

namespace vfife
{
  class ByteStream;
  class Communicator;
  struct Model;
  struct State;

  /**
   * The rigid motions of the bodies in explicit steps: rates by their momenta, the damping relative
   * to them, and the places of State::body_motion that follow (doc/theory/dynamics.md, The rate of
   * a body).
   */
  class BodyMotions
  {
  public:
    /** @p masses: of this rank's nodes [t]. All must outlive this. */
    BodyMotions(const Model               &model,
                const DynamicsOptions     &options,
                const std::vector<double> &masses,
                const Communicator        &communicator);

    /** The lines about which the bodies' moments are. */
    const UpdateAxis &axis(const unsigned int body) const
    {
      return references_[body].axis();
    }
    std::vector<UpdateAxis> axes() const;

    /** Takes rates, by the momenta of the velocities, and places of the bodies from a state that a
     * run begins with. Collective. */
    void begin(const State &state);
    /** Takes the places alone. Collective. */
    void take_places(const State &state);

    /** The rates by the momenta after the last update, by body. */
    const std::vector<RigidVelocity> &rates() const
    {
      return rates_;
    }
    /** Those about the bodies' axes [rad/s]. */
    std::vector<double> axial_rates() const;

    /** Sets the damping of the step of length @p dt [s] that begins with the @p state. Collective
     * for damping relative to the mean speed. */
    void                            set_damping(const State &state, double dt);
    const std::vector<BodyDamping> &damping() const
    {
      return damping_;
    }

    /** Sums of the last update, over all ranks once the step has added them up. */
    std::vector<BodySums> &sums()
    {
      return sums_;
    }
    const std::vector<BodySums> &sums() const
    {
      return sums_;
    }

    /** Adds the powers of dampers and drives on the bodies to those of the step. */
    void add_powers(StepWork &work) const;

    /** Takes rates from the sums of the update and moves the bodies by a step [s]. */
    void advance(double dt, State &state);

    /** For checkpoints: rates, and places. */
    void serialize_rates(ByteStream &stream);
    void serialize_places(ByteStream &stream);

  private:
    /** Of the dampers relative to the kinematic rotation: power that the motion beside that
     * rotation loses [mJ/s]. */
    double find_swing_power(double mesh_power) const;

    const Model                  &model_;
    const DynamicsOptions        &options_;
    const std::vector<double>    &masses_;
    const Communicator           &communicator_;
    std::vector<RigidVelocity>    rates_;
    std::vector<DampingReference> references_;
    std::vector<BodyDamping>      damping_;
    std::vector<BodySums>         sums_;
  };
} // namespace vfife

#endif
