// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Runs of a short rotor in bearings against closed forms: its whirl, forward and backward, what
// dampers and couplings do, and the passage of the elements of a bearing whose cage rolls.
#include "../../parts.h"
#include "../child_program.h"
#include "../quick_pair.h"
#include "../short_rotor.h"

#include <vfife/base/types.h>
#include <vfife/bearing/rolling_bearing.h>
#include <vfife/mesh/primitives/stepped_shaft.h>
#include <vfife/model/body.h>

#include <Eigen/QR>

using namespace vfife;
using namespace rotor_text;

/** Without the jump from undeformed to spun, whose ringing would be most of the energy. */
std::string run_of(const std::string &time)
{
  return "end\nsubsection Dynamics\nset start = static equilibrium\nset end time = " + time +
         "\nset mass proportional damping = 0\nend\n" + quiet_output(20);
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

/** Rates of the lines a exp(i w1 t) + b exp(i w2 t) of a whirl, > 0 forwards, from near them:
 * with t exp(i w t) beside each line its least squares say by how much it is off. */
std::array<double, 2> fit_lines(const std::vector<double>  &time,
                                const std::vector<Complex> &whirl,
                                std::array<double, 2>       rates)
{
  const Eigen::Map<const Eigen::VectorXcd> right(whirl.data(), whirl.size());
  for (unsigned int iteration = 0; iteration < 8; ++iteration)
    {
      Eigen::MatrixXcd columns(whirl.size(), 4);
      for (std::size_t i = 0; i < whirl.size(); ++i)
        for (unsigned int k = 0; k < 2; ++k)
          {
            columns(i, k)     = std::exp(Complex(0., rates[k] * time[i]));
            columns(i, 2 + k) = time[i] / time.back() * columns(i, k);
          }
      const Eigen::VectorXcd x = columns.householderQr().solve(right);
      for (unsigned int k = 0; k < 2; ++k)
        rates[k] += (x[2 + k] / x[k]).imag() / time.back();
    }
  return rates;
}

/** Whirl of the spinning cylinder: to and fro as a point mass, tilting as a top, forwards and
 * backwards at two rates. */
void whirl(Communicator &world)
{
  const Rotor   rotor;
  const Columns run = run_text("whirl",
                               cylinder("run",
                                        "left, right",
                                        "set rotational speed = 2000 rad/s\n"
                                        "set initial velocity x = 1.5*(z - 30)\n"
                                        "set initial velocity y = 40\n"
                                        "set initial velocity z = -1.5*x\n",
                                        "",
                                        run_of("8 ms")),
                               world);
  // It u'' - i Omega Ip u' + k_t u = 0 for the complex place u of an end against the middle.
  const double tilting            = 2 * stiffness * height * height / 4;
  const double gyro               = rate * rotor.axial;
  const double root               = std::sqrt(gyro * gyro + 4 * rotor.across * tilting);
  const double forward            = (gyro + root) / (2 * rotor.across),
               backward           = (gyro - root) / (2 * rotor.across);
  const double         omega      = std::sqrt(2 * stiffness / rotor.mass);
  double               tilt_error = 0, shift_error = 0;
  std::vector<Complex> tilt, shift;
  const auto          &time = run.at("time");
  for (std::size_t i = 0; i < time.size(); ++i)
    {
      const Complex top(run.at("top displacement x")[i], run.at("top displacement y")[i]),
        bottom(run.at("bottom displacement x")[i], run.at("bottom displacement y")[i]);
      tilt.push_back(.5 * (top - bottom));
      shift.push_back(.5 * (top + bottom));
      const double  t = time[i];
      const Complex expected =
        1.5 * height / 2 *
        (std::exp(Complex(0., forward * t)) - std::exp(Complex(0., backward * t))) /
        Complex(0., forward - backward);
      raise_to(tilt_error, std::abs(tilt.back() - expected));
      raise_to(shift_error,
               std::abs(shift.back() - Complex(0., 40. / omega * std::sin(omega * t))));
    }
  check("whirl: to the end", time.back() > 7.9e-3);
  // Elastic deformation of the cylinder is some 1e-3 of its motion on the bearings.
  check_below("whirl: way of the middle less the point mass, over its amplitude",
              shift_error / (40. / omega),
              0.02);
  check_below("whirl: tilt less the top's, over its amplitude",
              tilt_error / (2 * 45. / (forward - backward)),
              0.02);
  check_below("whirl: energy error", largest_size(run.at("energy error")), 2e-3);
  // Begun 4 % beside them, of which the fit must find back.
  const auto lines_of_shift = fit_lines(time, shift, {{1.04 * omega, -.96 * omega}}),
             lines_of_tilt  = fit_lines(time, tilt, {{1.04 * forward, .96 * backward}});
  check_ratio("whirl: forward line of the point mass over sqrt(k/m)",
              lines_of_shift[0] / omega,
              0.005);
  check_ratio("whirl: backward line of the point mass over -sqrt(k/m)",
              -lines_of_shift[1] / omega,
              0.005);
  check_ratio("whirl: forward line of the top over the closed form",
              lines_of_tilt[0] / forward,
              0.005);
  check_ratio("whirl: backward line of the top over the closed form",
              lines_of_tilt[1] / backward,
              0.005);
}

/** The same without spin, with dampers: x'' + (2 c/m) x' + omega^2 x = 0. */
void damped(Communicator &world)
{
  const Rotor   rotor;
  const Columns run = run_text(
    "damped",
    cylinder("run",
             "left, right",
             "set rotational speed = 0\nset initial velocity y = 40\n",
             "set damping matrix = 0.5 0 0 0 0, 0 0.5 0 0 0, 0 0 0.1 0 0, 0 0 0 9 0, 0 0 0 0 9\n"
             "set tilting stiffness = 10 N mm/rad\n",
             run_of("8 ms")),
    world);
  const double decay = .5 / rotor.mass, omega2 = 2 * stiffness / rotor.mass;
  const double omega = std::sqrt(omega2 - decay * decay);
  double       error = 0;
  const auto  &time  = run.at("time");
  for (std::size_t i = 0; i < time.size(); ++i)
    raise_to(error,
             std::abs(run.at("top displacement y")[i] -
                      40. / omega * std::exp(-decay * time[i]) * std::sin(omega * time[i])));
  check_below("damped: way less the closed form, over its amplitude", error / (40. / omega), 0.02);
  const double left = std::exp(-2 * decay * time.back());
  check("damped: most of the energy is lost", left < .5);
  check_below("damped: energy error", largest_size(run.at("energy error")), 2e-3);
}

/** A torque against the driven end winds the coupling: phi = T/k (1 - cos w t), by a thousandth
 * of a turn or by more than one. */
void wind(const std::string &name, const double torsional, const double torque, Communicator &world)
{
  const Rotor rotor;
  std::ofstream(name + ".prm") << cylinder(
    "run",
    "left, right, drive",
    "set rotational speed = 300 rad/s\n",
    "",
    model_text::section("Constraint drive",
                        "set kind = coupling\nset nodes = bottom\n"
                        "set torsional stiffness = " +
                          std::to_string(torsional) + "\n") +
      "set loads = brake\n" +
      model_text::section("Load brake",
                          "set kind = moment\nset nodes = top\n"
                          "set moment = 0, 0, " +
                            std::to_string(torque) +
                            " N mm\n"
                            "set history = if(t > 0, 1, 0)\n") +
      run_of("12 ms"));
  // In two parts: it goes on with the turns that it has.
  std::filesystem::remove_all(name);
  const std::string kept = "Output/checkpoint interval=600 s";
  run_pair(name + ".prm", name, world, {"Dynamics/maximum number of steps=4000", kept});
  run_pair(name + ".prm", name, world, {kept}, true);
  const Columns run   = read_columns(name + "/history.csv");
  const double  omega = std::sqrt(torsional / rotor.axial);
  double        error = 0, work = 0;
  const auto   &time = run.at("time");
  check(name + ": to the end", time.back() > 11.9e-3);
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
  check_below(name + ": moment of the coupling less the closed form, over its largest",
              error,
              0.02);
  check_ratio(name + ": drive work over the closed form",
              run.at("work of the drive").back() / work,
              0.01);
  check_below(name + ": energy error", largest_size(run.at("energy error")), 1e-4);
}

void wound(Communicator &world)
{
  wind("wound", 4e6, -2000, world);
  wind("wound by turns", 5e5, -2e6, world);
}

/** Forces and moments of bearings with dampers, a coupling and a load, step by step: they are
 * what momentum and angular momentum of the body change by. */
void balance(Communicator &world)
{
  const Columns run = run_text(
    "balance",
    cylinder("run",
             "left, right, drive",
             "set rotational speed = 2000 rad/s\nset initial velocity x = 1.5*(z - 30)\n"
             "set initial velocity y = 40\nset initial velocity z = -1.5*x\n",
             "set axial stiffness = 2000\nset radial damping = 2\n"
             "set tilting stiffness = 1e6\nset tilting damping = 100\n",
             model_text::section("Constraint drive",
                                 "set kind = coupling\nset nodes = bottom\n"
                                 "set torsional stiffness = 4e6\n"
                                 "set torsional damping = 100\n") +
               "set loads = brake\n" +
               model_text::section("Load brake",
                                   "set kind = moment\nset nodes = top\n"
                                   "set moment = 500, -300, -2000 N mm\n") +
               "end\nsubsection Dynamics\nset end time = 1\n"
               "set maximum number of steps = 300\nset mass proportional damping = 0\nend\n" +
               quiet_output(1)),
    world);
  const Vector3 load(500, -300, -2000);
  // Forces and moments of t_n change the momenta from those of t_n - dt/2, which are reported.
  for (const char *of : {"force", "moment"})
    {
      const bool        is_force = std::string(of) == "force";
      const std::string momentum = is_force ? "momentum " : "angular momentum ";
      double            off = 0, scale = 0;
      for (unsigned int c = 0; c < 3; ++c)
        {
          const std::string axis = {"xyz"[c]};
          const auto       &P = run.at(momentum + axis), &time = run.at("time");
          double            impulse = 0;
          for (std::size_t i = 0; i + 1 < time.size(); ++i)
            {
              double sum = is_force ? 0. : load[c];
              for (const char *name : {"left", "right", "drive"})
                sum += run.at(std::string(name) + " reaction " + of + " " + axis)[i];
              impulse += (time[i + 1] - time[i]) * sum;
              raise_to(off, std::abs(P[i + 1] - P[0] - impulse));
              scale = std::max(scale, std::abs(P[i + 1] - P[0]));
            }
        }
      check_below(std::string("balance: ") + of +
                    "s of bearings, coupling and load against the change of momentum",
                  off / scale,
                  1e-6);
    }
}

/** A bearing of few balls with clearance, the first one where the load presses. */
RollingBearingData ball_bearing()
{
  RollingBearingData data;
  data.n              = 7;
  data.diameter       = 14;
  data.pitch_diameter = 70;
  data.clearance      = .02;
  data.cage_rolls     = true;
  return data;
}

std::string ball_seat(const std::string &name, const std::string &where)
{
  return model_text::section("Constraint " + name,
                             "set kind = rolling bearing\nset nodes = section 1\nset where = " +
                               where +
                               "\nset number of elements = 7\nset element diameter = 14\n"
                               "set pitch diameter = 70\nset clearance = 0.02\n"
                               "set inner conformity = 0.52\nset outer conformity = 0.52\n"
                               "set x direction = 1, 0, 0\nset cage = rolling\n");
}

/** Amplitude of the line with this frequency, of the samples of its first period. */
double amplitude(const std::vector<double> &time,
                 const std::vector<double> &values,
                 const double               frequency)
{
  Complex      sum = 0;
  unsigned int n   = 0;
  for (; n < time.size() && time[n] < 1 / frequency; ++n)
    sum += values[n] * std::exp(Complex(0., -2 * pi * frequency * time[n]));
  return 2 * std::abs(sum) / n;
}

/** The cylinder under a constant force on two bearings whose cages roll, far slower than it
 * swings: its seats are where the static law has them at the angle of the cage, the pattern
 * comes again with every ball, and the drive does the work that elements take and give. */
void ball_passage(Communicator &world)
{
  const double             force = 2000, slow = 60;
  const RollingBearingData data  = ball_bearing();
  const double             share = RollingBearing(data, Matrix5::Zero()).cage_share();
  const double             balls = data.n * share * slow / (2 * pi); // [1/s]
  const Columns            run =
    run_text("ball_passage",
             study("run") +
               "subsection Model\nset bodies = shaft\nset constraints = left, right, along\n"
               "set loads = push\n" +
               shaft("0 60 100",
                     "set elements around = 16\nset axial element size = 15\n"
                     "set radial element size = 20\nset rotational speed = 60 rad/s\n") +
               ball_seat("left", "z < 1") + ball_seat("right", "z > 59") +
               bearing("along", "z < 1", "set axial stiffness = 1000\n") +
               model_text::section("Load push",
                                   "set kind = force\nset nodes = section 1\n"
                                   "set force = 2000, 0, 0 N\n") +
               run_of(std::to_string(1500 / balls) + " ms"),
             world);
  const Table         table = read_result_table("ball_passage/bearings.csv");
  std::vector<double> ways, of_law;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    if (table.column("bearing").texts[i] == "left")
      ways.push_back(1e-3 * table.numbers("displacement x")[i]);
  const std::vector<double> &time = run.at("time"), &drive = run.at("work of the drive");
  check("passage: one and a half balls", time.back() > 1.49 / balls && ways.size() == time.size());
  // The law under half the force, and the energy of elements and force.
  double error = 0, work_error = 0, largest_work = 0, at_start = 0;
  for (std::size_t i = 0; i < time.size(); ++i)
    {
      RollingBearingData now = data;
      now.cage_angle         = share * slow * time[i];
      const RollingBearing law(now, Matrix5::Zero());
      Vector5              q;
      q << law.displacement_under(Vector3(.5 * force, 0., 0.)), 0., 0.;
      const double energy = 2 * law.evaluate(q).energy - force * q[0];
      if (i == 0)
        at_start = energy;
      of_law.push_back(q[0]);
      raise_to(error, std::abs(ways[i] - q[0]));
      raise_to(work_error, std::abs(drive[i] - (energy - at_start)));
      largest_work = std::max(largest_work, std::abs(energy - at_start));
    }
  const double range = *std::max_element(of_law.begin(), of_law.end()) -
                       *std::min_element(of_law.begin(), of_law.end());
  // What is left is the swing of the cylinder, which the cage starts from rest.
  check_below("passage: way less that of the static law, over its range", error / range, 0.1);
  check_ratio("passage: amplitude at the frequency of the balls over the static law's",
              amplitude(time, ways, balls) / amplitude(time, of_law, balls),
              0.01);
  check_below("passage: work of the drive less that on elements and force, over its largest",
              work_error / largest_work,
              0.01);
  check_below("passage: energy error", largest_size(run.at("energy error")), 1e-3);
}
/** A cage knows from the time alone where it is: interrupted, that run has the same digits. */
void passage_goes_on(Communicator &world)
{
  const std::string steps = "Dynamics/maximum number of steps=",
                    kept  = "Output/checkpoint interval=600 s";
  for (const char *folder : {"whole_passage", "passage_in_parts"})
    std::filesystem::remove_all(folder);
  run_pair("ball_passage.prm", "whole_passage", world, {steps + "1200"});
  run_pair("ball_passage.prm", "passage_in_parts", world, {steps + "500", kept});
  run_pair("ball_passage.prm", "passage_in_parts", world, {steps + "1200", kept}, true);
  const std::string whole = read_text("whole_passage/bearings.csv");
  check("passage, interrupted: same digits",
        whole.size() > 1000 && whole == read_text("passage_in_parts/bearings.csv"));
}

int main(int argc, char **argv)
{
  run_parts<Communicator>(argc,
                          argv,
                          {&whirl, &damped, &wound, &balance, &ball_passage, &passage_goes_on});
  return 0;
}
