// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Shafts in bearings against closed forms: a beam on two springs, equilibria of a short rotor, and
// the rotors of the textbook; what is refused.
#include "../../parts.h"
#include "../../refusal.h"
#include "../quick_pair.h"
#include "../short_rotor.h"

#include <vfife/base/types.h>
#include <vfife/mesh/primitives/stepped_shaft.h>
#include <vfife/model/body.h>

using namespace vfife;
using namespace rotor_text;

/** Steps at places whose differences are not exact: the mass is that of the cylinders. */
void steps()
{
  SteppedShaftOptions options;
  options.text             = "0 0.3 10, 0.3 0.9 8, 0.9 4.1 6, 4.1 5.7 20 4, 5.7 6.3 12 4";
  options.around           = 16;
  options.axial_cell_size  = 10;
  options.radial_cell_size = 2;
  double volume            = 0;
  for (const ShaftSection &section : options.sections(""))
    volume += pi / 4 * (section.outer * section.outer - section.inner * section.inner) *
              (section.to - section.from);
  const Body body("steps", make_stepped_shaft(options), Material());
  check_ratio("steps: mass over that of the cylinders",
              body.mass() / (volume * Material().density),
              1e-12);

  // A shaft that is hollow all along has no disc: the bore is a surface, and there is no axis.
  options.text = "0 10 12 4, 10 30 20 8, 30 45 16 4";
  const Body   tube("tube", make_stepped_shaft(options), Material());
  const double hollow =
    pi / 4 * ((12. * 12 - 4 * 4) * 10 + (20. * 20 - 8 * 8) * 20 + (16. * 16 - 4 * 4) * 15);
  check_ratio("hollow shaft: mass over that of the cylinders",
              tube.mass() / (hollow * Material().density),
              1e-12);
  check("hollow shaft: sets", tube.has_node_set("bore") && !tube.has_node_set("axis"));
  double farthest = 0;
  for (const unsigned int node : tube.node_set("bore"))
    raise_to(farthest, tube.node_positions()[node].head<2>().norm());
  check("hollow shaft: bore", farthest >= 4. && farthest < 4.2);
}

/** A shaft of 500 mm between bearings, a force half-way and a torque at the end that is not
 * driven. */
void beam_on_springs(Communicator &world)
{
  const double  E = 206000, nu = .3, G = E / (2 * (1 + nu)), L = 500, d = 40;
  const double  I = pi * std::pow(d, 4) / 64, A = pi * d * d / 4, k = 2e4, F = 1000;
  const double  torque = 5e4, torsional = 1e8;
  const Columns found = run_text(
    "beam",
    study("linear static") + "subsection Model\n" +
      "set bodies = shaft\nset constraints = left, right, drive\n"
      "set loads = push, twist\nset probes = middle, end, far, rim\n" +
      shaft("0 500 40",
            "set elements around = 24\nset axial element size = 12.5\n"
            "set radial element size = 5\n") +
      bearing("left", "z < 1", "set radial stiffness = 20 MN/m\nset axial stiffness = 10 N/um\n") +
      bearing("right", "z > 499", "set radial stiffness = 20000\n") +
      model_text::section("Constraint drive",
                          "set kind = coupling\nset nodes = bottom\n"
                          "set torsional stiffness = 1e8 N mm/rad\n") +
      model_text::section("Load push",
                          "set kind = force\nset nodes = outer\n"
                          "set where = abs(z - 250) < 1\nset force = 0, 1000, 0 N\n") +
      model_text::section("Load twist",
                          "set kind = moment\nset nodes = top\n"
                          "set moment = 0, 0, 50000 N mm\n") +
      model_text::probe("middle", "0, 0, 250 mm") + model_text::probe("end", "0, 0, 0 mm") +
      model_text::probe("far", "0, 0, 500 mm") +
      model_text::probe("rim", "20, 0, 500 mm", "r, theta, z") + "end\n",
    world);
  // Bending and shear of a round section (Cowper), and the springs.
  const double kappa = 6 * (1 + nu) / (7 + 6 * nu);
  const double bow   = F * L * L * L / (48 * E * I) + F * L / (4 * kappa * G * A);
  check_ratio("beam: deflection under the force over the closed form",
              found.at("middle displacement y").back() / (F / (2 * k) + bow),
              0.005);
  // The mean of the ring, beside which the axis lies by the ovalization of the end.
  check_ratio("beam: way of a bearing over F/(2 k)",
              found.at("end displacement y").back() / (F / (2 * k)),
              0.01);
  const Vector3 force(0.,
                      found.at("left reaction force y").back(),
                      found.at("right reaction force y").back());
  check_close("beam: force of the left bearing [N]", force[1], -F / 2, 1e-6 * F);
  check_close("beam: force of the right bearing [N]", force[2], -F / 2, 1e-6 * F);
  check_close("beam: moment of the coupling [N mm]",
              found.at("drive reaction moment z").back(),
              -torque,
              1e-6 * torque);
  const double twist = torque / torsional + torque * L / (G * 2 * I);
  check_ratio("beam: twist of the end over T/k + T L/(G J)",
              (found.at("rim displacement theta").back() - found.at("far displacement y").back()) /
                (20. * twist),
              0.01);
}

