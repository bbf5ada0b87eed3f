// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A bar under its weight, at rest by both solvers and let go; a ring whose inner radius is turned
// against the outer one.
#include "../../model_sections.h"
#include "../../parts.h"
#include "../quick_pair.h"

#include <vfife/base/types.h>

using namespace vfife;

constexpr double E = 206000, density = 7.85e-9, length = 100, gravity = 1e6; // [mm/s^2]

/** 100 x 10 x 10 mm, nu = 0, the weight along x away from the foot; probes at tip and middle. */
std::string bar(const std::string &kind, const std::string &rest)
{
  return model_text::study(kind) + R"(
subsection Model
  set bodies      = bar
  set constraints = foot
  set loads       = weight
  set probes      = tip, middle
)" + model_text::block("bar", {{length, 10, 10}}, {{50, 1, 1}}) +
         model_text::section("Constraint foot", "set nodes = x-\n") +
         model_text::section("Load weight",
                             "set kind = acceleration\nset nodes = all\n"
                             "set acceleration = 1e6, 0, 0 mm/s^2\n") +
         model_text::probe("tip", "100, 0, 0 mm") + model_text::probe("middle", "50, 0, 0 mm") +
         "end\n" + model_text::no_contraction() + rest;
}

/** u(x) = rho g (L x - x^2/2)/E, sigma = rho g (L - x): strains of 4e-6, whose squares the static
 * solver sees. */
void hanging(Communicator &world)
{
  const double stretch = density * gravity * length * length / (2 * E);
  for (const std::string &kind : {std::string("linear static"), std::string("static")})
    {
      const bool linear = kind == "linear static";
      auto       h =
        run_text("hanging",
                 bar(kind,
                     linear ? quiet_output() : model_text::relaxation("1e-9") + quiet_output(1)),
                 world);
      const double tolerance = linear ? 1e-8 : 2e-5;
      check_ratio(kind + ": stretch over rho g L^2/(2 E)",
                  h["tip displacement x"].back() / stretch,
                  tolerance);
      check_close(kind + ": of the upper half, three quarters of it",
                  h["middle displacement x"].back() / stretch,
                  0.75,
                  tolerance);
      check_ratio(kind + ": stress in the middle over rho g L/2",
                  h["middle stress x"].back() / (density * gravity * length / 2),
                  tolerance);
    }
}

/** Loads of any size on bodies anywhere bend a cantilever alike. */
void sizes_and_places(Communicator &world)
{
  const auto compliance = [&](const std::string &kind, const double force, const bool far) {
    std::ostringstream load;
    load << force;
    auto h =
      run_text("cantilever",
               model_text::study(kind) +
                 "subsection Model\n  set bodies = beam\n  set constraints = clamp\n"
                 "  set loads = pull\n  set probes = tip\n" +
                 model_text::block(
                   "beam", {{50, 5, 10}}, {{5, 1, 2}}, far ? "set position = 1e7, 0, 0 mm\n" : "") +
                 model_text::section("Constraint clamp", "set nodes = x-\n") +
                 model_text::section("Load pull",
                                     "set nodes = x+\nset force = 0, 0, " + load.str() + " N\n") +
                 model_text::probe("tip", "50, 0, 0 mm") + "end\n" +
                 (kind == "static" ? quiet_output(1) : quiet_output()),
               world);
    return h["tip displacement z"].back() / force;
  };
  const double expected = compliance("linear static", 1, false);
  for (const double force : {1e-6, 1e-3, 1.})
    check_ratio("cantilever, force " + std::to_string(force) + " N: way over force",
                compliance("static", force, false) / expected,
                2e-5);
  // Ways have 2e-9 mm there. A large force changes the shape: the same force at the origin.
  for (const double force : {10., 1000.})
    check_ratio("cantilever at 1e7 mm, force " + std::to_string(force) + " N: way over force",
                compliance("static", force, true) / compliance("static", force, false),
                2e-5);
}

/** A block at rest, pushed from 0.1 ms on: until then its energies are round-off. And its fall:
 * the work of a constant force is that times its way. */
void late_and_falling(Communicator &world)
{
  const auto run = [&](const std::string &load) {
    return run_text("late",
                    model_text::study("run") +
                      "subsection Model\n"
                      "  set bodies = block\n  set loads = push\n  set probes = corner\n" +
                      model_text::block("block", {{10, 10, 10}}, {{2, 2, 2}}) +
                      model_text::section("Load push", load) +
                      model_text::probe("corner", "10, 10, 10") +
                      "end\nsubsection Dynamics\n  set end time = 0.2 ms\nend\n" + quiet_output(1),
                    world);
  };
  auto         late = run("set nodes = x-\nset force = 100, 0, 0 N\n"
                          "set history = if(t > 0.1e-3, 1, 0)\n");
  const double mass = 1000 * density, speed = 100 / mass * 1e-4;
  check_ratio("pushed late: momentum at the end over force times time",
              late["momentum x"].back() / (mass * speed),
              1e-2);
  check_below("pushed late: energy error at the end", std::abs(late["energy error"].back()), 1e-2);
  auto falling = run("set kind = acceleration\nset nodes = all\nset acceleration = 0, 0, -9810\n");
  double off   = 0;
  // The way at the begin is a few units in the last place of a coordinate.
  for (std::size_t i = falling["time"].size() / 2; i < falling["time"].size(); ++i)
    raise_to(off,
             std::abs(falling["work of the loads"][i] /
                        (-mass * 9810 * falling["corner displacement z"][i]) -
                      1));
  check_below("falling: work of the weight less force times way, over it", off, 1e-8);
}

/** Released at once: free fall until the wave of the foot arrives, g t^2/2; then the foot pulls,
 * g t^2/2 - g (t - L/c)^2, up to twice the stretch at 2 L/c. */
