// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Loaded tooth contact analysis of a coarse pair by finite elements: its tables against each other,
// its stiffnesses against what the torque does.
#include "../../model_sections.h"
#include "../../read_files.h"
#include "../../vtu_file.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <filesystem>

using namespace vfife;

/** The analysis of that pair under a torque [N m]. */
void analyse(const std::string &folder, const double torque, Communicator &world)
{
  std::filesystem::remove_all(folder);
  std::string all = quick_pair("set body type = rim only", "set elements through rim = 2", "1e-5");
  const std::string given = "torque       = 800";
  all.replace(all.find(given), given.size(), "torque = " + std::to_string(torque));
  std::ofstream("loaded_contact.prm")
    << all << model_text::loaded_contact(2)
    << "subsection Output\n set field output interval = 0.5\nend\n";
  run_pair("loaded_contact.prm", folder, world);
}

/** Tooth pairs of a position carry together what the table of positions says. */
void check_teeth()
{
  auto        positions = read_columns("loaded_contact_results/loaded_contact.csv");
  const Table teeth     = read_result_table("loaded_contact_results/loaded_teeth.csv");
  for (std::size_t i = 0; i < positions["position"].size(); ++i)
    {
      double       torque = 0, force = 0, share = 0, pressure = 0, shares_apart = 0;
      unsigned int n = 0;
      for (std::size_t row = 0; row < teeth.n_rows(); ++row)
        if (teeth.numbers("position")[row] == positions["position"][i])
          {
            const double own = teeth.numbers("torque")[row];
            torque += own;
            force += teeth.numbers("force")[row];
            share += teeth.numbers("share of torque")[row];
            raise_to(shares_apart, std::abs(teeth.numbers("share of torque")[row] - own / 800));
            raise_to(pressure, teeth.numbers("largest pressure")[row]);
            ++n;
            // Single points carry on this mesh; fading edges push a little aside.
            check("teeth: the mean pressure is at most the largest",
                  teeth.numbers("force")[row] / teeth.numbers("area")[row] <
                    1.001 * teeth.numbers("largest pressure")[row]);
            // The torque's arm is that of the normal: 89.8 mm at the mean contact, and not far
            // from it on the rest of the flank.
            check_close("teeth: arm [mm]", 1e3 * own / teeth.numbers("force")[row], 89.8, 5.);
          }
      check("teeth: as many as in contact", n == positions["teeth in contact"][i] && n >= 1);
      check_close("teeth: torques [N m]", torque, 800., 1e-6);
      check_ratio("teeth: forces over their sum",
                  force / positions["contact force total"][i],
                  1e-12);
      check_ratio("teeth: shares", share, 1e-12);
      check_below("teeth: share is torque over torque", shares_apart, 1e-8);
      check_close("teeth: largest pressure [MPa]",
                  pressure,
                  positions["largest pressure"][i],
                  1e-12 * pressure);
    }
  // A half pitch of the pinion, from its position at the reference on.
  check("positions: halves of a mesh cycle",
        positions["position"][0] == 0 && positions["position"][1] == .5);
  check_close("positions: turn of the pinion [deg]",
              positions["pinion angle"][1] - positions["pinion angle"][0],
              360. / 27 / 2,
              1e-9);
}

/** The pattern over the positions, and its centre: where flanks touch is as far from the common
 * apex on one member as on the other. */
void check_pattern()
{
  const Table  pattern = read_result_table("loaded_contact_results/pattern.csv");
  const auto  &sides   = pattern.column("side").texts;
  unsigned int drive = 0, coast = 0;
  double       least = 1e9, most = 0;
  for (std::size_t i = 0; i < pattern.n_rows(); ++i)
    if (pattern.numbers("largest pressure")[i] > 0)
      {
        ++(sides[i] == "drive" ? drive : coast);
        const double distance = std::hypot(pattern.numbers("r")[i], pattern.numbers("z")[i]);
        least                 = std::min(least, distance);
        most                  = std::max(most, distance);
      }
  check("pattern: on the drive side alone", drive > 4 && coast == 0);
  const auto                    figures  = read_json("loaded_contact_results/figures.json");
  const auto                    geometry = read_json("loaded_contact_results/geometry.json");
  std::map<std::string, double> from_apex;
  for (const std::string member : {"pinion", "gear"})
    from_apex[member] =
      std::hypot(geometry.at(member).at("mean cone distance").at("value").get<double>() +
                   figures.at("pattern along the face, " + member).at("value").get<double>(),
                 figures.at("pattern along the profile, " + member).at("value").get<double>());
  // Of single nodes of 14 mm, over which facets spread what they carry.
  check_close("pattern: distance of its centre from the apex, both members [mm]",
              from_apex["pinion"],
              from_apex["gear"],
              1.);
  check("pattern: its centre lies in it",
        from_apex["gear"] > least + 2 && from_apex["gear"] < most - 2);
}

