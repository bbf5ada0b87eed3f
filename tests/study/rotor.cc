// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Shafts in bearings against closed forms: a beam on two springs, the whirl of a rigid rotor in a
// run, what dampers and couplings do; and the rotor of two discs of the textbook.
#include "../model_sections.h"
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/types.h>
#include <vfife/mesh/primitives/stepped_shaft.h>
#include <vfife/model/body.h>

#include <algorithm>
#include <complex>

using namespace vfife;

namespace
{
  using Complex = std::complex<double>;
  using Columns = std::map<std::string, std::vector<double>>;

  std::string study(const std::string &kind)
  {
    return "subsection Study\n set kind = " + kind + "\nend\n";
  }

  std::string bearing(const std::string &name, const std::string &where, const std::string &entries)
  {
    return model_text::section("Constraint " + name,
                               "set kind = bearing\nset nodes = section 1\nset where = " + where +
                                 "\n" + entries);
  }

  std::string shaft(const std::string &sections, const std::string &entries)
  {
    return model_text::section("Body shaft",
                               "set mesh = stepped shaft\nset sections = " + sections +
                                 "\nset bearing = yes\nset axis direction = 0, 0, 1\n" + entries);
  }

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
    check_close("steps: mass over that of the cylinders",
                body.mass() / (volume * Material().density),
                1.,
                1e-12);
  }

  /** A shaft of 500 mm between bearings, a force half-way and a torque at the end that is not
   * driven. */
  void beam_on_springs(Communicator &world)
  {
    const double  E = 206000, nu = .3, G = E / (2 * (1 + nu)), L = 500, d = 40;
    const double  I = pi * std::pow(d, 4) / 64, A = pi * d * d / 4, k = 2e4, F = 1000;
    const double  torque = 5e4, torsional = 1e8;
    const Columns found =
      run_text("beam",
               study("linear static") + "subsection Model\n" +
                 "set bodies = shaft\nset constraints = left, right, drive\n"
                 "set loads = push, twist\nset probes = middle, end, far, rim\n" +
                 shaft("0 500 40",
                       "set cells around = 24\nset axial cell size = 12.5\n"
                       "set radial cell size = 5\n") +
                 bearing("left",
                         "z < 1",
                         "set radial stiffness = 20 MN/m\nset axial stiffness = 10 N/um\n") +
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
                 model_text::probe("middle", "0, 0, 250 mm") +
                 model_text::probe("end", "0, 0, 0 mm") + model_text::probe("far", "0, 0, 500 mm") +
                 model_text::probe("rim", "20, 0, 500 mm", "r, theta, z") + "end\n",
               world);
    // Bending and shear of a round section (Cowper), and the springs.
    const double kappa = 6 * (1 + nu) / (7 + 6 * nu);
    const double bow   = F * L * L * L / (48 * E * I) + F * L / (4 * kappa * G * A);
    check_close("beam: deflection under the force over the closed form",
                found.at("middle displacement y").back() / (F / (2 * k) + bow),
                1.,
                0.005);
    // The mean of the ring, beside which the axis lies by the ovalization of the end.
    check_close("beam: way of a bearing over F/(2 k)",
                found.at("end displacement y").back() / (F / (2 * k)),
                1.,
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
    check_close("beam: twist of the end over T/k + T L/(G J)",
                (found.at("rim displacement theta").back() -
                 found.at("far displacement y").back()) /
                  (20. * twist),
                1.,
                0.01);
  }

  /** A short cylinder, far stiffer than the bearings at its ends. */
  constexpr double height = 60, stiffness = 5000, rate = 2000;

  std::string cylinder(const std::string &kind,
                       const std::string &constraints,
                       const std::string &body,
                       const std::string &bearings,
                       const std::string &rest)
  {
    return study(kind) + "subsection Model\nset bodies = shaft\nset constraints = " + constraints +
           "\nset probes = bottom, top\n" +
           shaft("0 60 100",
                 "set cells around = 16\nset axial cell size = 15\nset radial cell size = 20\n" +
                   body) +
           bearing("left", "z < 1", "set radial stiffness = 5000\n" + bearings) +
           bearing("right", "z > 59", "set radial stiffness = 5000\n" + bearings) +
           model_text::probe("bottom", "0, 0, 0 mm") + model_text::probe("top", "0, 0, 60 mm") +
           rest;
  }

  /** Without the jump from undeformed to spun, whose ringing would be most of the energy. */
  std::string run_of(const std::string &time)
  {
    return "end\nsubsection Dynamics\nset start = static preload\nset end time = " + time +
           "\nset damping = 0\nend\n" + quiet_output(20);
  }

  /** Mass and inertias about its centre of the cylinder's nodes. */
  struct Rotor
  {
    double mass = 0, across = 0, axial = 0;

    Rotor()
    {
      SteppedShaftOptions options;
      options.text             = "0 60 100";
      options.around           = 16;
      options.axial_cell_size  = 15;
      options.radial_cell_size = 20;
      const Body body("shaft", make_stepped_shaft(options), Material());
      mass = body.mass();
      for (unsigned int i = 0; i < body.n_nodes(); ++i)
        {
          const Vector3 r = body.node_positions()[i] - Vector3(0., 0., .5 * height);
          across += body.node_masses()[i] * (r[1] * r[1] + r[2] * r[2]);
          axial += body.node_masses()[i] * (r[0] * r[0] + r[1] * r[1]);
        }
    }
  };

  double largest_energy_error(const Columns &run)
  {
    double largest = 0;
    for (const double error : run.at("energy error"))
      largest = largest_of(largest, std::abs(error));
    return largest;
  }

  /** Whirl of the spinning cylinder: to and fro as a point mass, tilting as a top, forwards and
   * backwards at two rates. */
  void whirl(Communicator &world)
  {
    const Rotor   rotor;
    const Columns run = run_text("whirl",
                                 cylinder("run",
                                          "left, right",
                                          "set speed = 2000 rad/s\n"
                                          "set initial velocity x = 1.5*(z - 30)\n"
                                          "set initial velocity y = 40\n"
                                          "set initial velocity z = -1.5*x\n",
                                          "",
                                          run_of("8 ms")),
                                 world);
    // It u'' - i Omega Ip u' + k_t u = 0 for the complex place u of an end against the middle.
    const double tilting    = 2 * stiffness * height * height / 4;
    const double gyro       = rate * rotor.axial;
    const double root       = std::sqrt(gyro * gyro + 4 * rotor.across * tilting);
    const double forward    = (gyro + root) / (2 * rotor.across),
                 backward   = (gyro - root) / (2 * rotor.across);
    const double omega      = std::sqrt(2 * stiffness / rotor.mass);
    double       tilt_error = 0, shift_error = 0;
    const auto  &time = run.at("time");
    for (std::size_t i = 0; i < time.size(); ++i)
      {
        const Complex top(run.at("top displacement x")[i], run.at("top displacement y")[i]),
          bottom(run.at("bottom displacement x")[i], run.at("bottom displacement y")[i]);
        const double  t = time[i];
        const Complex expected =
          1.5 * height / 2 *
          (std::exp(Complex(0., forward * t)) - std::exp(Complex(0., backward * t))) /
          Complex(0., forward - backward);
        tilt_error  = largest_of(tilt_error, std::abs(.5 * (top - bottom) - expected));
        shift_error = largest_of(shift_error,
                                 std::abs(.5 * (top + bottom) -
                                          Complex(0., 40. / omega * std::sin(omega * t))));
      }
    check("whirl: to the end", time.back() > 7.9e-3);
    // Elastic deformation of the cylinder is some 1e-3 of its motion on the bearings.
    check_below("whirl: way of the middle less the point mass, over its amplitude",
                shift_error / (40. / omega),
                0.02);
    check_below("whirl: tilt less the top's, over its amplitude",
                tilt_error / (2 * 45. / (forward - backward)),
                0.02);
    check_below("whirl: energy error", largest_energy_error(run), 2e-3);
  }

  /** The same without spin, with dampers: x'' + (2 c/m) x' + omega^2 x = 0. */
  void damped(Communicator &world)
  {
    const Rotor   rotor;
    const Columns run = run_text(
      "damped",
      cylinder("run",
               "left, right",
               "set speed = 0\nset initial velocity y = 40\n",
               "set damping matrix = 0.5 0 0 0 0, 0 0.5 0 0 0, 0 0 0.1 0 0, 0 0 0 9 0, 0 0 0 0 9\n"
               "set tilting stiffness = 10 N mm/rad\n",
               run_of("8 ms")),
      world);
    const double decay = .5 / rotor.mass, omega2 = 2 * stiffness / rotor.mass;
    const double omega = std::sqrt(omega2 - decay * decay);
    double       error = 0;
    const auto  &time  = run.at("time");
    for (std::size_t i = 0; i < time.size(); ++i)
      error =
        largest_of(error,
                   std::abs(run.at("top displacement y")[i] -
                            40. / omega * std::exp(-decay * time[i]) * std::sin(omega * time[i])));
    check_below("damped: way less the closed form, over its amplitude",
                error / (40. / omega),
                0.02);
    const double left = std::exp(-2 * decay * time.back());
    check("damped: most of the energy is lost", left < .5);
    check_below("damped: energy error", largest_energy_error(run), 2e-3);
  }

  /** A torque against the driven end winds the coupling: phi = T/k (1 - cos w t). */
  void wound(Communicator &world)
  {
    const Rotor   rotor;
    const double  torsional = 4e6, torque = -2000;
    const Columns run =
      run_text("wound",
               cylinder("run",
                        "left, right, drive",
                        "set speed = 300 rad/s\n",
                        "",
                        model_text::section("Constraint drive",
                                            "set kind = coupling\nset nodes = bottom\n"
                                            "set torsional stiffness = 4e6\n") +
                          "set loads = brake\n" +
                          model_text::section("Load brake",
                                              "set kind = moment\nset nodes = top\n"
                                              "set moment = 0, 0, -2000 N mm\n"
                                              "set history = if(t > 0, 1, 0)\n") +
                          run_of("12 ms")),
               world);
    const double omega = std::sqrt(torsional / rotor.axial);
    double       error = 0, work = 0;
    const auto  &time = run.at("time");
    for (std::size_t i = 0; i < time.size(); ++i)
      {
        const double phi = torque / torsional * (1 - std::cos(omega * time[i]));
        // Moment of the coupling on the shaft: what the reactions state.
        error = largest_of(error,
                           std::abs(run.at("drive reaction moment z")[i] + torsional * phi) /
                             (2 * -torque));
        // Its power on the driver's end, integrated: -k phi Omega.
        work = -torque * 300. * (time[i] - std::sin(omega * time[i]) / omega);
      }
    check_below("wound: moment of the coupling less the closed form, over its largest",
                error,
                0.02);
    check_close("wound: drive work over the closed form",
                run.at("work of the drive").back() / work,
                1.,
                0.01);
    check_below("wound: energy error", largest_energy_error(run), 1e-4);
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
    check_close("statics: pushed end over F/k",
                linear.at("top displacement x").back() / (200 / stiffness),
                1.,
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
    const auto row = [](const std::string &name,
                        const std::string &where,
                        const std::string &more) {
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
                   "set cells around = 16\nset axial cell size = 15\nset radial cell size = 20\n") +
             row("left", "z < 1", "set holds = -z\n") +
             row("right", "z > 59", "set holds = +z\nset working load = " + at + "\n") +
             model_text::section("Constraint drive", "set kind = coupling\nset nodes = bottom\n") +
             model_text::section("Load push",
                                 "set kind = force\nset nodes = section 1\nset where = z > 59\n"
                                 "set force = 0, 0, 20 N\n") +
             model_text::probe("bottom", "0, 0, 0 mm") + model_text::probe("top", "0, 0, 60 mm") +
             "end\n" + rest;
    };
    const std::string relax =
      "subsection Dynamics\nsubsection Relaxation\nset tolerance = 1e-7\nend\nend\n";
    const Columns linear = run_text("tapered_linear", text("linear static", "0, 0, 0", ""), world);
    const Columns whole  = run_text("tapered", text("static", "0, 0, 0", relax), world);
    // A twentieth of the preload: the law is straight to a percent.
    check_close("tapered: axial way by relaxation over the linear one",
                whole.at("top displacement z").back() / linear.at("top displacement z").back(),
                1.,
                .01);
    check_close("tapered: both bearings carry the load [N]",
                whole.at("left reaction force z").back() +
                  whole.at("right reaction force z").back(),
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
                              "set cells around = 16\nset axial cell size = 15\n"
                              "set radial cell size = 20\n") +
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
        largest         = largest_of(largest, difference);
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
    run_pair(SOURCE_DIR "/../../prm/supports/" + name + ".prm",
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
          largest = largest_of(largest, std::abs(rates.at(i) / book[i] - 1));
        check_below(name + " at " + std::to_string(std::lround(at)) +
                      " rpm: rates over the textbook's less one",
                    largest,
                    0.01);
      }
  }

  void two_discs(Communicator &world)
  {
    textbook_rotor("two_discs",
                   {86.66, 86.66, 274.31, 274.31, 716.78, 716.78},
                   {85.39, 87.80, 251.78, 294.71, 600.18},
                   world);
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
             "subsection Model\nset bodies = shaft\nset constraints = left\n" +
             shaft(sections, "") + bearing("left", "z < 1", entries) + "end\n";
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
                    "set pitch diameter = 60\nset holds = z\n"),
            world);
    refused(with("0 60 100", radial), world); // free along and about its axis
  }
} // namespace

int main(int argc, char **argv)
{
  steps();
  run_parts<Communicator>(argc,
                          argv,
                          {&beam_on_springs,
                           &whirl,
                           &damped,
                           &wound,
                           &both_statics,
                           &tapered,
                           &unequal_bearings,
                           &two_discs,
                           &overhung_disc,
                           &refusals});
}
