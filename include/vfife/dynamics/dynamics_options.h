// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_dynamics_options_h
#define vfife_dynamics_dynamics_options_h

#include <vfife/base/parameter_handler.h>
#include <vfife/element/frame_kind.h>
#include <vfife/element/stiffness.h>

#include <string>

namespace vfife
{
  /** Which angular velocity of a body its damping is relative to. */
  enum class DampingRate
  {
    momentum,  ///< L_axis / I_axis: the damper exerts no torque about the axis
    mean_speed ///< mass-weighted mean of |v|/r, the paper's Eq. (8): unsigned, not torque-free
  };

  /** What the stable step of the elements follows from. */
  enum class StepBound
  {
    element, ///< the largest frequency of the worst free element: safe for any assembly
    assembly ///< a bound of the largest frequency of the whole model at rest
  };

  enum class Start
  {
    steady_swing,   ///< static_preload, but a gear pair swings as it does when the swing is steady
    static_preload, ///< rotating-frame equilibrium under centrifugal force, torque and contact,
                    ///< then release
    ramp,           ///< centrifugal equilibrium, then the torque grows linearly
    undeformed      ///< the undeformed bodies with their initial velocities
  };

  /** What finds the equilibrium of a gear pair before the start. */
  enum class StartSolver
  {
    factorization, ///< rounds with the factors of the conventional stiffness matrix: fast, up to
                   ///< 45 kB a node
    relaxation     ///< dynamic relaxation alone: slow, needs no memory
  };

  /** How the equilibrium before the start is found (dynamic relaxation). */
  struct RelaxationOptions
  {
    double       tolerance     = 1e-6;  ///< residual force norm over the norm of the applied forces
    unsigned int largest_steps = 60000; ///< failure beyond
    unsigned int load_steps    = 1;     ///< of a static study: equal parts of the loads, in turn
    /** Virtual damping zeta [1/s] of M a = F - zeta M v with the true masses and time step (the
     * traditional method); 0: scaled masses and a damping that follows the motion. */
    double virtual_damping = 0;

    void declare(dealii::ParameterHandler &prm);
  };

  /** Section Dynamics. */
  struct DynamicsOptions
  {
    FrameKind     frame     = FrameKind::polar;
    StiffnessKind stiffness = StiffnessKind::incompatible_modes;
    /** Hourglass blocks of elements without congruent copies in single precision. */
    bool         single_stiffness  = false;
    StepBound    step_bound        = StepBound::assembly;
    double       safety            = 0.9;   ///< step over the stable step by that bound
    double       damping           = 1000.; ///< zeta [1/s], where no ratio is given
    double       damping_ratio     = 0;     ///< of a mode at damping_frequency [-]; 0: none given
    double       damping_frequency = 0;     ///< [Hz]
    double       mesh_damping      = 2000.; ///< zeta_k [1/s]
    DampingRate  damping_rate      = DampingRate::momentum;
    Start        start             = Start::static_preload;
    StartSolver  start_solver      = StartSolver::factorization;
    double       energy_limit      = 0.05; ///< energy error at which a run is given up [-]
    unsigned int largest_steps     = 0;    ///< a run ends in good order after so many, 0: no limit
    /** Stable step of every element by added mass, before the safety [s]; 0: no mass is added. */
    double            mass_scaling_step  = 0;
    double            largest_added_mass = 0.02; ///< of a body's mass [-]
    RelaxationOptions relaxation;

    void declare(dealii::ParameterHandler &prm);
    void check(const std::string &section) const;

    /** zeta of the damping force -zeta m (v - omega x r) [1/s]: `damping`, or what gives the ratio
     * at its frequency, 4 pi f ratio. */
    double mass_damping() const;

  private:
    double default_damping_ = damping; ///< at declare()
  };

  /** Damping ratio of a vibration of @p frequency [Hz] under the damping force of @p zeta [1/s],
   * zeta/(4 pi frequency) [-]. */
  double damping_ratio_at(double frequency, double zeta);
} // namespace vfife

#endif
