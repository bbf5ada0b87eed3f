// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/types.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/element/frame.h>

namespace vfife
{
  namespace
  {
    const Choices<DampingRate> damping_rates = {{"momentum", DampingRate::momentum},
                                                {"mean speed", DampingRate::mean_speed}};

    const Choices<StepBound> step_bounds = {{"element", StepBound::element},
                                            {"global", StepBound::assembly}};

    const Choices<bool> precisions = {{"double", false}, {"single", true}};

    const Choices<Start> starts = {{"static equilibrium", Start::static_preload},
                                   {"steady torsional vibration", Start::steady_swing},
                                   {"ramp", Start::ramp},
                                   {"undeformed", Start::undeformed}};

    const Choices<StartSolver> start_solvers = {{"factorization", StartSolver::factorization},
                                                {"relaxation", StartSolver::relaxation}};

    /** Entries of the dampers, in the section entered. */
    void declare_damping(dealii::ParameterHandler &prm, DynamicsOptions &options)
    {
      declare_quantity(prm,
                       "mass proportional damping",
                       options.damping,
                       "1/s",
                       "Mass proportional damping zeta (Rayleigh's alpha): force -zeta m (v - u) "
                       "on each node with "
                       "velocity v; u is the velocity of the rigid motion that the supports allow: "
                       "the rotation of a rotating body, 0 of a clamped or sprung body",
                       Range::not_negative());
      declare_number(
        prm,
        "damping ratio",
        options.damping_ratio,
        "Damping ratio at the damping frequency, instead of mass proportional "
        "damping: zeta = 4 pi ratio frequency; at other frequencies the ratio is "
        "inversely proportional to the frequency; not given: mass proportional damping "
        "applies",
        Range::between(0., 1.).or_word("not given"));
      declare_quantity(prm,
                       "damping frequency",
                       options.damping_frequency,
                       "Hz",
                       "Frequency at which the damping ratio applies",
                       Range::not_negative());
      declare_quantity(prm,
                       "driven speed damping",
                       options.mesh_damping,
                       "1/s",
                       "Damping of the driven member's rotation against its kinematic speed: force "
                       "-zeta_k m (omega - omega_kinematic) x r on each node",
                       Range::not_negative());
      declare_choice(prm,
                     "damping reference",
                     options.damping_rate,
                     damping_rates,
                     "Angular velocity omega in the damping force: momentum: from the angular "
                     "momentum of the body; mean speed: mean of the nodes");
    }
  } // namespace

  void RelaxationOptions::declare(dealii::ParameterHandler &prm)
  {
    Subsection section(prm, "Relaxation");
    declare_number(prm,
                   "tolerance",
                   tolerance,
                   "Convergence limit: norm of the unbalanced nodal forces divided by the norm "
                   "of the applied forces",
                   Range::between(1e-12, 1e-2));
    declare_integer(prm,
                    "maximum number of steps",
                    largest_steps,
                    "Maximum number of relaxation steps; the study stops with an error if it "
                    "needs more",
                    1);
    declare_integer(prm,
                    "load steps",
                    load_steps,
                    "Number of equal load steps in which a static study applies loads and "
                    "prescribed displacements",
                    1,
                    100000);
    declare_quantity(prm,
                     "virtual damping",
                     virtual_damping,
                     "1/s",
                     "zeta of a virtual damping force -zeta m v with true masses and true time "
                     "step; adaptive: scaled masses with adaptive damping",
                     Range::positive().or_word("adaptive"));
  }

  void DynamicsOptions::declare(dealii::ParameterHandler &prm)
  {
    Subsection section(prm, "Dynamics");
    declare_choice(prm,
                   "corotational frame",
                   frame,
                   frame_choices(),
                   "How the rigid rotation of each element is found before it is removed: polar "
                   "decomposition, or a frame through three nodes");
    declare_choice(prm,
                   "element type",
                   stiffness,
                   stiffness_choices(),
                   "Element type: hexahedra with incompatible modes, with full integration (lock "
                   "in bending), or with reduced integration and hourglass control");
    declare_choice(prm,
                   "stiffness data",
                   single_stiffness,
                   precisions,
                   "Precision in which the hourglass stiffness of elements without congruent "
                   "copies is stored; all other data and all arithmetic are double");
    declare_choice(prm,
                   "time step estimate",
                   step_bound,
                   step_bounds,
                   "Largest frequency for the critical time step. element: of the stiffest "
                   "single element; global: of the whole model without constraints, which gives "
                   "larger steps. If a run becomes unstable, it restarts from the last "
                   "checkpoint with half the step");
    declare_number(prm,
                   "time step factor",
                   safety,
                   "Time step divided by the critical time step",
                   Range::between(0.01, 1.));
    declare_quantity(prm,
                     "mass scaling step",
                     mass_scaling_step,
                     "s",
                     "Mass scaling: elements with a smaller critical time step (before the time "
                     "step factor) get additional mass until they reach this one; none: no mass "
                     "scaling",
                     Range::positive().or_word("none"));
    declare_number(prm,
                   "maximum added mass",
                   largest_added_mass,
                   "Maximum additional mass by mass scaling, as a part of the body's mass; the "
                   "program refuses more",
                   Range::between(0., 1.));
    default_damping_ = damping;
    declare_damping(prm, *this);
    declare_choice(
      prm,
      "start",
      start,
      starts,
      "Initial state of a gear pair or general model. static equilibrium: starts "
      "loaded; steady torsional vibration: starts with the periodic vibration at the mesh "
      "frequency; ramp: torque grows linearly; undeformed: starts unloaded");
    declare_choice(prm,
                   "start solver",
                   start_solver,
                   start_solvers,
                   "Solver for the static equilibrium at the start: factorization (fast, up to "
                   "45 kB of memory per node), or relaxation");
    declare_number(prm,
                   "energy limit",
                   energy_limit,
                   "The run stops with an error when the energy error (residual of the energy "
                   "balance divided by its scale) exceeds this limit and grows; the program "
                   "warns at two fifths of the limit",
                   Range::positive());
    declare_integer(prm,
                    "maximum number of steps",
                    largest_steps,
                    "The run ends after this number of steps, for trials; 0: no limit");
    relaxation.declare(prm);
  }

  double DynamicsOptions::mass_damping() const
  {
    return damping_ratio > 0 ? 4. * pi * damping_frequency * damping_ratio : damping;
  }

  double damping_ratio_at(const double frequency, const double zeta)
  {
    return zeta / (4. * pi * frequency);
  }

  void DynamicsOptions::check(const std::string &section) const
  {
    // What is at its default has not been given, as in a file that states all entries.
    if (damping_ratio > 0 && damping != default_damping_)
      throw InputError(section + "/damping ratio",
                       "expected damping [1/s] or a damping ratio, got both. Remove one of them");
    if ((damping_ratio > 0) != (damping_frequency > 0))
      throw InputError(section + (damping_ratio > 0 ? "/damping frequency" : "/damping ratio"),
                       damping_ratio > 0
                         ? "is missing. Set the frequency at which the damping ratio holds"
                         : "is missing or zero, but a damping frequency is given");
  }
} // namespace vfife
