// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Names of entries and words of the previous version: read as those of today where they were, left
// alone elsewhere, refused beside the present name.

#include <vfife/base/parameters/former_names.h>

#include "../refusal.h"
#include "../tests.h"

using namespace vfife;

/** What a file becomes: "Section/name = value" by line, behind each the remark if there is one.
 */
void show(const std::string &text)
{
  auto       statements = read_statements_of_text(text, "case.prm");
  const auto replaced   = replace_former_names(statements);
  for (const ParameterStatement &statement : statements)
    if (!statement.opens_section)
      std::cout << statement.path() << " = " << statement.value << std::endl;
  for (const std::string &remark : replaced)
    std::cout << "  " << remark << std::endl;
}

int main()
{
  show("subsection Operation\n set tooth meshes = 14\n set hub = free rotation\nend\n"
       "subsection Output\n set history every = 30\nend\n");
  show("subsection Model\n subsection Body disc\n  set bearing = yes\n  set cells z = 4\n end\n"
       " subsection Contact foot\n  set discretization = surface points\n end\nend\n"
       "subsection Output\n set history every = 30\nend\n");
  // A file with both is one of a gear pair.
  show("subsection Gear pair\n set mesh = coarse\nend\nsubsection Model\n set bodies =\nend\n"
       "subsection Output\n set history every = 30\nend\n");
  // The same names elsewhere, and present names with present words.
  show("subsection Gear pair\n subsection Proposal\n  set pressure angle = 20 deg\n end\n"
       " subsection Errors\n  subsection Pinion\n   subsection Concave flank\n"
       "    set pressure angle = 3 um\n   end\n  end\n end\n"
       " subsection Gear\n  subsection Body\n   set web = none\n   set web direction = auto\n"
       "  end\n end\nend\n"
       "subsection Dynamics\n set start = ramp\n set element type = full integration\nend\n");

  // An entry that another section has.
  show("subsection Tooth contact analysis\n set driving member = gear\n"
       " set points per pitch = 8\nend\n");

  print_refusal(
    [] { show("subsection Dynamics\n set time step factor = 0.8\n set safety = 0.9\nend\n"); });
  return 0;
}
