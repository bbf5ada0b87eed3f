// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// From a parameter file to the unloaded tooth contact of the paper's pair: figures and tables
// against the lag of an independent computation and against each other; what is said to the tables
// as they are printed.
#include "../../read_files.h"
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <filesystem>

using namespace vfife;

/** Lag of the gear over pitches [arcsec]: doc/verification/geometry.md, by another program,
 * within 0.01. */
double reference_lag(const double p)
{
  return p * p * (7.199 + .757 * p - .008 * p * p);
}

void check_figures(const nlohmann::json &json)
{
  const nlohmann::json &drive = json.at("drive"), &hand_over = drive.at("transfer point"),
                       &path = drive.at("path"), &working = json.at("working");
  // The lag falls to zero at the mean contact and rises to that of the hand-over on either side.
  check_close("peak to peak [arcsec]",
              value_of(hand_over, "peak to peak"),
              reference_lag(.487),
              4e-3);
  check_ratio("its share of the gear's pitch",
              value_of(hand_over, "share of the gear's pitch") * 360. * 3600. / 79 /
                value_of(hand_over, "peak to peak"),
              1e-12);
  check_close("contact ratio from start to end",
              value_of(path, "end") - value_of(path, "start"),
              value_of(path, "contact ratio"),
              1e-12);
  for (const bool at_end : {false, true})
    {
      const nlohmann::json &beyond = drive.at(at_end ? "beyond the end" : "beyond the start");
      const double          p      = value_of(path, at_end ? "end" : "start");
      check_close("edge contact starts at the path's end",
                  value_of(beyond, "edge contact starts at"),
                  p,
                  1e-12);
      check_close("lag there [arcsec]", value_of(beyond, "lag"), reference_lag(p), .02);
      // Meanwhile the pair a pitch nearer to the middle carries.
      check_close("approach before edge contact [arcsec]",
                  value_of(beyond, "approach before edge contact"),
                  reference_lag(p) - reference_lag(at_end ? p - 1 : p + 1),
                  .02);
    }
  const nlohmann::json &lag = drive.at("lag over pitches");
  for (const double p : {-.9, -.5, .4, .8})
    check_close("lag polynomial [arcsec]",
                value_of(lag, "power 0") + value_of(lag, "power 1") * p +
                  value_of(lag, "power 2") * p * p + value_of(lag, "power 3") * p * p * p +
                  value_of(lag, "power 4") * p * p * p * p,
                reference_lag(p),
                .01);
  // The flanks are as far apart as the marking compound is thick: w = k a^2/2.
  const nlohmann::json &ellipse = drive.at("ellipse at the mean contact");
  const double          gap     = 1e-3 * value_of(json, "marking compound thickness"); // um -> mm
  check_ratio("semi-axis a: gap at its end over the compound",
              value_of(ellipse, "smaller relative curvature") *
                std::pow(value_of(ellipse, "semi-axis a"), 2) / 2 / gap,
              1e-12);
  check_ratio("semi-axis b: gap at its end over the compound",
              value_of(ellipse, "larger relative curvature") *
                std::pow(value_of(ellipse, "semi-axis b"), 2) / 2 / gap,
              1e-12);
  // The pinion drives about + its axis, the gear turns about - its axis and is held back.
  check("senses of rotation and torque",
        value_of(working, "pinion turns") == 1 && value_of(working, "gear turns") == -1 &&
          value_of(working, "torque on the pinion") == 1 &&
          value_of(working, "torque on the gear") == 1);
  check_close("driven speed over driver speed",
              value_of(working, "driven speed over driver speed"),
              27. / 79,
              1e-15);
  // Set with the mean arm of both sides, which are some parts in ten thousand apart.
  check_close("normal backlash [mm]", value_of(json.at("teeth"), "normal backlash"), .12, 1e-4);
}

void check_transmission(const Table &table)
{
  // A sample each 20th of a pitch over two pitches; the pair with the least lag carries.
  const std::vector<double> &angle = table.numbers("driver angle"),
                            &error = table.numbers("transmission error");
  check("transmission: samples", angle.size() == 41);
  double places = 0, errors = 0;
  for (std::size_t i = 0; i < angle.size(); ++i)
    {
      const double p = (static_cast<double>(i) - 20) / 20;
      raise_to(places, std::abs(angle[i] - p * 360. / 27));
      const double carried =
        std::min({reference_lag(p - 1), reference_lag(p), reference_lag(p + 1)});
      raise_to(errors, std::abs(error[i] + carried));
    }
  check_below("transmission: angles [deg]", places, 1e-12);
  check_below("transmission: the gear lags [arcsec]", errors, .01);
}

