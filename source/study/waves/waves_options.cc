// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/number_list.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/quantity.h>
#include <vfife/output/output_options.h>
#include <vfife/study/waves/waves_options.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Offsets beyond are no surroundings of a line [-]. */
    constexpr double largest_offset = .5;
  } // namespace

  void WavesOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_quantity(prm,
                     "lowest speed",
                     lowest_speed,
                     "rpm",
                     "Of the pinion: waves are met from here on, by the speed in contact; 0: from "
                     "rest on",
                     Range::not_negative());
    declare_quantity(prm,
                     "highest speed",
                     highest_speed,
                     "rpm",
                     "Of the pinion: up to here, and speed at which the bodies are reduced",
                     Range::not_negative());
    declare_number_list(prm,
                        "diameters",
                        diameters,
                        "Numbers of nodal diameters of the gear's waves; 0: all sectors move "
                        "alike, as an umbrella",
                        ListNumbers::whole);
    declare_integer(prm,
                    "wave orders",
                    wave_orders,
                    "Waves of each number of diameters and direction, from the lowest on",
                    1,
                    100);
    declare_integer(prm,
                    "mesh harmonics",
                    mesh_orders,
                    "Multiples of the mesh frequency that may drive a wave, from 1 on",
                    1,
                    100);
    declare_integer(
      prm, "speeds", n_speeds, "Speeds of the waves' frequencies in the diagram", 2, 10000);
    declare_switch(prm,
                   "driven",
                   driven,
                   "Whether each wave is driven at its speed and around it; if not, speeds are "
                   "predicted only");
    static const Choices<WaveSolver> solvers = {{"reduced", WaveSolver::reduced},
                                                {"run", WaveSolver::run}};
    declare_choice(
      prm,
      "solver",
      solver,
      solvers,
      "What is driven: the reduced pair; or whole bodies, an explicit run of this file "
      "at each speed in a folder of its own, with the reduced pair beside it");
    declare_number_list(prm,
                        "offsets",
                        offsets,
                        "Of the speeds around each predicted one, over it: at least three [-]");
    declare_number(prm,
                   "decay times",
                   decay_times,
                   "Of the wave, at each speed before what is counted: exp(-1) each",
                   Range::positive());
    declare_number(prm,
                   "allowed amplification",
                   allowed_amplification,
                   "Of the largest stress at a probe over that at rest in space, beyond which a "
                   "speed is to be avoided",
                   Range{1., std::numeric_limits<double>::infinity(), true});
    declare_quantity(prm,
                     "margin",
                     margin,
                     "-",
                     "Over the speed, on both sides of what is to be avoided",
                     Range::between(0., .5));
  }

  std::vector<unsigned int> WavesOptions::diameter_numbers() const
  {
    return parse_diameters(diameters);
  }

  std::vector<double> WavesOptions::offset_parts() const
  {
    std::vector<double> parts;
    for (const std::string &text : offsets)
      {
        parts.push_back(parse_quantity(text, "-"));
        if (!(std::abs(parts.back()) <= largest_offset))
          throw InputError("expected at most 50 % to either side, got \"" + text + "\"");
      }
    std::sort(parts.begin(), parts.end());
    if (std::adjacent_find(parts.begin(), parts.end()) != parts.end())
      throw InputError("duplicate offset");
    return parts;
  }

  void WavesOptions::check(const std::string &section) const
  {
    const auto read = [&section](const char *entry, const auto &function) {
      try
        {
          return function();
        }
      catch (const InputError &error)
        {
          throw InputError(section + "/" + entry, error.what());
        }
    };
    if (!(highest_speed > 0))
      throw InputError(
        section + "/highest speed",
        "expected a speed above 0, got 0. Set the range of speeds of the search for waves");
    if (!(highest_speed > lowest_speed))
      throw InputError(section + "/lowest speed", "must be below highest speed");
    if (read("diameters", [this] { return diameter_numbers(); }).empty())
      throw InputError(section + "/diameters",
                       "expected at least one number of nodal diameters, got none");
    if (read("offsets", [this] { return offset_parts(); }).size() < 3)
      throw InputError(section + "/offsets",
                       "expected at least three offsets, such as -1 %, 0 %, 1 %");
  }
} // namespace vfife
