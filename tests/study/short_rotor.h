// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_study_short_rotor_h
#define vfife_tests_study_short_rotor_h

#include "../model_sections.h"

#include <map>
#include <string>
#include <vector>

/** Parameter files of shafts in bearings. */
namespace rotor_text
{
  using Columns = std::map<std::string, std::vector<double>>;

  using model_text::study;

  inline std::string
  bearing(const std::string &name, const std::string &where, const std::string &entries)
  {
    return model_text::section("Constraint " + name,
                               "set kind = bearing\nset nodes = section 1\nset where = " + where +
                                 "\n" + entries);
  }

  inline std::string shaft(const std::string &sections, const std::string &entries)
  {
    return model_text::section("Body shaft",
                               "set mesh = stepped shaft\nset sections = " + sections +
                                 "\nset rotating = yes\nset axis direction = 0, 0, 1\n" + entries);
  }

  /** A short cylinder, far stiffer than the bearings at its ends. */
  constexpr double height = 60, stiffness = 5000, rate = 2000;

  inline std::string cylinder(const std::string &kind,
                              const std::string &constraints,
                              const std::string &body,
                              const std::string &bearings,
                              const std::string &rest)
  {
    return study(kind) + "subsection Model\nset bodies = shaft\nset constraints = " + constraints +
           "\nset probes = bottom, top\n" +
           shaft("0 60 100",
                 "set elements around = 16\nset axial element size = 15\nset radial element size = "
                 "20\n" +
                   body) +
           bearing("left", "z < 1", "set radial stiffness = 5000\n" + bearings) +
           bearing("right", "z > 59", "set radial stiffness = 5000\n" + bearings) +
           model_text::probe("bottom", "0, 0, 0 mm") + model_text::probe("top", "0, 0, 60 mm") +
           rest;
  }
} // namespace rotor_text

#endif