void check_path(const Table &table, const nlohmann::json &path)
{
  const std::vector<std::string> &sides = table.column("side").texts;
  std::vector<std::size_t>        rows;
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (sides[i] == "drive")
      rows.push_back(i);
  const auto number = [&table](const std::string &name, const std::size_t row) {
    return table.numbers(name)[row];
  };
  check_close("path: from its start",
              number("pitches", rows.front()),
              value_of(path, "start"),
              1e-12);
  check_close("path: to its end", number("pitches", rows.back()), value_of(path, "end"), 1e-12);
  double lag = 0, cones = 0, axes = 0, places = 0;
  for (const std::size_t i : rows)
    {
      raise_to(lag, std::abs(number("lag", i) - reference_lag(number("pitches", i))));
      // Places in the blank and on the cone say the same: L along the pitch cone, h above it.
      for (const std::string member : {"pinion", "gear"})
        {
          const double tangent = member == "pinion" ? 27. / 79 : 79. / 27,
                       pitch   = std::atan(tangent);
          const double r       = std::hypot(number(member + " x", i), number(member + " y", i)),
                       z       = number(member + " z", i);
          cones                = largest_of(
            {cones,
                            std::abs(z * std::cos(pitch) + r * std::sin(pitch) - number(member + " L", i)),
                            std::abs(r * std::cos(pitch) - z * std::sin(pitch) - number(member + " h", i))});
          // Axes of the ellipse are tangents of the flank, whose height above the cone they leave
          // or keep: never longer than the semi-axis itself.
          for (const std::string axis : {"major", "minor"})
            {
              const double semi = number(axis == "major" ? "semi-axis a" : "semi-axis b", i);
              raise_to(axes,
                       std::hypot(number(member + " " + axis + " L", i),
                                  number(member + " " + axis + " h", i)) /
                         semi);
            }
        }
      raise_to(places,
               std::abs(
                 number("smaller relative curvature", i) * std::pow(number("semi-axis a", i), 2) -
                 number("larger relative curvature", i) * std::pow(number("semi-axis b", i), 2)) /
                 (number("smaller relative curvature", i) * std::pow(number("semi-axis a", i), 2)));
    }
  check_below("path: lag [arcsec]", lag, .02);
  check_below("path: places and cone coordinates [mm]", cones, 1e-9);
  check("path: axes in the flank", axes > .9 && axes < 1 + 1e-9);
  check_below("path: both semi-axes for one gap", places, 1e-12);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all("tca_results");
  std::ofstream("tca.prm") << "include " << tree_folder() << "/prm/paper_pair.prm\n"
                           << "subsection Study\n  set kind = tooth contact analysis\nend\n";
  run_pair("tca.prm", "tca_results", session.world());
  for (const char *file : {"tca.json", "tca.csv", "path.csv", "ease_off.csv", "pair.prm"})
    check(std::string(file) + " is written",
          std::filesystem::exists(std::string("tca_results/") + file));

  const nlohmann::json json  = read_json("tca_results/tca.json");
  const nlohmann::json drive = json.at("drive");
  // Reference: doc/verification/geometry.md. Its path is sampled in steps of 0.02 pitches and ends
  // inside the true one; its place of the hand-over is rounded to 5e-4 pitches, over which the lag
  // changes by 3.5e-3.
  check_close("contact ratio", value_of(drive.at("path"), "contact ratio"), 1.97, 0.01);
  check_close("transfer point [pitches]",
              value_of(drive.at("transfer point"), "place"),
              0.487,
              5e-4);
  check_close("lag at the transfer point [arcsec]",
              value_of(drive.at("transfer point"), "lag"),
              1.795,
              4e-3);
  check_close("semi-axis a [mm]",
              value_of(drive.at("ellipse at the mean contact"), "semi-axis a"),
              5.583,
              5e-4);
  check("the coast side is there", json.contains("coast"));
  check_figures(json);
  check_transmission(read_result_table("tca_results/transmission.csv"));
  check_path(read_result_table("tca_results/path.csv"), drive.at("path"));

  const std::string text = message_of([&] {
    run_pair(tree_folder() + "/prm/gear/printed_tables.prm", "tca_results", session.world());
  });
  check("printed cutter diameter: file and line", has_text(text, "printed_tables.prm:12 ("));
  check("printed root angle: file and line", has_text(text, "printed_tables.prm:53 ("));
  check("consequences follow the causes", has_text(text, "hence: "));
  return 0;
}
