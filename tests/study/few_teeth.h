// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_study_few_teeth_h
#define vfife_tests_study_few_teeth_h

#include "quick_pair.h"

/** A pair of 10 and 29 teeth in the size of the paper's, on meshes as coarse as they go: a third of
 * its nodes, as each tooth has its cells around the axis; entries of the gear's body and mesh. */
inline std::string few_teeth(const std::string &gear_body, const std::string &gear_mesh)
{
  const std::string mesh = "subsection Mesh\nset elements along face width = 2\n"
                           "set elements across tooth = 2\nset elements along profile = 2\n";
  return "subsection Gear pair\n"
         "subsection Proposal\nset pinion teeth = 10\nset gear teeth = 29\n"
         "set module = 8.505 mm\nset pinion hand = right\nset spiral angle = 30 deg\n"
         "set face width = 30 mm\nend\n"
         "subsection Mounting\nset backlash = 0.12 mm\nend\n"
         "subsection Pinion\nsubsection Body\nset bore radius = 20 mm\nend\n" +
         mesh +
         "set elements through rim = 2\nend\nend\n"
         "subsection Gear\nsubsection Body\n" +
         gear_body +
         "\nset bore radius = 50 mm\nset hub radius = 60 mm\nset hub length = 36 mm\nend\n" + mesh +
         gear_mesh + "\nend\nend\nend\ninclude " + tree_folder() +
         "/tests/study/quick_contact/contact.prm\n\n\n";
}

/** One mesh cycle of that pair: as long as 2.7 of the paper's. */
inline std::string quick_few_teeth(const std::string &gear_body,
                                   const std::string &gear_mesh,
                                   const std::string &tolerance)
{
  return few_teeth(gear_body, gear_mesh) + one_tooth_mesh(tolerance);
}

#endif
