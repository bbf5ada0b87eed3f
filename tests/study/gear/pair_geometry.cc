// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The main dimensions that every study of a gear pair states: of a proposed pair against closed
// forms, of one from a settings sheet against the sheet, and the log beside the file.
#include "../../read_files.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <filesystem>

using namespace vfife;

nlohmann::json
find_geometry(const std::string &name, const std::string &text, Communicator &communicator)
{
  std::filesystem::remove_all(name);
  std::ofstream(name + ".prm") << text;
  run_pair(name + ".prm", name, communicator);
  return read_json(name + "/geometry.json");
}

std::string study(const std::string &kind)
{
  return "subsection Study\n  set kind = " + kind + "\nend\n";
}

void proposed(Communicator &communicator)
{
  const nlohmann::json  json = find_geometry("geometry_proposed",
                                            study("tooth contact analysis") + R"(
subsection Gear pair
  subsection Proposal
    set pinion teeth = 17
    set gear teeth   = 43
    set module       = 4 mm
  end
end
)",
                                            communicator);
  const nlohmann::json &pair = json.at("pair"), &pinion = json.at("pinion"),
                       &gear = json.at("gear");
  const double degree = std::atan(1.) / 45, outer = 2 * std::hypot(17, 43), width = .3 * outer,
               mean = outer - width / 2, cone = std::atan2(17, 43);
  check("proposed: hands",
        pinion.at("hand of spiral") == "left" && gear.at("hand of spiral") == "right");
  check_close("proposed: module [mm]", value_of(pair, "outer transverse module"), 4, 1e-12);
  check_close("proposed: mean normal module [mm]",
              value_of(pair, "mean normal module"),
              4 * mean / outer * std::cos(35 * degree),
              1e-12);
  for (const nlohmann::json *member : {&pinion, &gear})
    {
      const std::string name  = member == &pinion ? "proposed pinion: " : "proposed gear: ";
      const double      teeth = member == &pinion ? 17 : 43,
                   d          = member == &pinion ? cone : 90 * degree - cone;
      check(name + "teeth", value_of(*member, "number of teeth") == teeth);
      check_close(name + "spiral [deg]", value_of(*member, "mean spiral angle"), 35, 1e-12);
      check_close(name + "pitch angle [deg]", value_of(*member, "pitch angle"), d / degree, 1e-10);
      check_close(name + "outer cone distance [mm]",
                  value_of(*member, "outer cone distance"),
                  outer,
                  1e-10);
      check_close(name + "mean cone distance [mm]",
                  value_of(*member, "mean cone distance"),
                  mean,
                  1e-10);
      check_close(name + "face width [mm]", value_of(*member, "face width"), width, 1e-10);
      check_close(name + "outer pitch diameter [mm]",
                  value_of(*member, "outer pitch diameter"),
                  4 * teeth,
                  1e-10);
      // The tip rises from the mean addendum with the face angle.
      const double addendum =
        value_of(*member, "mean addendum") +
        std::tan(value_of(*member, "face angle") * degree - d) * (outer - mean);
      check_close(name + "outer tip diameter [mm]",
                  value_of(*member, "outer tip diameter"),
                  4 * teeth + 2 * addendum * std::cos(d),
                  1e-9);
    }
  check_close("proposed: cutter diameter [mm]",
              value_of(gear, "cutter diameter, mean of the point radii"),
              2 * .82 * mean,
              1e-9);
}

void from_a_sheet(Communicator &communicator)
{
  const nlohmann::json json =
    find_geometry("geometry_sheet",
                  std::string("include ") + tree_folder() + "/prm/paper_pair.prm\n" +
                    study("tooth contact analysis"),
                  communicator);
  check("sheet: teeth",
        value_of(json.at("pinion"), "number of teeth") == 27 &&
          value_of(json.at("gear"), "number of teeth") == 79);
  const nlohmann::json &gear = json.at("gear");
  check_close("sheet: module times teeth is the diameter [mm]",
              value_of(json.at("pair"), "outer transverse module") * 79,
              value_of(gear, "outer pitch diameter"),
              1e-9);
  check_close("sheet: pitch angle [deg]",
              std::tan(value_of(gear, "pitch angle") * std::atan(1.) / 45),
              79. / 27,
              1e-9);
}

void in_the_log()
{
  const std::string text = read_text("geometry_proposed/run.log");
  for (const char *words : {"hand of spiral                                     left      right",
                            "outer pitch diameter [mm]                            68        172"})
    check("log: " + std::string(words), has_text(text, words));
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  proposed(session.world());
  from_a_sheet(session.world());
  in_the_log();
  return 0;
}
