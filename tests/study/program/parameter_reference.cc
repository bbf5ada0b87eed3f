// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// doc/parameter_reference.md is what the program declares. After a change:
// build/release/vfife --parameter-reference > doc/parameter_reference.md
#include "../../tests.h"

#include <vfife/base/process/command_line.h>
#include <vfife/study/parameter_reference.h>
#include <vfife/study/study_kinds.h>

#include <fstream>
#include <sstream>

int main()
{
  std::stringstream declared;
  vfife::write_parameter_reference(declared);
  std::ifstream page(tree_folder() + "/doc/parameter_reference.md");
  std::string   line, expected;
  unsigned int  number = 0;
  bool          same   = true;
  while (same && std::getline(declared, expected))
    {
      ++number;
      same = std::getline(page, line) && line == expected;
    }
  same = same && !std::getline(page, line);
  if (!same)
    std::cerr << "doc/parameter_reference.md, line " << number << ": " << line
              << "\nthe program declares: " << expected << "\n";
  check("the page has all sections", number > 300);
  check("the page is what the program declares", same);
  const std::string help = vfife::help_text();
  for (const auto &kind : vfife::study_kinds())
    check("--help has the kind " + kind.first, has_text(help, kind.first));
  return 0;
}
