// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A gear pair that goes on from checkpoints: same digits in all files, no second equilibrium.
#include "../child_program.h"
#include "../quick_pair.h"

using namespace vfife;

int main(int argc, char **argv)
{
  MpiSession    session(argc, argv);
  Communicator &world = session.world();
  std::filesystem::remove_all("whole");
  std::filesystem::remove_all("parts");
  // Friction and damping of the contact, so that everything that contact remembers is needed.
  std::ofstream("gear.prm") << quick_pair("set body type = rim only",
                                          "set elements through rim = 2",
                                          "1e-4")
                            << "subsection Contact\n  set friction coefficient = 0.1\n"
                               "  set damping ratio = 0.1\nend\n"
                               "subsection Fillets\n  set teeth = all\n  set gauges = G\n"
                               "  subsection Gauge G\n    set body = pinion\n"
                               "    set length = 0.5 mm\n  end\nend\n"
                               "subsection Pressure\n  set instants = 0, 0.9\n"
                               "  set every = 0.25\n  set pressure cells = 6\nend\n";
  const std::string steps = "Dynamics/maximum number of steps=";
  run_pair("gear.prm", "whole", world);
  run_pair("gear.prm", "parts", world, {steps + "333"});
  run_pair("gear.prm", "parts", world, {steps + "700"}, true);
  run_pair("gear.prm", "parts", world, {}, true);

  for (const char *name : {"history.csv",
                           "teeth.csv",
                           "probes.csv",
                           "pattern.csv",
                           "root_stress.csv",
                           "gauges.csv",
                           "pressure.csv",
                           "pressure_field.csv",
                           "fillet_envelope.csv",
                           "root_sections.csv"})
    {
      const std::string whole = read_text("whole/" + std::string(name));
      check(std::string(name) + ": same digits",
            whole.size() > 100 && whole == read_text("parts/" + std::string(name)));
    }
  auto whole = nlohmann::ordered_json::parse(read_text("whole/summary.json")),
       parts = nlohmann::ordered_json::parse(read_text("parts/summary.json"));
  for (const char *section : {"transmission error",
                              "figures",
                              "steady part",
                              "energy",
                              "damping audit",
                              "contact losses",
                              "warnings"})
    check(std::string(section) + ": same", whole.at(section) == parts.at(section));
  const std::string log   = read_text("parts/run.log");
  const std::string start = "equilibrium before the start";
  check("one equilibrium", has_text(log, start) && log.find(start) == log.rfind(start));
  return 0;
}
