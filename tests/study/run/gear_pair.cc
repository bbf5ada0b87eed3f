// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// From a parameter file to results: one mesh cycle of a coarse pair with a conical web.
#include "../../model_sections.h"
#include "../../read_files.h"
#include "../quick_pair.h"

#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/base/types.h>
#include <vfife/gear/unloaded_contact/unloaded_contact.h>
#include <vfife/study/cases/gear/gear_case.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>

using namespace vfife;

/** The driver's turn is prescribed, and both angles make up the transmission error. */
void angles(Columns &columns)
{
  const auto &time = columns["time"], &pinion = columns["pinion angle"],
             &gear = columns["gear angle"], &dte = columns["dte"];
  check("samples of one mesh cycle", time.size() == 99);
  check_close("one mesh cycle at 20,000 rpm [s]", time.back(), 60. / 20000 / 27, 1e-15);
  check_close("driver's angle after it [deg]", pinion.back() - pinion.front(), 360. / 27, 1e-9);
  double wrong = 0;
  for (std::size_t i = 0; i < time.size(); ++i)
    raise_to(wrong, std::abs(3600 * (gear[i] - 27. / 79 * pinion[i]) - dte[i]));
  // Round-off of 5 degrees in arcsec.
  check_below("gear angle less 27/79 of the pinion's, and dte [arcsec]", wrong, 1e-10);
}

/** Torque over force of all tooth pairs: the levers of their normals where they touch, by tooth
 * contact analysis, weighted with their forces. */
void levers(Columns &columns)
{
  const ParameterFile      file("gear_pair.prm");
  GearCase                 gear_case;
  dealii::ParameterHandler prm;
  gear_case.declare(prm, file);
  file.read_known(prm);
  const UnloadedContact         tca(gear_case.make_pair());
  auto                          teeth = read_columns("gear_pair_results/teeth.csv");
  std::map<double, std::size_t> sample;
  for (std::size_t i = 0; i < columns["time"].size(); ++i)
    sample[columns["time"][i]] = i;
  std::vector<double> force(sample.size(), 0.), torque(force), moment(force), pairs(force);
  for (std::size_t i = 0; i < teeth["time"].size(); ++i)
    {
      // Tooth k follows k pitches later.
      const int                  tooth = std::lround(teeth["pinion tooth"][i]);
      const int                  k     = tooth > 13 ? tooth - 27 : tooth;
      const double               rot1  = tca.reference() + teeth["time"][i] * 20000 * pi / 30;
      const UnloadedContactPoint point = tca.contact(rot1, k);
      const std::size_t          at    = sample.at(teeth["time"][i]);
      pairs[at] += 1;
      force[at] += teeth["force"][i];
      torque[at] += teeth["torque"][i];
      moment[at] += 1e-3 * teeth["force"][i] * std::abs(point.position.cross(point.normal)[2]);
    }
  double unlike = 0, off = 0;
  for (std::size_t i = 0; i < force.size(); ++i)
    {
      unlike = largest_of({unlike,
                           std::abs(force[i] / columns["contact force total"][i] - 1),
                           std::abs(torque[i] / columns["contact torque on the gear"][i] - 1)});
      raise_to(off, std::abs(moment[i] / torque[i] - 1));
    }
  check("teeth in contact are those with a force", pairs == columns["teeth in contact"]);
  check_below("forces and torques of the teeth add up to those of the pair", unlike, 1e-9);
  // Under load a tooth pair bears on some mm of its flanks about the point where it would touch
  // without, more at its ends than in its middle: 1.0 % is found.
  check_below("torque over force times lever of the tooth contact analysis", off, 0.02);
}

double value_of(const nlohmann::json &summary, const char *section, const char *name)
{
  return summary.at(section).at(name).at("value").get<double>();
}

