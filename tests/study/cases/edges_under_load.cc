// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Tooth pairs that carry within and outside their path of contact, and what is said of a torque
// under which the flanks cannot last.
#include "../../read_files.h"
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/base/text/table.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>
#include <vfife/study/cases/edges_under_load.h>

using namespace vfife;

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
  check("inside: said so", inside.explain().rfind("no edge contact", 0) == 0);

  // Tooth 26 comes into contact 0.95 pitches early, tooth 1 leaves 1.2 pitches late.
  const EdgesUnderLoad outside = observe({{.05 * mesh, "drive", 0, 5000},
                                          {.05 * mesh, "drive", 26, 300},
                                          {.2 * mesh, "drive", 1, 70},
                                          {27.2 * mesh, "drive", 1, 60}});
  check("outside: edge contact", outside.found());
  check_close("outside: before [N]", value(outside, "largest force before it"), 300, 0);
  check_close("outside: after [N]", value(outside, "largest force after it"), 70, 0);
  check("outside: named",
        has_text(outside.explain(), "gear tip at the start of the engagement") &&
          has_text(outside.explain(), "pinion heel at the end of the engagement"));
  check("a touch is none",
        !observe({{0, "drive", 0, 5000}, {.05 * mesh, "drive", 26, 49}}).found());
  const std::string one =
    observe({{0, "drive", 0, 5000}, {.05 * mesh, "drive", 26, 300}}).explain();
  check("outside: an edge without force is not named",
        has_text(one, "gear tip") && !has_text(one, "pinion heel"));
}

/** What --check says of the coarse pair, whose Hertz pressure is 1296 MPa at 800 N m. */
std::string look(const std::vector<std::string> &overrides,
                 Communicator                   &communicator,
                 const std::string              &file = "pressure.prm")
{
  return check_case(file, communicator, overrides);
}

void pressures(Communicator &communicator)
{
  std::ofstream("pressure.prm") << quick_pair("set body type = rim only",
                                              "set elements through rim = 2",
                                              "1e-6");
  const std::string words = "exceeds the limit of";
  check("800 N m: nothing is said", !has_text(look({}, communicator), words));
  const std::string tenfold = look({"Operation/torque=8000 N m"}, communicator);
  // The cube root of ten times as much
  check("8000 N m: it is said", has_text(tenfold, "2793 MPa, exceeds the limit of 1500 MPa"));
  check("another limit",
        has_text(look({"Operation/contact stress limit=1.2 GPa"}, communicator),
                 "exceeds the limit of 1200 MPa"));
  check("no limit",
        !has_text(look({"Operation/torque=8000 N m", "Operation/contact stress limit=0"},
                       communicator),
                  words));
}

/** The load at the pinion: 800 x 27/79 = 273.418 N m. */
void torques(Communicator &communicator)
{
  const std::string words = "torque on the pinion 273.4 N m, on the gear 800 N m";
  check("both torques, the gear's given", has_text(look({}, communicator), words));
  check("the pinion's given",
        has_text(look({"Operation/torque=0", "Operation/pinion torque=273.41772 N m"},
                      communicator),
                 words));
  print_refusal([&] { look({"Operation/pinion torque=273 N m"}, communicator); });
  print_refusal([&] { look({"Operation/torque=0"}, communicator); });
}

/** All kinds say the same of the case: 1296 MPa above 1200, in log and summary, and what the log
 * warns of. */
void kinds(Communicator &communicator)
{
  using Entries                                          = std::vector<std::string>;
  const std::vector<std::pair<std::string, Entries>> all = {
    {"run", {"Dynamics/maximum number of steps=1"}},
    {"reduced", {"Reduced/cutoff frequency=9 kHz"}},
    {"reduced",
     {"Reduced/cutoff frequency=9 kHz",
      "Reduced/sweep=up",
      "Reduced/lowest speed=18000 rpm",
      "Reduced/highest speed=20000 rpm",
      "Reduced/speeds=2",
      "Reduced/settling mesh cycles=1",
      "Reduced/recorded mesh cycles=1"}},
    {"loaded tooth contact analysis",
     {"Loaded contact/positions=1", "Contact/friction coefficient=0.1"}},
    {"tooth contact analysis", {}}};
  for (const auto &[kind, more] : all)
    {
      Entries entries = more;
      entries.insert(entries.end(),
                     {"Study/kind=" + kind, "Operation/contact stress limit=1.2 GPa"});
      run_pair("pressure.prm", "kind", communicator, entries);
      const nlohmann::json summary = read_json("kind/summary.json");
      const auto           found   = summary.at("input conflicts").dump();
      const std::string    log     = read_text("kind/run.log");
      check(kind + ": input conflict in the summary",
            has_text(found, "1296 MPa, exceeds the limit of 1200 MPa"));
      check("in the log", has_text(log, "warning: input conflict: Hertzian pressure"));
      check("friction where there is none",
            has_text(found, "no friction") == has_text(kind, "loaded"));
      std::size_t n_warnings = 0;
      for (std::size_t at = 0; (at = log.find("\nwarning: ", at)) != std::string::npos; ++at)
        ++n_warnings;
      check("warnings of the log in the summary",
            summary.at("warnings").size() + summary.at("input conflicts").size() == n_warnings);
    }
}

/** An analysis without steps has no need of a speed. */
void at_rest(Communicator &communicator)
{
  run_pair("pressure.prm",
           "rest",
           communicator,
           {"Study/kind=loaded tooth contact analysis",
            "Loaded contact/positions=1",
            "Operation/speed=0"});
  check("loaded at rest", read_json("rest/summary.json").at("status") == "finished");
  check_close("torque of the contact at rest [N m]",
              read_columns("rest/loaded_contact.csv").at("contact torque on the gear")[0],
              800,
              1e-4);
}

/** Dampers are strong or weak against a rate of the gear: a pair of a fifth of the size and with
 * five times the rates has the same checks. */
void sizes(Communicator &communicator)
{
  const auto pair = [](const double scale) {
    const auto mm = [&](const double size) { return std::to_string(scale * size) + " mm"; };
    return "subsection Gear pair\n set mesh = coarse\n subsection Proposal\n  set pinion teeth = "
           "19\n  set gear teeth = 43\n  set module = " +
           mm(4.5) + "\n  set face width = " + mm(30) +
           "\n  set spiral angle = 35 deg\n  set contact ellipse ratio = " +
           std::to_string(scale * 4.6) +
           "\n end\n subsection Gear\n  subsection Body\n   set body type = rim only\n  end\n "
           "end\nend\nsubsection Operation\n set speed = " +
           std::to_string(9000 / scale) +
           " rpm\n set torque = " + std::to_string(600 * scale * scale * scale) +
           " N m\n set mesh cycles = 1\nend\n";
  };
  std::ofstream("large.prm") << pair(1);
  std::ofstream("small.prm") << pair(.2);
  const std::string words = "it distorts the static deflection";
  for (const double damping : {2000., 3000.})
    for (const bool small : {false, true})
      {
        const std::string said =
          look({"Dynamics/driven speed damping=" + std::to_string(damping * (small ? 5 : 1))},
               communicator,
               small ? "small.prm" : "large.prm");
        check(std::string(small ? "small" : "large") + (damping > 2500 ? ": strong" : ": usual"),
              has_text(said, words) == (damping > 2500));
      }
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  places();
  pressures(session.world());
  torques(session.world());
  kinds(session.world());
  at_rest(session.world());
  sizes(session.world());
  return 0;
}
