// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// One file for several kinds of study: sections that a kind does not read stay in it, but what is
// misspelt in them is found. Modes at rest ask for no speed.
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <filesystem>

using namespace vfife;

const std::string all_sections = R"(
subsection Model
  set bodies      = bar
  set constraints = clamp
  subsection Body bar
    set mesh    = block
    set elements x = 4
    set elements y = 2
    set elements z = 2
  end
  subsection Constraint clamp
    set nodes = x-
  end
end
subsection Dynamics
  set end time = 1 us
end
subsection Linear static
  set loads = full
end
subsection Fem
  set modes = 2
end
subsection Output
  set report = no
end
)";

std::string of_kind(const std::string &kind, const std::string &text)
{
  return "subsection Study\n  set kind = " + kind + "\nend\n" + text;
}

/** What the log says of sections that are not read. */
std::string do_study(const std::string &text, Communicator &world, const bool check = false)
{
  std::ofstream("one_file.prm") << text;
  CommandLine line;
  line.parameter_file = "one_file.prm";
  line.output_folder  = "one_file";
  line.check          = check;
  std::ostringstream said;
  Log                log(said, world.is_root(), Verbosity::normal);
  run_study(line, world, log);
  std::istringstream lines(said.str());
  for (std::string one; std::getline(lines, one);)
    if (has_text(one, "ignored by this kind"))
      return one;
  return "all sections are read";
}

void refuse(const std::string &text, Communicator &world)
{
  print_refusal([&] { do_study(text, world); });
}

std::string replaced(std::string text, const std::string &what, const std::string &by)
{
  return text.replace(text.find(what), what.size(), by);
}

int main(int argc, char **argv)
{
  MpiSession    session(argc, argv);
  Communicator &world = session.world();
  for (const char *kind : {"run", "static", "modal", "linear static"})
    {
      std::filesystem::remove_all("one_file");
      std::cout << kind << ": " << do_study(of_kind(kind, all_sections), world) << std::endl;
    }
  check("results of that file", std::filesystem::exists("one_file/reactions.csv"));

  refuse(of_kind("modal", replaced(all_sections, "Dynamics", "Dynamcs")), world);
  refuse(of_kind("modal", replaced(all_sections, "end time", "ent time")), world);
  refuse(of_kind("modal", replaced(all_sections, "1 us", "1 mm")), world);
  refuse(of_kind("run", replaced(all_sections, "set modes", "set mods")), world);
  // What no kind reads for a model, though one of a gear pair does.
  refuse(of_kind("run", all_sections + "subsection Operation\n  set speed = 100 rpm\nend\n"),
         world);
  refuse(of_kind("run", all_sections + "subsection Gear pair\nend\n"), world);
  // A case that the kind does not take: those that do are named.
  refuse(of_kind("waves", all_sections), world);
  refuse(of_kind("tooth contact analysis", all_sections), world);

  // A gear pair at rest: no speed, no torque. A run needs them.
  const std::string pair  = R"(
subsection Gear pair
  subsection Pinion
    subsection Mesh
      set elements along face width = 2
      set elements across tooth = 2
      set elements along profile = 2
      set elements through rim = 2
    end
  end
  subsection Gear
    subsection Body
      set body type = rim only
    end
    subsection Mesh
      set elements along face width = 2
      set elements across tooth = 2
      set elements along profile = 2
      set elements through rim = 2
    end
  end
end
subsection Dynamics
  set mass proportional damping = 1000
end
)";
  const std::string paper = std::string("include ") + tree_folder() + "/prm/paper_pair.prm\n";
  std::cout << do_study(of_kind("modal", paper + pair), world, true) << std::endl;
  refuse(of_kind("run", paper + pair), world);
  refuse(of_kind("static", pair), world);

  // Kinds without a mesh pass over what carries it and its load, within sections that they read.
  const std::string loaded = paper + pair + "subsection Operation\n  set speed  = 20000 rpm\n" +
                             "  set torque = 800 N m\nend\n";
  for (const char *kind : {"run", "tooth contact analysis"})
    std::cout << kind << ": " << do_study(of_kind(kind, loaded), world, true) << std::endl;
  refuse(of_kind("tooth contact analysis", replaced(loaded, "set body type", "set body tipe")),
         world);
  refuse(of_kind("tooth contact analysis", replaced(loaded, "subsection Body", "subsection Bdy")),
         world);
  refuse(of_kind("tooth contact analysis", loaded + "subsection Model\nend\n"), world);
  return 0;
}
