// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/log.h>
#include <vfife/model/model.h>
#include <vfife/reduced/reduced_options.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Orders of the mesh frequency that the modes have by themselves. */
    constexpr double kept_orders = 6;

    const Choices<BodyElements> elements_choices = {{"auto", BodyElements::automatic},
                                                    {"as the run", BodyElements::as_run},
                                                    {"quadratic", BodyElements::quadratic},
                                                    {"cubic", BodyElements::cubic}};
  } // namespace

  void ReducedOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_choice(prm,
                   "element type",
                   elements,
                   elements_choices,
                   "Elements of the bodies: the 8-node elements of explicit runs, or curved "
                   "quadratic (27 nodes) or cubic (64 nodes) elements on the same mesh. auto: "
                   "quadratic elements up to 50,000 elements without bearings and couplings, "
                   "otherwise, and in waves with Waves/solver = run, as the run");
    declare_quantity(
      prm,
      "cutoff frequency",
      cutoff,
      "Hz",
      "Modes of the bodies up to this frequency are kept; higher ones respond "
      "statically. auto: six times the mesh frequency, and at least seven times (kind "
      "waves: three times) the breathing frequency of a free ring at the gear's "
      "pitch circle",
      Range::positive().or_word("auto"));
    declare_integer(prm,
                    "steps per mesh cycle",
                    steps_per_mesh,
                    "Minimum number of steps per mesh cycle",
                    4,
                    100000);
    declare_integer(prm,
                    "steps per mode",
                    steps_per_mode,
                    "Minimum number of steps per period of the highest kept mode",
                    2,
                    1000);
    declare_integer(prm,
                    "residual flexibility reach",
                    reach,
                    "Number of teeth on each side of a loaded tooth whose residual flexibility is "
                    "kept",
                    1,
                    1000);
    declare_text(prm,
                 "store",
                 store,
                 "Folder that keeps the reduced bodies for later studies at other speeds and "
                 "torques; reduced bodies of another model are refused; empty: not kept");
    declare_switch(prm,
                   "export",
                   exports,
                   "Writes mass, stiffness and Coriolis matrices and modes of each body at hub, "
                   "rim and probes for other programs (Matrix Market)");
    declare_integer(prm,
                    "settling mesh cycles",
                    settling_meshes,
                    "Mesh cycles at each speed of a sweep before recording starts",
                    0,
                    1000000);
    declare_integer(prm,
                    "recorded mesh cycles",
                    counted_meshes,
                    "Recorded mesh cycles at each speed of a sweep",
                    1,
                    1000000);
  }

  double ReducedOptions::find_cutoff(const double mesh_frequency, const double least) const
  {
    return cutoff > 0 ? cutoff : std::max(least, kept_orders * mesh_frequency);
  }

  void ReducedOptions::choose_elements(const Model &model, Log &log, const bool as_runs)
  {
    if (elements != BodyElements::automatic)
      return;
    const bool afford = !as_runs && model.bearings.empty() && model.couplings.empty() &&
                        affords_quadratic_elements(model);
    elements = afford ? BodyElements::quadratic : BodyElements::as_run;
    log.line("Reduced/element type = auto: ",
             afford ? "quadratic elements on the exact surfaces" : "as the run");
  }

  FemOptions ReducedOptions::fem(const StiffnessKind stiffness) const
  {
    AssertThrow(elements != BodyElements::automatic, dealii::ExcInternalError());
    if (elements == BodyElements::as_run)
      return make_fem_options(stiffness);
    FemOptions options;
    options.element =
      elements == BodyElements::quadratic ? FemElement::quadratic : FemElement::cubic;
    options.geometry       = FemGeometry::curved;
    options.divides_facets = false;
    return options;
  }

  unsigned int ReducedOptions::find_steps(const double       mesh_frequency,
                                          const double       cutoff,
                                          const unsigned int samples) const
  {
    const double least = std::max(double(steps_per_mesh), steps_per_mode * cutoff / mesh_frequency);
    return samples * static_cast<unsigned int>(std::ceil(least / samples));
  }
} // namespace vfife
