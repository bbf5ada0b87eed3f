// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_pressed_wall_h
#define vfife_dynamics_loads_pressed_wall_h

#include <vfife/contact/law/friction_law.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <cmath>
#include <memory>
#include <vector>

namespace vfife
{
  class ByteStream;
  class Communicator;

  /**
   * One rigid wall and the nodes of this rank that may press on it. A node that touches sticks to
   * the wall by a spring behind a slider, as points between two bodies do (StickSlip).
   */
  struct PressedWall
  {
    struct Node
    {
      std::uint32_t local;
      bool          owned;
      double        area;      ///< [mm^2]
      double        stiffness; ///< penalty over the wall's [-]
      double        mass;      ///< [t]
      unsigned int  node;      ///< of the body
      std::size_t   index;     ///< in the wall's definition
      /** Stiffness with which it sticks, of the step and the penalty [N/mm^3]. */
      double tangential = 0;
      /** Where it sticks while it touches; displacement from there and energy of the spring when it
       * last moved on [mm], [mJ]. */
      bool    sticks  = false;
      Vector3 anchor  = Vector3::Zero();
      double  elastic = 0, energy = 0;
    };
    /** A node that presses: depth behind the plane [mm], pressure [MPa]. */
    struct Touch
    {
      Node  *node;
      double depth, pressure;
    };

    /** Throws InputError for a wall whose nodes contain no face of the @p body. */
    PressedWall(const RigidWall &definition, const Body &body, const Partition &partition);

    const PenaltyOptions &options() const
    {
      return definition->penalty;
    }
    /** Gap-rate damping with friction [N s/mm^3]. */
    double damping() const
    {
      return friction_law
               ? 2. * definition->friction.damping_ratio * std::sqrt(penalty * mass_per_area)
               : 0.;
    }
    bool has_friction() const
    {
      return friction_law && mode != FrictionMode::none;
    }

    /** Sets the stiffness of nodes that stick for a step of @p dt [s]. */
    void set_step(double dt);

    /** Begins an evaluation: no touches and sums yet. @p time: see evaluated_step. */
    void begin(double time);

    /** Finds the nodes behind the plane and their pressures at rest. */
    void find_touches(const NodeField &positions);

    /** A @p node at @p x that has come there by @p way since the evaluation before does not touch.
     */
    void open(Node &node, const Vector3 &x, const Vector3 &way);

    /** Friction of a node under @p pressure, whose anchor follows [N]; call it only where there is
     * friction. */
    Vector3 stick(Node &node, double pressure, const Vector3 &x, const Vector3 &way);

    /** For checkpoints: where nodes stick, of all ranks. Collective. */
    void serialize(ByteStream &stream, const Communicator &communicator);

    const RigidWall                   *definition;
    std::unique_ptr<const ContactLaw>  law;
    std::unique_ptr<const FrictionLaw> friction_law;  ///< none: no friction
    double                             mass_per_area; ///< least of its nodes [t/mm^2]
    double                             penalty;       ///< largest [N/mm^3]
    double                             depth_limit;   ///< see RigidWalls::is_too_deep() [mm]
    std::vector<Node>                  nodes;
    FrictionMode                       mode = FrictionMode::follows;

    /** Of the last evaluation, this rank. */
    double             evaluated_step = 0; ///< [s]; 0: at rest
    std::vector<Touch> touches;
    double             force = 0, energy = 0, friction_loss = 0, lost_power = 0;
    Vector3            friction = Vector3::Zero(); ///< [N]
  };
} // namespace vfife

#endif
