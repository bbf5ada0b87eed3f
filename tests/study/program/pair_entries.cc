// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Entries of a pair that files hardly ever set (material, export, spin of a loaded contact), and
// the numbers that a run writes of itself, on meshes as coarse as they go.
#include "../../model_sections.h"
#include "../../parts.h"
#include "../../read_files.h"
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/types.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/study/cases/gear/gear_case.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>

using namespace vfife;

/** The pair without what only runs have. */
std::string bodies()
{
  const std::string text =
    quick_pair("set body type = rim only", "set elements through rim = 2", "1e-6");
  return text.substr(0, text.find("subsection Operation"));
}

void run(const std::string &name, const std::string &text, Communicator &world)
{
  std::filesystem::remove_all(name);
  std::ofstream(name + ".prm") << text;
  run_pair(name + ".prm", name, world);
}

void meshes(Communicator &world)
{
  run("pair_mesh",
      bodies() + R"(
subsection Study
  set kind = mesh
end
subsection Gear pair
  subsection Gear
    set material = brass
  end
end
subsection Material brass
  set density = 8500 kg/m^3
end
subsection Export
  set formats = vtu
  set bodies  = no
end
)",
      world);
  check("export bodies: only the pair",
        std::filesystem::exists("pair_mesh/pair.vtu") &&
          !std::filesystem::exists("pair_mesh/gear.vtu") &&
          !std::filesystem::exists("pair_mesh/pinion.vtu"));
  const Table table = read_result_table("pair_mesh/mesh.csv");
  for (const unsigned int i : {0u, 1u})
    check_close("material: density of the " + table.column("body").texts[i] + " [kg/m^3]",
                table.numbers("mass")[i] / table.numbers("volume")[i] * 1e9,
                i == 0 ? 7850. : 8500.,
                1e-6);
}

/** A gear of two materials: its masses, and what refuses several materials. */
void region_materials(Communicator &world)
{
  const auto text = [](const std::string &pairs, const std::string &format) {
    const std::string alloy = pairs.find("alloy") == std::string::npos
                                ? ""
                                : "subsection Material alloy\n  set density = 2700 kg/m^3\nend\n";
    return coarse_pair("set body type = conical web", coarse_web) + alloy +
           "subsection Study\n  set kind = mesh\nend\n"
           "subsection Gear pair\n  subsection Gear\n    set region materials = " +
           pairs + "\n  end\nend\nsubsection Export\n  set formats = " + format + "\nend\n";
  };
  const auto read = [&](const std::string &pairs) {
    run("pair_regions", text(pairs, "vtu"), world);
    const Table  table = read_result_table("pair_regions/mesh.csv");
    const double mass = table.numbers("mass")[1], centre = table.numbers("centre of mass z")[1];
    // About the apex, where inertias of parts add up.
    return Eigen::Array4d(mass,
                          table.numbers("polar inertia")[1],
                          mass * centre,
                          table.numbers("transverse inertia")[1] + mass * centre * centre);
  };
  const Eigen::Array4d steel = read("web: steel");
  Eigen::Array4d       sum   = Eigen::Array4d::Zero();
  for (const char *others : {"rim: steel, web: steel, hub: steel\n    set material = alloy",
                             "rim: alloy",
                             "web: alloy",
                             "hub: alloy"})
    sum += (steel - read(others)) / (1 - 2700. / 7850.);
  check("region materials: mass and inertias of all regions are those of the gear",
        (sum / steel - 1.).abs().maxCoeff() < 1e-9);
  check("the true body has no known mass",
        std::isnan(read_result_table("pair_regions/mesh.csv").numbers("true mass")[1]));
  for (const auto &[pairs, format] : {std::pair("web: alloy", "inp"),
                                      std::pair("teeth: alloy", "vtu"),
                                      std::pair("wep: alloy", "vtu"),
                                      std::pair("shaft: alloy", "vtu")})
    print_refusal(
      [&, pairs = pairs, format = format] { run("pair_refused", text(pairs, format), world); });
}

/** The pair with these entries and its model. */
template <typename Action>
void with_model(const std::string &entries, const Action &action)
{
  std::ofstream("pair_model.prm") << bodies() << entries;
  const ParameterFile      file("pair_model.prm");
  GearCase                 gear_case;
  dealii::ParameterHandler prm;
  gear_case.declare(prm, file);
  file.read_known(prm);
  gear_case.check_bodies();
  std::ostringstream nothing;
  Log                log(nothing, true, Verbosity::quiet);
  action(gear_case, gear_case.make_model(log), log);
}

/** Penalty of both sides of the pair with these entries [N/mm^3], as given to a run. */
double penalty_with(const std::string &entries)
{
  double value = 0.;
  with_model(entries, [&](const GearCase &, const Model &model, Log &) {
    value = model.contacts.front().options.penalty.value;
    check("both sides of the teeth have the same springs, of no step",
          model.contacts.size() == 2 && model.contacts.back().options.penalty.value == value);
  });
  return value;
}

