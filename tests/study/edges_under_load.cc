// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Tooth pairs that carry within and outside their path of contact, and what is said of a torque
// under which the flanks cannot last.
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/base/text/table.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>
#include <vfife/study/cases/edges_under_load.h>

#include <nlohmann/json.hpp>

using namespace vfife;

namespace
{
  /** A path from -0.9 to 1.1 pitches. */
  EdgesUnderLoad make_watch()
  {
    ContactAnalysis analysis;
    analysis.ends[0].border = "gear tip";
    analysis.ends[0].place  = -0.9;
    analysis.ends[1].border = "pinion heel";
    analysis.ends[1].place  = 1.1;
    return EdgesUnderLoad(analysis, 27);
  }

  struct Row
  {
    double      time;
    const char *side;
    double      tooth, force;
  };

  /** Mesh frequency 9 kHz. */
  EdgesUnderLoad observe(const std::vector<Row> &rows)
  {
    Table teeth;
    teeth.add_column("time", "s");
    teeth.add_text_column("side");
    teeth.add_column("pinion tooth", "-");
    teeth.add_column("force", "N");
    for (const Row &row : rows)
      teeth.add_row({row.time, row.side, row.tooth, row.force});
    EdgesUnderLoad watch = make_watch();
    watch.observe(teeth, "time", 1. / 9000);
    return watch;
  }

  double value(const EdgesUnderLoad &edges, const char *name)
  {
    return edges.json().at(name).at("value").get<double>();
  }

  void places()
  {
    const double mesh = 1. / 9000;
    // Tooth 0 at its mean contact, tooth 26 half a pitch before its own; after 27 meshes tooth 0
    // is there again; what the coast side does does not count.
    const EdgesUnderLoad inside = observe({{0, "drive", 0, 5000},
                                           {.5 * mesh, "drive", 26, 4000},
                                           {1.05 * mesh, "drive", 0, 900},
                                           {27.2 * mesh, "drive", 0, 4500},
                                           {.5 * mesh, "coast", 10, 800}});
    check("inside: no edges",
          !inside.found() && value(inside, "largest force before it") == 0 &&
            value(inside, "largest force after it") == 0);
    check("inside: said so", inside.explain().rfind("no edges carry", 0) == 0);

    // Tooth 26 comes into contact 0.95 pitches early, tooth 1 leaves 1.2 pitches late.
    const EdgesUnderLoad outside = observe({{.05 * mesh, "drive", 0, 5000},
                                            {.05 * mesh, "drive", 26, 300},
                                            {.2 * mesh, "drive", 1, 70},
                                            {27.2 * mesh, "drive", 1, 60}});
    check("outside: edges carry", outside.found());
    check_close("outside: before [N]", value(outside, "largest force before it"), 300, 0);
    check_close("outside: after [N]", value(outside, "largest force after it"), 70, 0);
    check("outside: named",
          outside.explain().find("before the path of contact (gear tip") != std::string::npos &&
            outside.explain().find("after the path of contact (pinion heel") != std::string::npos);
    check("a touch is none",
          !observe({{0, "drive", 0, 5000}, {.05 * mesh, "drive", 26, 49}}).found());
  }

  /** What --check says of the coarse pair, whose Hertz pressure is 1296 MPa at 800 N m. */
  std::string look(const std::vector<std::string> &overrides, Communicator &communicator)
  {
    CommandLine line;
    line.parameter_file = "pressure.prm";
    line.check          = true;
    line.overrides      = overrides;
    std::ostringstream screen;
    Log                log(screen, true);
    run_study(line, communicator, log);
    return screen.str();
  }

  void pressures(Communicator &communicator)
  {
    std::ofstream("pressure.prm") << quick_pair("set web = none", "set rim rows = 2", "1e-6");
    const std::string words = "is above the allowed";
    check("800 N m: nothing is said", look({}, communicator).find(words) == std::string::npos);
    const std::string tenfold = look({"Operation/torque=8000 N m"}, communicator);
    // The cube root of ten times as much
    check("8000 N m: it is said",
          tenfold.find("2793 MPa, is above the allowed 1500 MPa") != std::string::npos);
    check("another limit",
          look({"Operation/allowed contact pressure=1.2 GPa"}, communicator)
              .find("is above the allowed 1200 MPa") != std::string::npos);
    check("no limit",
          look({"Operation/torque=8000 N m", "Operation/allowed contact pressure=0"}, communicator)
              .find(words) == std::string::npos);
  }
} // namespace

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  places();
  pressures(session.world());
  return 0;
}