/** Fields of both positions: where the analysis has the largest stress of a part, the file has
 * it, and the pressures of the gear's flanks turn it as the torque asks for. */
void check_fields()
{
  const auto figures = read_json("loaded_contact_results/figures.json");
  const auto figure  = [&](const std::string &name) {
    return figures.at(name).at("value").get<double>();
  };
  std::vector<VtuFile> fields;
  for (const char *name : {"00000.vtu", "00001.vtu"})
    fields.emplace_back(std::string("loaded_contact_results/fields/") + name);
  check("fields: at both positions, no more",
        !std::filesystem::exists("loaded_contact_results/fields/00002.vtu"));
  const std::string part   = "gear rim, largest von Mises stress";
  const double      stress = figure(part), radius = figure(part + ", at radius"),
               height = figure(part + ", at height");
  double nearest = 1e9, largest_displacement = 0;
  for (const VtuFile &field : fields)
    for (std::size_t i = 0; i < field.n_points(); ++i)
      {
        // The gear's axis is z; without its displacement a point is as far from it as at first.
        const Vector3 u = field.vector("displacement", i), X = field.point(i) - u;
        largest_displacement = std::max(largest_displacement, u.norm());
        if (std::abs(std::hypot(X[0], X[1]) - radius) < 1e-3)
          nearest = std::min(nearest, std::abs(field.number("von mises", i) - stress));
      }
  check_below("fields: largest stress of the rim [MPa]", nearest, 1e-5 * stress);
  check("fields: displacements are those of a deformation",
        largest_displacement > .01 && largest_displacement < .3);
  check("fields: at the heights of the body", std::isfinite(height));
}

/** Secant: torque over windup. Tangent: what the lag does as the torque changes. */
void check_stiffness(Communicator &world)
{
  analyse("loaded_contact_less", 796, world);
  analyse("loaded_contact_more", 804, world);
  auto here            = read_columns("loaded_contact_results/loaded_contact.csv"),
       less            = read_columns("loaded_contact_less/loaded_contact.csv"),
       more            = read_columns("loaded_contact_more/loaded_contact.csv");
  const char *unloaded = "unloaded transmission error", *loaded = "transmission error";
  for (std::size_t i = 0; i < 2; ++i)
    {
      check_ratio("secant stiffness over torque/windup",
                  here["secant stiffness"][i] * (here[unloaded][i] - here[loaded][i]) * arcsecond /
                    800,
                  1e-8);
      // Between both no further point touches, or some: stiffness changes by some parts in a
      // thousand of 8/800.
      check_ratio("tangent stiffness over torque/lag",
                  here["tangent stiffness"][i] * (less[loaded][i] - more[loaded][i]) * arcsecond /
                    8,
                  2e-3);
      check_close("without load the torque is nothing to it",
                  here[unloaded][i],
                  more[unloaded][i],
                  1e-9 * std::abs(here[unloaded][i]));
    }
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  analyse("loaded_contact_results", 800, session.world());

  check("loaded_teeth.csv is written",
        std::filesystem::exists("loaded_contact_results/loaded_teeth.csv"));
  auto columns = read_columns("loaded_contact_results/loaded_contact.csv");
  check("two positions", columns["position"].size() == 2);
  for (std::size_t i = 0; i < columns["position"].size(); ++i)
    {
      // Newton's method stops at 1e-9 of the torque.
      check_close("contact torque [N m]", columns["contact torque on the gear"][i], 800., 1e-6);
      check("the gear lags the more under load",
            columns["transmission error"][i] < columns["unloaded transmission error"][i]);
      // Further teeth and points come into contact as the load grows.
      check("the tangent is stiffer than the secant",
            columns["tangent stiffness"][i] > columns["secant stiffness"][i]);
    }
  check_teeth();
  check_pattern();
  check_fields();
  check_stiffness(session.world());
  return 0;
}