/** Relaxation and the linear solution of the same cylinder, pushed at one end. */
void both_statics(Communicator &world)
{
  const std::string push =
    model_text::section("Load push",
                        "set kind = force\nset nodes = section 1\nset where = z > 59\n"
                        "set force = 200, 0, 0 N\n") +
    "set loads = push\n";
  const std::string holds = model_text::section("Constraint drive",
                                                "set kind = coupling\nset nodes = bottom\n"
                                                "set torsional stiffness = 1e8\n");
  const auto        text  = [&](const std::string &kind, const std::string &rest) {
    return cylinder(kind,
                    "left, right, drive",
                    "",
                    "set axial stiffness = 5000\n",
                    holds + push + "end\n" + rest);
  };
  const Columns linear = run_text("linear", text("linear static", ""), world);
  const Columns relaxed =
    run_text("relaxed",
             text("static",
                  "subsection Dynamics\nsubsection Relaxation\nset tolerance = 1e-8\nend\nend\n"),
             world);
  // A rigid cylinder sinks in by F/k where it is pushed and not at all at the other end.
  check_ratio("statics: pushed end over F/k",
              linear.at("top displacement x").back() / (200 / stiffness),
              0.01);
  for (const char *column :
       {"top displacement x", "bottom displacement x", "right reaction force x"})
    check_close(std::string("statics: relaxation and linear solution, ") + column,
                relaxed.at(column).back() / linear.at("top displacement x").back(),
                linear.at(column).back() / linear.at("top displacement x").back(),
                column[0] == 'r' ? 1e-3 * stiffness : 1e-3);
}

/** The cylinder on two tapered roller bearings that are preloaded against each other: the
 * relaxation, which has the whole law, against the linear solution about its working loads. */
void tapered(Communicator &world)
{
  const auto row = [](const std::string &name, const std::string &where, const std::string &more) {
    return model_text::section("Constraint " + name,
                               "set kind = rolling bearing\nset nodes = section 1\nset where = " +
                                 where +
                                 "\nset element = roller\nset number of elements = 20\n"
                                 "set element diameter = 8\nset element length = 12\n"
                                 "set pitch diameter = 110\nset contact angle = 15 deg\n"
                                 "set preload = 500 N\n" +
                                 more);
  };
  const auto text = [&](const std::string &kind, const std::string &at, const std::string &rest) {
    return study(kind) +
           "subsection Model\nset bodies = shaft\nset constraints = left, right, drive\n"
           "set loads = push\nset probes = bottom, top\n" +
           shaft("0 60 100",
                 "set elements around = 16\nset axial element size = 15\nset radial element size "
                 "= 20\n") +
           row("left", "z < 1", "set axial load direction = -z\n") +
           row("right",
               "z > 59",
               "set axial load direction = +z\nset working load = " + at + "\n") +
           model_text::section("Constraint drive", "set kind = coupling\nset nodes = bottom\n") +
           model_text::section("Load push",
                               "set kind = force\nset nodes = section 1\nset where = z > 59\n"
                               "set force = 0, 0, 20 N\n") +
           model_text::probe("bottom", "0, 0, 0 mm") + model_text::probe("top", "0, 0, 60 mm") +
           "end\n" + rest;
  };
  const std::string relax = model_text::relaxation("1e-7");
  const Columns linear    = run_text("tapered_linear", text("linear static", "0, 0, 0", ""), world);
  const Columns whole     = run_text("tapered", text("static", "0, 0, 0", relax), world);
  // A twentieth of the preload: the law is straight to a percent.
  check_ratio("tapered: axial way by relaxation over the linear one",
              whole.at("top displacement z").back() / linear.at("top displacement z").back(),
              .01);
  check_close("tapered: both bearings carry the load [N]",
              whole.at("left reaction force z").back() + whole.at("right reaction force z").back(),
              -20.,
              1e-3);
  // The cylinder gives way under the preload, which falls by a hundredth.
  const auto pressed = [](const Columns &found) {
    return found.at("left reaction force z").back() - found.at("right reaction force z").back();
  };
  check_close("tapered: and press against each other [N]", pressed(whole), pressed(linear), 1.);
  check_close("tapered: nearly as preloaded [N]", pressed(whole), 1000., 20.);
}

