// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_study_shaft_pair_h
#define vfife_tests_study_shaft_pair_h

#include "../model_sections.h"
#include "few_teeth.h"

#include <vfife/base/types.h>

#include <fstream>
#include <map>
#include <string>
#include <vector>

/** A coarse pair on shafts in five bearings, and what its tables say of these. */
namespace shaft_pair
{
  using model_text::study;

  /** A bearing on a shaft; @p x: its x direction. */
  inline std::string bearing(const std::string &name,
                             const std::string &ring,
                             const std::string &x,
                             const std::string &law)
  {
    return "subsection Bearing " + name + "\n" + ring + "set x direction = " + x + "\n" + law +
           "end\n";
  }

  inline std::string ring(const char *from, const char *to)
  {
    return std::string("set from = ") + from + "\nset to = " + to + "\n";
  }

  inline const std::string tapered     = "set kind = rolling bearing\nset element = roller\n"
                                         "set number of elements = 20\nset element diameter = 7\n"
                                         "set element length = 13\nset pitch diameter = 54\n"
                                         "set contact angle = 14 deg\nset preload = 2500\n"
                                         "set cage angle = 3 deg\n",
                           cylindrical = "set kind = rolling bearing\nset element = roller\n"
                                         "set number of elements = 24\nset element diameter = 11\n"
                                         "set element length = 15\nset pitch diameter = 102\n"
                                         "set clearance = -0.005\n",
                           thrust      = "set kind = bearing\nset axial stiffness = 300000\n"
                                         "set axial damping = 1\n";

  /** Laws of the pinion's bearings, front and rear, and of the gear's two rows and thrust bearing.
   */
  struct Laws
  {
    std::string front =
      tapered + "set axial load direction = +z\nset working load = 4000, 0, 3000 N\n";
    std::string rear =
      tapered + "set axial load direction = -z\nset working load = 1500, 0, -2000 N\n";
    std::string straddle = cylindrical, axial = thrust;
  };

  /** The paper's pair: its teeth are fine enough for means over eight positions. */
  inline std::string many_teeth()
  {
    return coarse_pair("set body type = conical web\n", coarse_web);
  }

  /** A pair overhung and straddled, with entries in the section Gear pair; @p cells: size of the
   * shafts' cells [mm]. */
  inline std::string
  pair_on_shafts(const std::string &entries = "",
                 const Laws        &laws    = Laws(),
                 const std::string &pair    = few_teeth("set body type = conical web", coarse_web),
                 const std::string &cells   = "30")
  {
    const std::string across_pinion = "0, 1, 0", across_gear = "1, 0, 0";
    return pair + "subsection Gear pair\n" + entries +
           "subsection Pinion\nsubsection Shaft\n"
           "set sections = 98 160 40 20, 160 220 36 20\nset axial element size = " +
           cells + "\nset radial element size = " + cells + "\nset bearings = front, rear\n" +
           bearing("front", ring("140", "155"), across_pinion, laws.front) +
           bearing("rear", ring("190", "205"), across_pinion, laws.rear) + "subsection End\n" +
           ring("208", "220") +
           "set torsional stiffness = 1e9\nset torsional damping = 1e4\n"
           "end\nend\nend\n"
           "subsection Gear\nsubsection Shaft\n"
           "set sections = -10 30 80 60, 30 120 100 60\nset axial element size = " +
           cells + "\nset radial element size = " + cells +
           "\nset bearings = inner, outer, thrust\n" +
           bearing("inner", ring("-10", "10"), across_gear, laws.straddle) +
           bearing("outer", ring("85", "100"), across_gear, laws.straddle) +
           bearing("thrust", ring("100", "110"), across_gear, laws.axial) + "subsection End\n" +
           ring("110", "120") + "end\nend\nend\nend\n";
  }

  /** Without root stresses. */
  inline std::string operation(const std::string &speed)
  {
    return "subsection Operation\nset speed = " + speed +
           "\nset torque = 800 N m\nset mesh cycles = 1\nend\n"
           "subsection Fillets\nset teeth = none\nend\n"
           "subsection Output\nset samples per mesh cycle = 20\nset report = no\nset verbosity = "
           "quiet\n"
           "end\n";
  }

  inline std::string write(const std::string &name, const std::string &text)
  {
    std::ofstream(name + ".prm") << text;
    return name + ".prm";
  }

  /** Rows of a table with a column of bearings, of its first instant or position: of each bearing
   * the numbers by column. */
  inline std::map<std::string, std::map<std::string, double>>
  first_bearings(const std::string &folder)
  {
    const vfife::Table table = vfife::read_result_table(folder + "/bearings.csv");
    std::map<std::string, std::map<std::string, double>> rows;
    const std::vector<std::string>                      &names = table.column("bearing").texts;
    for (std::size_t i = 0; i < names.size() && rows.count(names[i]) == 0; ++i)
      for (const vfife::Table::Column &column : table.columns())
        if (!column.is_text)
          rows[names[i]][column.name] = column.numbers[i];
    return rows;
  }

  /** Force of a bearing along the fixed frame: z of a pinion's bearings is x there, x is y. */
  inline vfife::Vector3 force_of(const std::string &name, const std::map<std::string, double> &row)
  {
    const vfife::Vector3 f(row.at("force x"), row.at("force y"), row.at("force z"));
    return name[0] == 'p' ? vfife::Vector3(f[2], f[0], f[1]) : f;
  }
} // namespace shaft_pair

#endif
