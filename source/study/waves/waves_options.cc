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
                     "Lowest pinion speed at which waves are searched, by the speed in contact; 0: "
                     "from rest",
                     Range::not_negative());
    declare_quantity(prm,
                     "highest speed",
                     highest_speed,
                     "rpm",
                     "Highest pinion speed at which waves are searched; the bodies are reduced at "
                     "this speed",
                     Range::not_negative());
    declare_number_list(
      prm,
      "nodal diameters",
      diameters,
      "Nodal diameters of the gear's waves; 0: all sectors in phase (umbrella mode)",
      ListNumbers::whole);
    declare_integer(prm,
                    "modes per diameter",
                    wave_orders,
                    "Number of modes per nodal diameter and direction, from the lowest",
                    1,
                    100);
    declare_integer(
      prm, "mesh harmonics", mesh_orders, "Mesh harmonics that may excite a wave, from 1", 1, 100);
    declare_integer(prm,
                    "speeds",
                    n_speeds,
                    "Number of speeds at which the diagram has wave frequencies",
                    2,
                    10000);
    declare_switch(prm,
                   "simulate response",
                   driven,
                   "Simulates the response of each wave at and around its predicted speed; no: "
                   "predicts speeds only");
    static const Choices<WaveSolver> solvers = {{"reduced", WaveSolver::reduced},
                                                {"run", WaveSolver::run}};
    declare_choice(prm,
                   "solver",
                   solver,
                   solvers,
                   "Model of the simulated response: reduced pair; or run: an explicit run per "
                   "speed in its own folder, and the reduced pair");
    declare_number_list(
      prm,
      "speed offsets",
      offsets,
      "Speed offsets from each predicted speed, relative to it; at least three [-]");
    declare_number(prm,
                   "settling decay times",
                   decay_times,
                   "Settling time at each speed before recording starts, in decay times of the "
                   "wave (to 1/e)",
                   Range::positive());
    declare_number(prm,
                   "allowed amplification",
                   allowed_amplification,
                   "Limit of the amplification: largest dynamic stress at a probe divided by the "
                   "stress that is constant in space. speeds_to_avoid.csv lists the speeds above "
                   "it. The default is 10 % more stress and no limit of a standard: choose it by "
                   "the fatigue strength",
                   Range{1., std::numeric_limits<double>::infinity(), true});
    declare_quantity(prm,
                     "margin",
                     margin,
                     "-",
                     "Safety margin on both sides of a speed to be avoided, relative to it",
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
    if (!(highest_speed > 0))
      throw InputError(
        section + "/highest speed",
        "expected a speed above 0, got 0. Set the range of speeds of the search for waves");
    if (!(highest_speed > lowest_speed))
      throw InputError(section + "/lowest speed", "must be below highest speed");
    if (for_entry(section + "/nodal diameters", [this] { return diameter_numbers(); }).empty())
      throw InputError(section + "/nodal diameters",
                       "expected at least one number of nodal diameters, got none");
    if (for_entry(section + "/speed offsets", [this] { return offset_parts(); }).size() < 3)
      throw InputError(section + "/speed offsets",
                       "expected at least three offsets, such as -1 %, 0 %, 1 %");
  }
} // namespace vfife