/** Over one mesh cycle, 0.111 ms. */
void torques(Communicator &)
{
  for (const auto &[torque, negative] :
       {std::pair("800*(1 - 8e3*t)", false), std::pair("800*(1 - 1e4*t)", true)})
    with_model(
      std::string("subsection Operation\n set speed = 20000 rpm\n set mesh cycles = 1\n") +
        " set torque = " + torque + "\nend\n",
      [negative = negative](const GearCase &gear_case, const Model &model, Log &log) {
        const DynamicsOptions          dynamics;
        const std::vector<std::string> found = gear_case.report_checks({&model, &dynamics}, log);
        check("a torque that becomes negative is named",
              negative == std::any_of(found.begin(), found.end(), [](const auto &text) {
                return text.find("the torque becomes negative") != std::string::npos;
              }));
      });
}

void penalties(Communicator &)
{
  // Axes that cross at right angles: the gear's pitch angle has the tangent 79/27. Module at the
  // heel, where the cone distance is 131.4913 mm.
  const double module   = 2 * 131.4913 * std::sin(std::atan2(79., 27.)) / 79;
  const auto   softness = [](const double E, const double nu) { return (1 - nu * nu) / E; };
  const double steel    = softness(206000, .29);
  // With which the contact's own grid is found.
  const std::string open_penalty = "subsection Contact\n  set penalty = auto\nend\n";
  check_ratio("penalty of steel on steel over 30 E*/m",
              penalty_with(open_penalty) * module * 2 * steel / 30,
              1e-6);
  check_ratio("penalty of steel on brass over 30 E*/m",
              penalty_with(open_penalty +
                           "subsection Gear pair\n  subsection Gear\n    set material = brass\n"
                           "  end\nend\nsubsection Material brass\n"
                           "  set Young's modulus = 100000 MPa\n  set Poisson's ratio = 0.34\n"
                           "end\n") *
                module * (steel + softness(100000, .34)) / 30,
              1e-6);
  check_close("penalty that is given [N/mm^3]",
              penalty_with("subsection Contact\n  set penalty = 5e5\nend\n"),
              5e5,
              0.);
}

/** Transmission errors without and with load at the reference position [arcsec]. */
std::array<double, 2>
loaded_contact(const std::string &speed, const std::string &centrifugal, Communicator &world)
{
  run("pair_loaded",
      bodies() + "subsection Operation\n  set torque = 800 N m\n  set speed = " + speed +
        "\nend\n" + model_text::loaded_contact(1, "set centrifugal = " + centrifugal + "\n") +
        "subsection Contact\n  set penalty = 6e5\nend\n",
      world);
  auto columns = read_columns("pair_loaded/loaded_contact.csv");
  return {{columns["unloaded transmission error"][0], columns["transmission error"][0]}};
}

void spin(Communicator &world)
{
  const auto at_rest = loaded_contact("10 rpm", "yes", world),
             without = loaded_contact("20000 rpm", "no", world),
             spun    = loaded_contact("20000 rpm", "yes", world);
  check_close("centrifugal: without it speed is none [arcsec]", without[1], at_rest[1], 1e-4);
  check_below("centrifugal: flanks touch unspun without load [arcsec]", without[0], .05);
  check("centrifugal: spin moves the flanks", std::abs(spun[0] - without[0]) > .1);
}

