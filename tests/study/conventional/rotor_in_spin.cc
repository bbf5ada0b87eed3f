// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Rotors in spin by the conventional solver: a rigid cylinder on two bearings against its closed
// form, through its critical speed and on soft mounts; residuals and the number of modes; what
// axes that turn cannot have is refused, or named.
#include "../../parts.h"
#include "../../read_files.h"
#include "../../refusal.h"
#include "../quick_pair.h"
#include "../short_rotor.h"

#include <vfife/base/types.h>
#include <vfife/element/material.h>

using namespace vfife;
using namespace rotor_text;

constexpr double diameter = 100, length = 60;

/** The cylinder of short_rotor.h, as stiff as a rigid one. */
std::string rigid_cylinder(const std::string &kind,
                           const std::string &bearings,
                           const std::string &body,
                           const std::string &rest)
{
  return study(kind) +
         "subsection Model\nset bodies = shaft\nset constraints = left, right, drive\n" +
         shaft(
           "0 60 100",
           "set elements around = 16\nset axial element size = 15\nset radial element size = 20\n"
           "set material = rigid\n" +
             body) +
         bearing("left", "z < 1", bearings + "set axial stiffness = 5000\n") +
         bearing("right", "z > 59", bearings) +
         model_text::section("Constraint drive",
                             "set kind = coupling\nset nodes = bottom\n"
                             "set torsional stiffness = 1e9\n") +
         rest + "end\nsubsection Material rigid\nset Young's modulus = 1e8 MPa\nend\n";
}

/** Does the case of a parameter file with this text; its modes. */
Columns find_modes(const std::string &name, const std::string &text, Communicator &world)
{
  std::ofstream(name + ".prm") << text;
  run_pair(name + ".prm", name, world);
  return read_columns(name + "/modes.csv");
}

std::string without_drive(std::string text)
{
  const std::string drive = ", drive", section = "subsection Constraint drive";
  text.replace(text.find(drive), drive.size(), "");
  const std::size_t from = text.find(section), to = text.find("end\n", from) + 4;
  return text.erase(from, to - from);
}

std::string fem(const unsigned int modes, const std::string &speeds)
{
  return "subsection Fem\nset modes = " + std::to_string(modes) +
         "\nset coriolis = yes\nset linear solver = direct\nset speeds = " + speeds + "\nend\n";
}

/** Rates [rad/s] of the cylinder in space on bearings of @p k [N/mm] at both ends, positive with
 * the spin: shifts, and tilts as of a top. */
std::vector<double> rigid_rates(const double k, const double spin)
{
  const double m    = Material().density * pi / 4 * diameter * diameter * length;
  const double Ip   = m * diameter * diameter / 8;
  const double It   = m * (diameter * diameter / 16 + length * length / 12);
  const double tilt = k * length * length / 2, half = .5 * Ip * spin / It;
  const double shift = std::sqrt(2 * k / m), root = std::sqrt(half * half + tilt / It);
  return {-shift, shift, half - root, half + root};
}

/** The four rigid whirls, on stiff and on soft mounts, far from critical speeds and next to
 * them; nothing else is slower than a tenth of the first elastic motion. */