/** The start beside what its own numbers and finite elements say. */
void start(const nlohmann::json &summary, Columns &columns, Communicator &world)
{
  const auto part = [&](const char *name) { return value_of(summary, "transmission error", name); };
  const double total = part("total at the start");
  check_close("parts of the transmission error add up [arcsec]",
              part("teeth and rest") + part("web windup") + part("rim tilt and shift") +
                part("rim bending") + part("centrifugal shift"),
              total,
              1e-9);
  // 2 E/T; the deformation that stands still in space changes the springs' energy by 1e-4. What
  // implicit contact holds at an instant has a part of the motion, eps dt^2/4 g'^2/2 (0.2 %).
  std::filesystem::remove_all("gear_pair_explicit");
  run_pair("gear_pair.prm",
           "gear_pair_explicit",
           world,
           {"Contact/integration=explicit", "Dynamics/maximum number of steps=1"});
  check_ratio("lag of the penalty springs [arcsec]",
              part("penalty compliance, in teeth and rest") /
                (-2 * read_columns("gear_pair_explicit/history.csv")["contact energy"].front() /
                 800e3 / arcsecond),
              1e-3);
  const double stiffness = value_of(summary, "figures", "torsional stiffness"),
               inertia   = value_of(summary, "figures", "inertia of the torsional mode");
  check_ratio("swing frequency over sqrt(k/J)/(2 pi)",
              value_of(summary, "figures", "torsional mode frequency, estimated") * 2 * pi /
                std::sqrt(stiffness / inertia),
              1e-12);
  // Teeth and web bend in the swing as well: it has more than the gear's inertia, some per cent.
  const double own =
    summary.at("mesh").at("bodies").at(1).at("axial inertia").at("value").get<double>();
  check("inertia of the swing: the gear's and some per cent",
        inertia > own && inertia < 1.15 * own);

  std::filesystem::remove_all("gear_pair_loaded");
  std::ofstream("gear_pair_loaded.prm") << "include gear_pair.prm\n"
                                        << model_text::loaded_contact(1);
  run_pair("gear_pair_loaded.prm", "gear_pair_loaded", world);
  auto       loaded = read_columns("gear_pair_loaded/loaded_contact.csv");
  const auto linear = [&](const char *name) { return loaded.at(name).front(); };
  // What is of second order: the membrane forces of the web that the load tilts by 1e-3.
  check_ratio("lag over that of finite elements", total / linear("transmission error"), 2e-3);
  check_ratio("contact force over theirs",
              columns["contact force total"].front() / linear("contact force total"),
              1e-3);
  // A secant over the last tenth of the torque and the tangent at its end.
  check_ratio("torsional stiffness over their tangent",
              stiffness / linear("tangent stiffness"),
              5e-3);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all("gear_pair_results");
  std::ofstream("gear_pair.prm") << quick_pair(
    "set body type = conical web\nset web thickness = 5 mm\nset web inclination = 70 deg",
    coarse_web,
    "1e-5");
  run_pair("gear_pair.prm", "gear_pair_results", session.world());

  for (const char *file : {"parameters.prm", "run.log", "history.csv", "teeth.csv", "summary.json"})
    check(std::string(file) + " is written",
          std::filesystem::exists(std::string("gear_pair_results/") + file));
  const nlohmann::json summary = read_json("gear_pair_results/summary.json");
  check("the run is complete", summary.at("status") == "finished");

  auto columns = read_columns("gear_pair_results/history.csv");
  angles(columns);
  levers(columns);
  // The start is the equilibrium to 1e-5 of all forces, the centrifugal ones included, some 10^2 of
  // the contact's.
  const auto &torque = columns["contact torque on the gear"];
  check_close("contact torque at the start [N m]", torque.front(), 800., 1.);
  check_close("torque over effective arm [N]",
              value_of(summary, "figures", "torque over effective lever arm") *
                value_of(summary, "figures", "effective lever arm"),
              800e3,
              1e-6);
  start(summary, columns, session.world());
  // What the mean torque lacks slows the gear down: test gear_pair_ramp has the balance. A run that
  // begins in equilibrium stays near it.
  const double mean_torque = std::accumulate(torque.begin(), torque.end(), 0.) / torque.size();
  check_ratio("mean contact torque over the load", mean_torque / 800., 0.1);
  return 0;
}