/** What summary.json says of a run, from the files beside it. */
void figures(Communicator &world)
{
  const std::string web = "set body type = conical web\nset web thickness = 5 mm";
  const std::string mesh =
    "set elements through rim = 3\nset elements through web = 1\nset elements along web = "
    "3\nset elements through hub = 1\nset hub side "
    "cells = 1";
  // Explicit: the contact's energy at the start is that of its springs.
  run("pair_figures",
      quick_pair(web, mesh, "1e-6") + "subsection Contact\n  set integration = explicit\nend\n",
      world);
  const nlohmann::json summary = read_json("pair_figures/summary.json");
  auto                 history = read_columns("pair_figures/history.csv");
  const auto           value   = [&](const char *part, const std::string &name) {
    return summary.at(part).at(name).at("value").get<double>();
  };

  const char *const error = "transmission error";
  check_ratio("parts of the transmission error over its total",
              (value(error, "teeth and rest") + value(error, "web windup") +
               value(error, "rim tilt and shift") + value(error, "rim bending") +
               value(error, "centrifugal shift")) /
                value(error, "total at the start"),
              1e-12);
  // The total is that of the equilibrium before the pattern that stands in space is put in.
  check_ratio("the total over the first sample",
              value(error, "total at the start") / history["dte"].front(),
              .01);
  check("the teeth and the web give way, penalty springs are a part",
        value(error, "teeth and rest") < value(error, "penalty compliance, in teeth and rest") &&
          value(error, "penalty compliance, in teeth and rest") < 0. &&
          value(error, "web windup") < 0.);
  // Springs give way by 2 E/T: the contact's energy at the start over the torque.
  check_close("penalty springs: twice their energy over the torque [arcsec]",
              -2 * history["contact energy"].front() / 8e5 / arcsecond,
              value(error, "penalty compliance, in teeth and rest"),
              1e-3);

  const char *const figure = "figures";
  check_close("mesh frequency [Hz]", value(figure, "mesh frequency"), 9000., 1e-9);
  check_close("pinion speed [rpm]", value(figure, "pinion speed"), 20000., 1e-9);
  check_close("gear torque [N m]", value(figure, "gear torque"), 800., 1e-12);
  check_ratio("torque over effective lever arm",
              value(figure, "torque over effective lever arm") *
                value(figure, "effective lever arm") / 8e5,
              1e-12);
  // In N m/rad and kg m^2.
  check_ratio("swing frequency over that of stiffness and inertia",
              value(figure, "torsional mode frequency, estimated") * 2 * pi /
                std::sqrt(value(figure, "torsional stiffness") /
                          value(figure, "inertia of the torsional mode")),
              1e-12);
  const double gear = summary.at("mesh").at("bodies")[1].at("axial inertia").at("value");
  check("inertia of the swing: about the gear's",
        value(figure, "inertia of the torsional mode") > .5 * gear &&
          value(figure, "inertia of the torsional mode") < 1.5 * gear);
  check("penalty of the contact", value(figure, "contact penalty") > 0);
  check_close("samples on the coast side",
              value(figure, "samples with contact on the coast side"),
              0.,
              0.);

  // One mesh cycle has no steady part: the figures are of the samples between start
  // and end.
  const nlohmann::json &steady = summary.at("steady part");
  check("no steady part", steady.at("found") == false);
  const auto inside = [&](const double time) {
    return time >= steady.at("start").at("value").get<double>() - 1e-12 &&
           time <= steady.at("end").at("value").get<double>() + 1e-12;
  };
  for (const char *column : {"contact force total", "dte", "contact torque on the gear"})
    {
      std::vector<double>       values, times, integral;
      const std::vector<double> impulse = history[std::string("impulse of ") + column];
      for (std::size_t i = 0; i < history["time"].size(); ++i)
        if (inside(history["time"][i]))
          {
            values.push_back(history[column][i]);
            times.push_back(history["time"][i]);
            if (!impulse.empty())
              integral.push_back(impulse[i]);
          }
      const auto ends = std::minmax_element(values.begin(), values.end());
      double     mean = 0; // by the trapezoidal rule over whole mesh cycles
      for (std::size_t i = 1; i < values.size(); ++i)
        mean += .5 * (values[i - 1] + values[i]) / (values.size() - 1);
      // Forces of the contact by all steps, which 98 samples miss by some parts in a thousand.
      const double time = times.back() - times.front();
      if (!integral.empty())
        {
          check_below(std::string(column) + ": mean of the samples over that of all steps",
                      std::abs(mean * time / (integral.back() - integral.front()) - 1),
                      5e-3);
          mean = (integral.back() - integral.front()) / time;
        }
      const auto &of = steady.at("columns").at(column);
      check(std::string(column) + ": samples of a mesh cycle", values.size() == 99);
      check_ratio(std::string(column) + ": mean", of.at("mean").get<double>() / mean, 1e-10);
      check_ratio(std::string(column) + ": peak to peak",
                  of.at("peak to peak").get<double>() / (*ends.second - *ends.first),
                  1e-12);
    }

  // A row of teeth.csv for each pair of teeth that touches.
  auto                       teeth = read_columns("pair_figures/teeth.csv");
  const std::vector<double> &times = teeth["time"], &pressures = teeth["largest pressure"];
  bool                       same = true;
  for (std::size_t i = 0; i < history["time"].size(); ++i)
    same = same && std::count(times.begin(), times.end(), history["time"][i]) ==
                     std::lround(history["teeth in contact"][i]);
  check("teeth in contact: rows of teeth.csv", same);
  // Teeth that come into mesh beside one that carries: each has a pressure of its own.
  bool own = true, beside = false;
  for (std::size_t i = 1; i < times.size(); ++i)
    if (times[i] == times[i - 1])
      {
        own    = own && pressures[i] != pressures[i - 1];
        beside = true;
      }
  check("teeth beside each other: pressures of their own", own && beside);
  // The ledger's last state beside the last sample, which is the last step.
  check_ratio("energy: strain [mJ]",
              value("energy", "strain") / history["strain energy"].back(),
              1e-12);
  check_close("energy: error", value("energy", "error"), history["energy error"].back(), 1e-15);
  check_ratio("run: its time in mesh cycles", value("run", "time") * 9000, 1e-9);
  check_ratio("run: steps times step over time",
              value("run", "step") * summary.at("run").at("steps").get<double>() /
                value("run", "time"),
              1e-12);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {meshes, region_materials, penalties, torques, spin, figures});
}