void whirls(Communicator &world)
{
  for (const double k : {5000., 1000.})
    {
      const double              critical = rigid_rates(k, 0.)[1];
      const std::vector<double> parts    = {0., .5, .99, 1.003, 1.01, 2.};
      std::string               speeds;
      for (const double part : parts)
        speeds += (speeds.empty() ? "" : ", ") + std::to_string(part * critical) + " rad/s";
      const std::string name = k > 2000 ? "whirls" : "soft_whirls";
      const Columns     modes =
        find_modes(name,
                   without_drive(rigid_cylinder(
                     "modal", "set radial stiffness = " + std::to_string(k) + "\n", "", "")) +
                     fem(8, speeds),
                   world);
      double largest = 0, residual = 0;
      bool   same = true;
      for (const double part : parts)
        {
          const double        spin = part * critical;
          std::vector<double> found;
          unsigned int        n_rigid = 0;
          for (std::size_t i = 0; i < modes.at("speed").size(); ++i)
            if (std::abs(modes.at("speed")[i] * pi / 30 - spin) < 1e-4 * critical)
              {
                raise_to(residual, modes.at("residual")[i]);
                n_rigid += modes.at("frequency")[i] == 0;
                if (modes.at("nodal diameter")[i] == 1 &&
                    modes.at("fixed frequency")[i] < 10 * critical)
                  found.push_back(2 * pi * modes.at("fixed frequency")[i]);
              }
          std::vector<double> expected;
          for (const double value : rigid_rates(k, spin))
            expected.push_back(std::abs(value));
          std::sort(expected.begin(), expected.end());
          std::sort(found.begin(), found.end());
          // At rest the turn is listed too: nothing holds it.
          same = same && found.size() == 4 && n_rigid == (part == 0 ? 1 : 0);
          for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i)
            raise_to(largest, std::abs(found[i] - expected[i]) / critical);
        }
      check(name + ": four whirls at each speed, one motion that nothing holds", same);
      check_below(name + ": rates less those of the rigid rotor, over the critical speed",
                  largest,
                  2e-3);
      check_below(name + ": residuals", residual, 1e-4);

      // Straight branches in space, and the synchronous critical speed.
      const Table  branches = read_result_table(name + "/campbell.csv");
      double       bent     = 0;
      unsigned int n_points = 0;
      // At rest the tilt is the slower one of the two, and the first of the branch.
      for (std::size_t i = 0; i < branches.n_rows(); ++i)
        if (branches.numbers("speed")[i] > 0 && branches.numbers("nodal diameter")[i] == 1 &&
            branches.numbers("order")[i] == 1 && branches.column("direction").texts[i] == "forward")
          {
            ++n_points;
            raise_to(bent,
                     std::abs(2 * pi * branches.numbers("fixed frequency")[i] / critical - 1));
          }
      check(name + ": the branch of the forward whirl is there at each speed",
            n_points == parts.size() - 1);
      check_below(name + ": and is straight in space", bent, 2e-3);
      const Table  resonances = read_result_table(name + "/resonances.csv");
      double       met        = 0;
      unsigned int n_met      = 0;
      for (std::size_t i = 0; i < resonances.n_rows(); ++i)
        if (resonances.column("excitation").texts[i] == "unbalance")
          {
            ++n_met;
            met = resonances.numbers("speed")[i] * pi / 30;
          }
      // The tilt of this flat cylinder runs before any spin: Ip > It.
      check(name + ": one critical speed of unbalance", n_met == 1);
      check_ratio(name + ": it is that of the rigid rotor", met / critical, 1e-3);
    }
}

/** More modes are no worse: a disc on a thin shaft, in spin. */
void more_modes(Communicator &world)
{
  const auto found = [&world](const unsigned int n) {
    return find_modes(
      "modes_" + std::to_string(n),
      study("modal") + "subsection Model\nset bodies = shaft\nset constraints = left, right\n" +
        shaft("0 300 20, 180 200 120 20",
              "set elements around = 16\nset axial element size = 20\nset radial element size = "
              "20\n") +
        bearing("left", "z < 1", "set radial stiffness = 5000\nset axial stiffness = 5000\n") +
        bearing("right", "z > 299", "set radial stiffness = 5000\n") + "end\n" + fem(n, "9000 rpm"),
      world);
  };
  const Columns few = found(6), many = found(40);
  double        residual = 0, apart = 0;
  for (const Columns *modes : {&few, &many})
    for (const double value : modes->at("residual"))
      raise_to(residual, value);
  for (std::size_t i = 0; i < few.at("frequency").size(); ++i)
    raise_to(apart, std::abs(many.at("frequency")[i] / few.at("frequency")[i] - 1));
  check_below("6 and 40 modes: residuals", residual, 1e-4);
  check_below("6 and 40 modes: frequencies of the first five apart", apart, 1e-6);
}

std::string unequal()
{
  return "set x direction = 1, 0, 0\nset stiffness matrix = 1000 0 0 0 0, 0 4000 0 0 0, "
         "0 0 5000 0 0, 0 0 0 0 0, 0 0 0 0 0\n";
}

/** The cylinder on bearings of 1000 and 4000 N/mm, 100 N along x and y in its middle. */
std::string pushed(const std::string &kind, const std::string &direction)
{
  std::string text = rigid_cylinder(
    kind,
    unequal(),
    "set rotational speed = 3000 rpm\n",
    "set loads = push\nset probes = middle\n" + model_text::probe("middle", "0, 0, 30 mm") +
      model_text::section("Load push",
                          "set kind = force\nset nodes = all\nset force = " + direction + "\n"));
  const std::string axial = "set axial stiffness = 5000\n";
  return text.replace(text.find(axial), axial.size(), "");
}

