// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_motion_damping_reference_h
#define vfife_dynamics_motion_damping_reference_h

#include <vfife/dynamics/update_sums.h>
#include <vfife/model/constraints/rigid_freedom.h>

namespace vfife
{
  class ByteStream;
  class Communicator;
  struct State;

  /**
   * The rigid motion of a body that its damping is relative to: of all rigid motions that
   * constraints, springs, bearings and couplings allow or prescribe the one nearest to the body's
   * own, in its kinetic energy (doc/theory/dynamics.md, The motion that is not damped).
   */
  class DampingReference
  {
  public:
    /** Of body @p body of the model, which must outlive this. */
    DampingReference(const Model &model, unsigned int body);

    /** The line that the body's own rigid motion is a turn about, where supports leave no other. */
    const UpdateAxis &axis() const
    {
      return axis_;
    }

    /** Whether the body may turn about its axis, by itself or as prescribed. */
    bool turns() const;

    /**
     * Takes where the body is in @p state: State::body_motion begins with the undeformed place, a
     * shaft that its load displaces does not. Of all nodes with the @p masses of this rank's.
     * Collective.
     */
    void take_place(const State               &state,
                    const std::vector<double> &masses,
                    const Communicator        &communicator);

    /** For checkpoints: the place. */
    void serialize(ByteStream &stream);

    /**
     * At @p time, between steps of length @p dt [s], of a body that is where @p now takes its body
     * frame; @p own is the rigid motion with the body's momenta.
     */
    RigidVelocity
    find(double time, double dt, const RigidMotion &now, const RigidVelocity &own) const;

  private:
    /** Of the factor of a prescribed motion [1/s], or of a rotation at its body's speed that. */
    double rate_of(const PrescribedMotion &prescribed, double time, double dt) const;
    /** What constraints prescribe: velocity of the undeformed centre, then angular velocity. */
    Vector6 find_prescribed(double time, double dt) const;

    const Body  *body_;
    RigidFreedom freedom_;
    UpdateAxis   axis_;
    unsigned int b_;
    RigidMotion  offset_; ///< of the body in the axes of State::body_motion, which goes with it
  };
} // namespace vfife

#endif