/** In axes that turn, a bearing with two stiffnesses across is one with their mean; at rest it
 * tells both apart. */
void unequal_bearings(Communicator &world)
{
  const auto frequencies = [&world](const std::string &name, const std::string &left) {
    const auto text = study("modal") +
                      "subsection Model\nset bodies = shaft\nset constraints = left, right\n" +
                      shaft("0 60 100",
                            "set elements around = 16\nset axial element size = 15\n"
                            "set radial element size = 20\n") +
                      bearing("left", "z < 1", left + "set x direction = 1, 0, 0\n") +
                      bearing("right", "z > 59", "set radial stiffness = 5000\n") +
                      "end\nsubsection Fem\nset modes = 10\nset coriolis = yes\n"
                      "set speeds = 0, 3000\nend\n" +
                      quiet_output(1);
    std::ofstream(name + ".prm") << text;
    run_pair(name + ".prm", name, world);
    return read_columns(name + "/modes.csv");
  };
  const Columns unequal = frequencies("unequal",
                                      "set stiffness matrix = 2000 0 0 0 0, 0 8000 0 0 0, "
                                      "0 0 0 0 0, 0 0 0 0 0, 0 0 0 0 0\n"),
                mean    = frequencies("mean", "set radial stiffness = 5000\n");
  double at_speed = 0, at_rest = 0;
  check("unequal bearings: as many modes",
        unequal.at("frequency").size() == mean.at("frequency").size());
  for (std::size_t i = 0; i < mean.at("frequency").size(); ++i)
    {
      const double difference =
        std::abs(unequal.at("frequency")[i] - mean.at("frequency")[i]) / 300;
      double &largest = mean.at("speed")[i] > 0 ? at_speed : at_rest;
      raise_to(largest, difference);
    }
  check_below("unequal bearings at speed: frequencies less those of the mean, over 300 Hz",
              at_speed,
              1e-6);
  check("unequal bearings at rest: told apart", at_rest > .05);
}

/** A rotor of the textbook, prm/supports/NAME.prm: rates of its waves of one diameter in axes
 * that do not turn, at rest and at 4000 rpm [rad/s]. */
void textbook_rotor(const std::string         &name,
                    const std::vector<double> &at_rest,
                    const std::vector<double> &turning,
                    Communicator              &world)
{
  run_pair(tree_folder() + "/prm/supports/" + name + ".prm",
           name,
           world,
           {"Fem/modes=16", "Study/output folder=" + name});
  const Table table  = read_result_table(name + "/modes.csv");
  const auto  column = [&table](const std::string &of) {
    for (const Table::Column &c : table.columns())
      if (c.name == of)
        return c.numbers;
    return std::vector<double>();
  };
  const auto speed = column("speed"), diameter = column("nodal diameter"),
             fixed = column("fixed frequency");
  for (const double at : {0., 4000.})
    {
      std::vector<double> rates;
      for (std::size_t i = 0; i < speed.size(); ++i)
        if (std::abs(speed[i] - at) < 1 && diameter[i] == 1)
          rates.push_back(2 * pi * fixed[i]);
      std::sort(rates.begin(), rates.end());
      const std::vector<double> &book    = at == 0 ? at_rest : turning;
      double                     largest = 0;
      for (std::size_t i = 0; i < book.size(); ++i)
        raise_to(largest, std::abs(rates.at(i) / book[i] - 1));
      check_below(name + " at " + std::to_string(std::lround(at)) +
                    " rpm: rates over the textbook's less one",
                  largest,
                  0.01);
    }
}

/** The two discs in torsion by the closed form of a bar: rate [rad/s] of discs that hold the
 * shaft over a length of @p held [mm] each, as far as neither bends nor shears. */
double torsion_of_discs(const double held)
{
  const double G = 81.2e3, density = 7.81e-9, d = 50;
  const double J = pi * std::pow(d, 4) / 32, c = std::sqrt(G / density);
  const auto   inertia = [&](const double D) {
    return density * 70 * pi / 32 * (std::pow(D, 4) - std::pow(d, 4));
  };
  // Torque at the far end of a bar that begins free and turned by one.
  const auto torque = [&](const double w) {
    double     turn = 1, T = 0;
    const auto pass = [&](const double length) {
      const double k = w / c, cosine = std::cos(k * length), sine = std::sin(k * length);
      const double before = turn;
      turn                = turn * cosine + T / (G * J * k) * sine;
      T                   = T * cosine - before * G * J * k * sine;
    };
    pass(500 - held / 2);
    T -= inertia(280) * w * w * turn;
    pass(500 - held);
    T -= inertia(350) * w * w * turn;
    pass(500 - held / 2);
    return T;
  };
  double low = 500, high = 800;
  while (high - low > 1e-9)
    {
      const double middle                                      = .5 * (low + high);
      ((torque(middle) > 0) == (torque(low) > 0) ? low : high) = middle;
    }
  return low;
}