void standing_load(Communicator &world)
{
  const std::string at_rest = "subsection Linear static\nset centrifugal = no\nend\n";
  const Columns     found =
    run_text("standing_load", pushed("linear static", "100, 100, 0 N") + at_rest, world);
  check_close("standing load: way along x [um]",
              1e3 * found.at("middle displacement x").back(),
              50.,
              .1);
  check_close("standing load: way along y [um]",
              1e3 * found.at("middle displacement y").back(),
              12.5,
              .05);
  for (const char *axis : {"x", "y"})
    check_close(std::string("standing load: both bearings, along ") + axis + " [N]",
                found.at(std::string("left reaction force ") + axis).back() +
                  found.at(std::string("right reaction force ") + axis).back(),
                -100.,
                1e-4);
  // In axes that turn it would turn along.
  for (const char *kind : {"linear static", "static"})
    check(std::string(kind) + ": a load across the axis in spin is refused",
          message_of([&] {
            run_text("refused_load", pushed(kind, "100, 0, 0 N"), world);
          }).find("\"push\" across the axis") != std::string::npos);
  // Along the axis it is the same at all turns.
  const Columns along = run_text("axial_load", pushed("linear static", "0, 0, 100 N"), world);
  check_close("load along the axis: way [um]",
              1e3 * along.at("middle displacement z").back(),
              10.,
              .1);
}

std::string warnings_of(const std::string &folder)
{
  std::string          all;
  const nlohmann::json summary = read_json(folder + "/summary.json");
  // The rigid material is none of a solid, which is said too.
  for (const nlohmann::json &warning : summary.at("warnings"))
    if (const auto text = warning.get<std::string>(); !has_text(text, "Young's modulus"))
      all += text + "\n";
  return all;
}

/** Means over the turns and dampers that are left out are named, with their numbers. */
void named(Communicator &world)
{
  const std::string file =
    rigid_cylinder("modal", "set radial stiffness = 2500\nset radial damping = 10\n", "", "");
  const Columns damped = find_modes("damped", file + fem(8, "0, 3000 rpm"), world);
  const auto   &ratios = damped.at("damping ratio");
  check("dampers: ratios are not known",
        std::all_of(ratios.begin(), ratios.end(), [](const double r) { return std::isnan(r); }));
  check("dampers: named", has_text(warnings_of("damped"), "left, right"));
  std::string       mean  = rigid_cylinder("modal", unequal(), "", "");
  const std::string axial = "set axial stiffness = 5000\n";
  mean.replace(mean.find(axial), axial.size(), "");
  const Columns modes = find_modes("mean", mean + fem(8, "0, 3000 rpm"), world);
  const auto    text  = warnings_of("mean");
  for (const char *part : {"\"left\"", "\"right\"", "1000 and 4000 N/mm", "mean 2500 N/mm"})
    check(std::string("unequal bearings: the warning says ") + part, has_text(text, part));
  const double        m = Material().density * pi / 4 * diameter * diameter * length;
  std::vector<double> at_rest, in_spin;
  for (std::size_t i = 0; i < modes.at("speed").size(); ++i)
    (modes.at("speed")[i] == 0 ? at_rest : in_spin)
      .push_back(2 * pi * modes.at("fixed frequency")[i]);
  const auto has = [](const std::vector<double> &list, const double rate) {
    return std::any_of(list.begin(), list.end(), [rate](const double value) {
      return std::abs(value / rate - 1) < 1e-3;
    });
  };
  check("unequal bearings at rest: both rates",
        has(at_rest, std::sqrt(2000 / m)) && has(at_rest, std::sqrt(8000 / m)));
  check("unequal bearings in spin: that of the mean", has(in_spin, std::sqrt(5000 / m)));
  // Nothing to be named.
  find_modes("alike",
             rigid_cylinder("modal", "set radial stiffness = 2500\n", "", "") +
               fem(8, "0, 3000 rpm"),
             world);
  check("equal bearings without dampers: no warning", warnings_of("alike").empty());
}

int main(int argc, char **argv)
{
  run_parts<Communicator>(argc, argv, {&whirls, &more_modes, &standing_load, &named});
  return 0;
}
