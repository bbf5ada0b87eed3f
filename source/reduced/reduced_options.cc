// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/reduced/reduced_options.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Orders of the mesh frequency that the modes have by themselves. */
    constexpr double kept_orders = 6;
  } // namespace

  void ReducedOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_quantity(prm,
                     "cutoff frequency",
                     cutoff,
                     "Hz",
                     "Modes of the bodies below it are kept; what lies above gives way at once. 0: "
                     "six times the mesh frequency, at least seven times (kind waves: three "
                     "times) that at which a free ring at the gear's pitch circle breathes",
                     Range::not_negative());
    declare_integer(
      prm, "steps per mesh", steps_per_mesh, "Steps in a tooth mesh, at least", 4, 100000);
    declare_integer(prm,
                    "steps per mode",
                    steps_per_mode,
                    "Steps in the shortest period of a mode that is kept, at least",
                    2,
                    1000);
    declare_integer(prm,
                    "reach",
                    reach,
                    "Teeth on each side of a loaded one whose residual flexibility is kept",
                    1,
                    1000);
    declare_text(prm,
                 "store",
                 store,
                 "Folder in which the reduced bodies are kept, so that other speeds and torques do "
                 "not pay for them again. Those of other bodies there are refused. Without a name "
                 "nothing is kept");
    declare_switch(
      prm,
      "export",
      exports,
      "Whether mass, stiffness, Coriolis matrix and modes of each body at hub, rim and "
      "probes are written for other programs, in the format Matrix Market");
    declare_integer(prm,
                    "settling meshes",
                    settling_meshes,
                    "Tooth meshes at each speed of a sweep before those that are counted",
                    0,
                    1000000);
    declare_integer(
      prm, "counted meshes", counted_meshes, "Tooth meshes at each speed of a sweep", 1, 1000000);
  }

  double ReducedOptions::find_cutoff(const double mesh_frequency, const double least) const
  {
    return cutoff > 0 ? cutoff : std::max(least, kept_orders * mesh_frequency);
  }

  unsigned int ReducedOptions::find_steps(const double       mesh_frequency,
                                          const double       cutoff,
                                          const unsigned int samples) const
  {
    const double least = std::max(double(steps_per_mesh), steps_per_mode * cutoff / mesh_frequency);
    return samples * static_cast<unsigned int>(std::ceil(least / samples));
  }
} // namespace vfife