void released(Communicator &world)
{
  const double wave = length / std::sqrt(E / density);
  auto         h    = run_text("released",
                    bar("run",
                        "subsection Dynamics\n  set end time = " + std::to_string(3e6 * wave) +
                          " us\nend\n" + quiet_output(1)),
                    world);
  const auto  &time = h["time"], &tip = h["tip displacement x"];
  double       falling = 0, pulled = 0, largest = 0;
  for (std::size_t i = 0; i < time.size(); ++i)
    {
      const double late = time[i] - wave, fall = gravity * time[i] * time[i] / 2;
      const double size = gravity * wave * wave;
      if (late < -0.1 * wave)
        raise_to(falling, std::abs(tip[i] - fall) / size);
      else if (late > 0)
        raise_to(pulled, std::abs(tip[i] - fall + gravity * late * late) / size);
      raise_to(largest, tip[i]);
    }
  check("released: the whole way is seen", time.back() > 2.9 * wave);
  // Nothing has come from the foot yet, but the run is half a step ahead
  // (doc/theory/dynamics.md): by g t dt/2.
  check_below("released: the tip falls freely, less g t^2/2 over g (L/c)^2",
              falling,
              0.5 * (time[1] - time[0]) / wave);
  // The front, a kink of the velocity, is spread over some (50 cells)^(1/3).
  check_below("released: then the foot's wave pulls",
              pulled,
              0.5 * (time[1] - time[0]) / wave + 5e-3);
  check_ratio("released: farthest way over twice the stretch",
              largest / (density * gravity * length * length / E),
              5e-3);
}

/** Both skins of a plate of one layer under a pressure p, all nodes of its narrow sides among
 * theirs: it grows by nu p/E in its plane. */
void pressed(Communicator &world)
{
  using model_text::section;
  const auto held = [](const std::string &direction) {
    return section("Constraint " + direction,
                   "set kind = displacement\nset nodes = " + direction +
                     "-\nset directions = " + direction + "\n");
  };
  for (const std::string &kind : {std::string("linear static"), std::string("static")})
    {
      const bool linear = kind == "linear static";
      auto       h =
        run_text("pressed",
                 model_text::study(kind) +
                   section("Model",
                           "set bodies = plate\nset constraints = x, y, z\nset loads = press\n"
                           "set probes = corner\n" +
                             model_text::block("plate", {{60, 60, 2}}, {{6, 6, 1}}) + held("x") +
                             held("y") + held("z") +
                             section("Load press",
                                     "set kind = pressure\nset nodes = z-, z+\n"
                                     "set pressure = 10 MPa\n") +
                             model_text::probe("corner", "60, 60, 2 mm")) +
                   section("Material steel", "set Poisson's ratio = 0.3\n") +
                   (linear ? quiet_output() : quiet_output(1)),
                 world);
      check_ratio(kind + ": plate pressed on its skins, growth over nu p/E",
                  h["corner displacement x"].back() / (0.3 * 10 / E * 60),
                  linear ? 1e-8 : 1e-3);
    }
}

/** u_theta = B (1/r - r/b^2), tau = -2 G B/r^2; torque 4 pi G B h. */
void twisted(Communicator &world)
{
  const std::string ring =
    "subsection Model\n  set bodies = ring\n  set constraints = inside, outside, below\n"
    "  set probes = middle\n" +
    model_text::ring("ring", {{20, 40, 2}}, {{10, 60, 1}}) +
    model_text::section("Constraint inside",
                        "set kind = displacement\nset nodes = inner\n"
                        "set directions = r, theta\nset angle = 0.01 deg\n") +
    model_text::section("Constraint outside",
                        "set kind = displacement\nset nodes = outer\n"
                        "set directions = r, theta\n") +
    model_text::section("Constraint below",
                        "set kind = displacement\nset nodes = bottom\n"
                        "set where = x^2 + y^2 > 401 && x^2 + y^2 < 1599\n"
                        "set directions = z\n") +
    model_text::probe("middle", "0, 30, 0 mm", "r, theta, z") + "end\n";
  const double G = E / 2.58, B = 0.01 * pi / 180 * 400 * 1600 / 1200.;
  for (const std::string &kind : {std::string("linear static"), std::string("static")})
    {
      auto h = run_text("twisted",
                        model_text::study(kind) + ring +
                          (kind == "static" ? model_text::relaxation("1e-7") : "") + quiet_output(),
                        world);
      // Chords of 6 degrees and cells of 2 x 3 mm: 2e-3 of the way, 7e-3 of the stress.
      check_ratio(kind + ": displacement theta in the middle over B (1/r - r/b^2)",
                  h["middle displacement theta"].back() / (B * (1 / 30. - 30. / 1600)),
                  5e-3);
      check_ratio(kind + ": shear stress r theta in the middle over -2 G B/r^2",
                  h["middle stress r theta"].back() / (-2 * G * B / 900),
                  1e-2);
      check_below(kind + ": stress r there over it",
                  h["middle stress r"].back() / (2 * G * B / 900),
                  5e-3);
      if (kind == "static")
        continue;
      const auto reactions = read_columns("twisted/reactions.csv");
      // Supports in the order of the file; what they exert on the ring.
      const double torque = 1e-3 * 4 * pi * G * B * 2;
      check_ratio(kind + ": torque inside over 4 pi G B h",
                  reactions.at("torque about the axis")[0] / torque,
                  5e-3);
      check_close(kind + ": torque outside over it",
                  reactions.at("torque about the axis")[1] / torque,
                  -1.,
                  5e-3);
    }
}

int main(int argc, char **argv)
{
  return run_parts(argc,
                   argv,
                   {hanging, sizes_and_places, late_and_falling, released, twisted, pressed});
}