void two_discs(Communicator &world)
{
  textbook_rotor("two_discs",
                 {86.66, 86.66, 274.31, 274.31, 716.78, 716.78},
                 {85.39, 87.80, 251.78, 294.71, 600.18},
                 world);
  // The textbook's entry at rest and at 4000 rpm alike is the torsion of points on a bar. The
  // solid discs sit on webs of 20 mm, which hold the shaft over a part of that.
  check_close("two_discs: torsion of points on a bar [rad/s]", torsion_of_discs(0), 650.41, 0.005);
  // The lowest elastic motion without nodal diameters.
  const Columns            modes = read_columns("two_discs/modes.csv");
  std::map<double, double> lowest;
  for (std::size_t i = 0; i < modes.at("speed").size(); ++i)
    if (modes.at("nodal diameter")[i] == 0 && modes.at("frequency")[i] > 10)
      lowest.try_emplace(modes.at("speed")[i], 2 * pi * modes.at("frequency")[i]);
  const double at_rest = lowest.at(0), in_spin = lowest.at(4000);
  check("two_discs: torsion between points and 20 mm held rigidly, at rest and in spin",
        std::min(at_rest, in_spin) > torsion_of_discs(0) &&
          std::max(at_rest, in_spin) < torsion_of_discs(20));
  check_ratio("two_discs: spin leaves it alone", in_spin / at_rest, 1e-3);
}

void overhung_disc(Communicator &world)
{
  textbook_rotor("overhung_disc",
                 {90.14, 90.14, 630.73, 630.73, 830.43, 830.43},
                 {76.19, 103.91, 565.99, 634.23, 647.75, 1174.2},
                 world);
}

void refused(const std::string &text, Communicator &world)
{
  print_refusal([&] { run_text("refused_rotor", text, world); });
}

void refusals(Communicator &world)
{
  const auto with = [](const std::string &sections, const std::string &entries) {
    return study("linear static") +
           "subsection Model\nset bodies = shaft\nset constraints = left\n" + shaft(sections, "") +
           bearing("left", "z < 1", entries) + "end\n";
  };
  const auto rolling = [](const std::string &entries) {
    return study("linear static") +
           "subsection Model\nset bodies = shaft\nset constraints = left\n" +
           shaft("0 60 100", "") +
           model_text::section("Constraint left",
                               "set kind = rolling bearing\nset nodes = section 1\n" + entries) +
           "end\n";
  };
  const std::string radial = "set radial stiffness = 1\n";
  refused(with("0 60 100, 50 80 20", radial), world);
  refused(with("0 60 100, 60 50 20", radial), world);
  refused(with("0 60 100, 60 80 20 20", radial), world);
  refused(with("0 60 100, 70 80 20", radial), world);
  refused(with("0 60 100 x", radial), world);
  refused(with("0 60", radial), world);
  refused(with("10 60 100", radial), world);
  refused(with("0 60 100", ""), world);
  refused(with("0 60 100", radial + "set stiffness matrix = 1 2 3\n"), world);
  refused(with("0 60 100", "set stiffness matrix = 1 2 3\n"), world);
  refused(with("0 60 100",
               "set stiffness matrix = 1 1 0 0 0, 0 1 0 0 0, 0 0 1 0 0, 0 0 0 1 0, 0 0 0 0 1\n"),
          world);
  refused(with("0 60 100",
               "set stiffness matrix = 1 2 0 0 0, 2 1 0 0 0, 0 0 1 0 0, 0 0 0 1 0, 0 0 0 0 1\n"),
          world);
  refused(with("0 60 100", radial + "set x direction = 0, 0, 2\n"), world);
  refused(rolling("set element = roller\nset number of elements = 20\nset element diameter = 8\n"
                  "set pitch diameter = 60\n"),
          world);
  refused(rolling("set number of elements = 20\nset element diameter = 8\n"
                  "set pitch diameter = 60\nset axial load direction = z\n"),
          world);
  refused(with("0 60 100", radial), world); // free along and about its axis
}

int main(int argc, char **argv)
{
  steps();
  run_parts<Communicator>(argc,
                          argv,
                          {&beam_on_springs,
                           &both_statics,
                           &tapered,
                           &unequal_bearings,
                           &two_discs,
                           &overhung_disc,
                           &refusals});
  return 0;
}
