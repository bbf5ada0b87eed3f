// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_state_h
#define vfife_model_state_h

#include <vfife/base/text/column_names.h>
#include <vfife/base/types.h>
#include <vfife/bearing/shaft_seat.h>
#include <vfife/element/stress.h>
#include <vfife/model/energy_ledger.h>
#include <vfife/model/node_field.h>
#include <vfife/model/partition.h>

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  /** What the dampers did to one body over a run. */
  struct DampingAudit
  {
    std::string body;
    double      net_torque = 0; ///< time mean, about the axis [N mm]
    double      power      = 0; ///< time mean of the loss [mJ/s]
    double      spin_drift = 0; ///< change of the mean rate about the axis [rad/s]
    /** Mean speed rate minus momentum rate, mean over the samples, in the sense of the body's own
     * rate [rad/s]. */
    double rate_difference = 0;
  };

  /** How often a run lost all contact after it had been in contact. */
  struct ContactLosses
  {
    unsigned int count    = 0;
    double       first    = 0; ///< time of the first loss [s]
    double       duration = 0; ///< without contact, all losses together [s]
  };

  /** One tooth pair (or other pair of surface groups) in contact. */
  struct ToothContact
  {
    unsigned int contact     = 0; ///< in Model::contacts
    unsigned int slave_group = 0, master_group = 0;
    Vector3      force  = Vector3::Zero(); ///< on the slave, fixed frame [N]
    double       torque = 0; ///< on the driven member about its axis, + resists the load [N mm]
    double       normal_force     = 0; ///< [N]
    double       largest_pressure = 0; ///< [MPa]
    double       area             = 0; ///< [mm^2]
    double       penetration      = 0; ///< largest [mm]
    /** Across the narrower way, that of a strip with Hertz's pressures and the same second moment
     * of the points' pressures about their centre [mm]. */
    double width = 0;
    /** Of the slave's facets that are pressed, in the mean by pressure [mm]. */
    double facet_width = 0;
  };

  /** What a probe shows at an instant, along its axes: r, theta, z of the body or fixed ones. */
  struct ProbeValue
  {
    Vector3 displacement =
      Vector3::Zero();                    ///< R^T (x - c) - (X - c) in r, theta, z of the body [mm]
    std::array<double, 6> stress    = {}; ///< rr tt zz rt tz zr, node average of the elements [MPa]
    double                von_mises = 0;  ///< [MPa]
  };

  /** Of the displacement [mm] along the probe's axes and the stress [MPa], which @p turns (axes as
   * columns) take one after the other into these axes. */
  ProbeValue make_probe_value(const Vector3                 &displacement,
                              const Stress                  &stress,
                              std::initializer_list<Matrix3> turns);

  /** By which tables choose and order quantities of probes. */
  enum class ProbeQuantityKind
  {
    displacement,
    equivalent_stress, ///< the same in all axes
    stress             ///< component along the axes
  };

  /** A quantity of a probe: a column of result files. */
  struct ProbeQuantity
  {
    ProbeQuantityKind                         kind;
    std::string                               name; ///< "displacement r"
    const char                               *unit; ///< "mm" or "MPa"
    std::function<double(const ProbeValue &)> value;
  };

  /** All quantities along @p axes, in the order of their kinds. */
  std::vector<ProbeQuantity> list_probe_quantities(const column::Axes &axes);

  /** What a constraint, or a spring to the ground, exerts on its nodes. */
  struct Reaction
  {
    Vector3 force  = Vector3::Zero(); ///< fixed frame [N]
    Vector3 moment = Vector3::Zero(); ///< about the fixed origin [N mm]

    void add(const Vector3 &place, const Vector3 &at_node)
    {
      force += at_node;
      moment += place.cross(at_node);
    }
  };

  /** What observers report of one instant; equal on all ranks. */
  struct Measurements
  {
    double driver_angle = 0, driven_angle = 0, rim_angle = 0; ///< in the drive direction [rad]
    double rate_factor        = 1; ///< prescribed rate of the driver over that at time zero [-]
    double transmission_error = 0, rim_transmission_error = 0; ///< [rad]
    double contact_force  = 0; ///< sum over pairs of the resultants' magnitudes [N]
    double contact_torque = 0; ///< on the driven member [N mm]
    double drive_torque   = 0; ///< [N mm]
    unsigned int              teeth_in_contact    = 0;
    double                    largest_penetration = 0; ///< [mm]
    EnergyLedger              energy;
    std::vector<ToothContact> teeth;
    /** On the slave of each contact pair and, behind these, on the body at each wall [N]. */
    std::vector<Vector3>    contact_forces;
    std::vector<ProbeValue> probes;
    std::vector<Reaction>   reactions;  ///< in the order of list_supports()
    std::vector<SeatState>  bearings;   ///< in the order of Model::bearings, dampers included
    std::vector<double>     body_rates; ///< momentum rate of each body about its axis [rad/s]
    /** Of all bodies, velocities half a step back: sum m v [t mm/s = N s], and sum m x x v about
     * the fixed origin [N mm s]. */
    Vector3 momentum = Vector3::Zero(), angular_momentum = Vector3::Zero();
  };

  /**
   * The moving part of a run on this rank. Positions are at `time`, velocities at time - dt/2.
   */
  struct State
  {
    double        time = 0; ///< [s]
    std::uint64_t step = 0;
    double        dt   = 0; ///< [s]
    /** Of the bodies over ranks; copies of a state share it. Set by whoever starts the run. */
    std::shared_ptr<const Partition> partition;
    NodeField                        position; ///< [mm]; number: 1/m [1/t], 0 at constrained nodes
    NodeField                        velocity; ///< [mm/s]; number: m [t], 0 at constrained nodes
    NodeField contact_force; ///< [N], valid when an observer asked for this instant
    /** Mean rigid motion of each body, body frame -> fixed frame now: its momentum's rotation,
     * integrated. */
    std::vector<RigidMotion> body_motion;
    Measurements             measured; ///< of this instant, when an observer asked for it

    Vector3 node_position(const std::uint32_t local) const
    {
      return position.value(local);
    }
    Vector3 node_velocity(const std::uint32_t local) const
    {
      return velocity.value(local);
    }
  };
} // namespace vfife

#endif
