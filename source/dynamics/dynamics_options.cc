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
                                            {"assembly", StepBound::assembly}};

    const Choices<bool> precisions = {{"double", false}, {"single", true}};

    const Choices<Start> starts = {{"static preload", Start::static_preload},
                                   {"steady swing", Start::steady_swing},
                                   {"ramp", Start::ramp},
                                   {"undeformed", Start::undeformed}};

    const Choices<StartSolver> start_solvers = {{"factorization", StartSolver::factorization},
                                                {"relaxation", StartSolver::relaxation}};

    /** Entries of the dampers, in the section entered. */
    void declare_damping(dealii::ParameterHandler &prm, DynamicsOptions &options)
    {
      declare_quantity(
        prm,
        "damping",
        options.damping,
        "1/s",
        "zeta of the damping force -zeta m (v - u), u the rigid motion that supports leave free or "
        "prescribe: of a body on its axis the turn about it, of a clamped or sprung one none",
        Range::not_negative());
      declare_number(
        prm,
        "damping ratio",
        options.damping_ratio,
        "Instead of damping: damping ratio of a vibration at the damping frequency, "
        "zeta/(4 pi frequency); at others it goes with the reciprocal of the frequency; "
        "0: damping holds",
        Range::between(0., 1.));
      declare_quantity(prm,
                       "damping frequency",
                       options.damping_frequency,
                       "Hz",
                       "Frequency at which the damping ratio holds",
                       Range::not_negative());
      declare_quantity(
        prm,
        "mesh damping",
        options.mesh_damping,
        "1/s",
        "zeta_k of -zeta_k m (omega - omega_kinematic) x r on the driven member of a gear pair",
        Range::not_negative());
      declare_choice(prm,
                     "damping rate",
                     options.damping_rate,
                     damping_rates,
                     "Angular velocity omega of the body in the damping force");
    }
  } // namespace

  void RelaxationOptions::declare(dealii::ParameterHandler &prm)
  {
    Subsection section(prm, "Relaxation");
    declare_number(prm,
                   "tolerance",
                   tolerance,
                   "Norm of the unbalanced nodal forces over the norm of the applied ones at which "
                   "the equilibrium is accepted",
                   Range::between(1e-12, 1e-2));
    declare_integer(prm,
                    "largest number of steps",
                    largest_steps,
                    "Relaxation steps after which the run is given up",
                    1);
    declare_integer(prm,
                    "load steps",
                    load_steps,
                    "Equal parts in which a static study applies loads and prescribed "
                    "displacements one after the other",
                    1,
                    100000);
    declare_quantity(prm,
                     "virtual damping",
                     virtual_damping,
                     "1/s",
                     "zeta of the virtual damping -zeta m v with true masses and time step; 0: "
                     "scaled masses and a damping that follows the motion",
                     Range::not_negative());
  }

  void DynamicsOptions::declare(dealii::ParameterHandler &prm)
  {
    Subsection section(prm, "Dynamics");
    declare_choice(
      prm, "frame", frame, frame_choices(), "Rigid rotation that is removed from each element");
    declare_choice(prm, "stiffness", stiffness, stiffness_choices(), "Stiffness of the hexahedron");
    declare_choice(prm,
                   "stiffness data",
                   single_stiffness,
                   precisions,
                   "Precision in which the hourglass stiffness of elements without congruent "
                   "copies is stored; everything else, and all arithmetic, is double");
    declare_choice(
      prm,
      "step bound",
      step_bound,
      step_bounds,
      "Largest frequency that bounds the step: of the worst free element, or of the whole model "
      "without constraints (larger steps; a run that becomes unstable goes back and on with half "
      "of it)");
    declare_number(
      prm, "safety", safety, "Time step over the largest stable one", Range::between(0.01, 1.));
    declare_quantity(
      prm,
      "mass scaling step",
      mass_scaling_step,
      "s",
      "Stable step, before the safety, that elements with a smaller one get by added "
      "mass; 0: none",
      Range::not_negative());
    declare_number(prm,
                   "largest added mass",
                   largest_added_mass,
                   "Share of a body's mass that mass scaling may add; more is refused",
                   Range::between(0., 1.));
    default_damping_ = damping;
    declare_damping(prm, *this);
    declare_choice(prm, "start", start, starts, "How a turning gear pair takes up its load");
    declare_choice(prm,
                   "start solver",
                   start_solver,
                   start_solvers,
                   "What finds the equilibrium of a gear pair before the start; a factorization is "
                   "fast and takes up to 45 kB of memory a node");
    declare_number(prm,
                   "energy limit",
                   energy_limit,
                   "Energy error (residual of the ledger over its scale) beyond which the run "
                   "stops as failed when it goes on growing; "
                   "from two fifths of it there is a warning",
                   Range::positive());
    declare_integer(prm,
                    "largest number of steps",
                    largest_steps,
                    "Steps after which a run ends in good order, to try a part of it; 0: no limit");
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
