// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Entries of sections Contact and Dynamics that files hardly ever set: each in a model of a few
// elements, of which a step or two are enough to see what the entry says.
#include "../../model_sections.h"
#include "../../parts.h"
#include "../../read_files.h"
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/body.h>

using namespace vfife;

double value_of(const nlohmann::json &figure)
{
  return figure.at("value").get<double>();
}

constexpr double depth = .01, penalty = 100, area = 64, velocity = 100;

const std::string under = model_text::block("under", {{20, 20, 4}}, {{10, 10, 1}});

/** A block of 8 x 8 mm lies @p depth deep in a larger one and slides: after no time at all the
 * pressure is penalty times depth everywhere. */
Columns run_touch(const std::string &entries, Communicator &world)
{
  const std::string text = R"(
subsection Model
  set bodies   = under, over
  set contacts = faces
)" + under + R"(  subsection Body over
    set size x   = 8
    set size y   = 8
    set size z   = 4
    set elements z = 1
    set position = 6, 6, 3.99 mm
    set velocity = 0, 100, 0 mm/s
  end
  subsection Contact faces
    set slave body        = over
    set slave surface     = z-
    set master body       = under
    set master surface    = z+
    set penalty           = 100
    set integration       = explicit
)" + entries + "  end\nend\n" +
                           model_text::one_step() + quiet_output(1);
  return run_text("touch", text, world);
}

/** Contact force at the start [N]. */
double touch(const std::string &entries, Communicator &world)
{
  return run_touch(entries, world)["contact force total"].front();
}

/** A sphere of few facets, 0.3 mm deep in a block. */
void press_sphere(Communicator &world)
{
  run_text("sphere",
           R"(
subsection Model
  set bodies   = under, ball
  set contacts = faces
)" + under + R"(  subsection Body ball
    set mesh     = sphere
    set position = 10, 10, 13.7 mm
  end
  subsection Contact faces
    set slave body        = ball
    set slave surface     = outer
    set master body       = under
    set master surface    = z+
    set penalty           = 100
    set abort penetration ratio = 1
  end
end
)" + model_text::one_step() +
             quiet_output(1),
           world);
}

/** Warnings of a run's summary with @p part. */
unsigned int count_warnings(const std::string &folder, const std::string &part)
{
  const nlohmann::json summary = read_json(folder + "/summary.json");
  unsigned int         n       = 0;
  for (const nlohmann::json &warning : summary.at("warnings"))
    n += has_text(warning.get<std::string>(), part);
  return n;
}

void contact(Communicator &world)
{
  const double force = penalty * depth * area;
  check_close("penalty times depth times area [N]", touch("", world), force, 1e-9);

  // Friction stands normal to the pressure: zero at first, then the stiffness ratio times penalty
  // times the way of a step, on the whole area, until it slides.
  check_ratio("friction coefficient: no force at first",
              touch("set friction coefficient = 0.3\n", world) / force,
              1e-12);
  for (const double ratio : {1., 0.25})
    {
      const std::string entries =
        "set friction coefficient = 0.3\nset tangential stiffness ratio = " +
        std::to_string(ratio) + "\n";
      auto         rows = run_touch(entries, world);
      const double dt   = rows["time"].at(1);
      // The block's own motion along the step is the velocity's but for some 1e-5 of it.
      check_close("tangential stiffness ratio: force along the way",
                  rows["faces contact force y"].at(1),
                  -ratio * penalty * velocity * dt * area,
                  1e-3 * ratio * penalty * velocity * dt * area);
    }
  check("a punch with coarse facets: warned of",
        count_warnings("touch", "Refine the facets to a seventh of that width") == 1);
  // A sphere of facets of 4 mm, pressed in until a few points touch.
  press_sphere(world);
  check("a contact narrower than two facets: warned of", count_warnings("sphere", "mm wide") == 1);

  // (1 - d/2)^2 over the outer facets of 2 mm, d the distance to the border: a third of the depth
  // where one side is the border, and 11/18 at corners, where d is bilinear.
  check_close("edge relief: force",
              touch("set edge relief width = 2\nset edge relief depth = 5 um\n", world),
              force - penalty * .005 * 4 * (8. / 3 + 4 * 11. / 18),
              1e-9);

  // A contact would not look there, and the bodies would pass through one another.
  std::string message = message_of([&] { touch("set contact depth limit = 5 um\n", world); });
  check("depth limit: bodies that begin deeper are refused",
        has_text(message, "at most 0.005 mm at the start") &&
          has_text(message, "0.01 mm inside body \"under\""));
  check_close("depth limit: at half of it [N]",
              touch("set contact depth limit = 20 um\nset abort penetration ratio = 0.6\n", world),
              force,
              1e-9);
  message = message_of<NumericalError>(
    [&] { touch("set contact depth limit = 20 um\nset abort penetration ratio = 0.4\n", world); });
  check("penetration limit: 0.4 of the depth limit stops the run",
        has_text(message, "10 um deep") &&
          has_text(message, "(limit 8 um, Contact/abort penetration ratio)"));
}

/** Cubes of 1 mm in a row along x, fixed at one end. */
std::string
bar(const unsigned int cells, const std::string &dynamics, const std::string &kind = "run")
{
  using namespace model_text;
  return study(kind) +
         section("Model",
                 "set bodies = bar\nset constraints = foot\nset loads = pull\nset probes = tip\n" +
                   block("bar", {{double(cells), 1, 1}}, {{cells, 1, 1}}) +
                   section("Constraint foot", "set nodes = x-\n") +
                   section("Load pull", "set nodes = x+\nset force = 10, 0, 0\n") +
                   probe("tip", std::to_string(cells) + ", 0, 0")) +
         no_contraction() + (kind == "run" ? one_step(dynamics) : section("Dynamics", dynamics)) +
         quiet_output(1);
}

nlohmann::json run_bar(const unsigned int cells, const std::string &dynamics, Communicator &world)
{
  run_text("bar", bar(cells, "  set time step factor = 1\n" + dynamics), world);
  return read_json("bar/summary.json");
}

double step_of(const nlohmann::json &summary)
{
  return value_of(summary.at("run").at("step"));
}

void step(Communicator &world)
{
  const std::string    bound = "  set time step estimate = element\n";
  const nlohmann::json plain = run_bar(8, bound, world);
  const double         dt    = step_of(plain);
  const auto           mass  = [](const nlohmann::json &summary, const char *name) {
    return value_of(summary.at("mesh").at("bodies")[0].at(name));
  };
  // All elements are alike, so a step 1.2 times as large takes 1.44 times their masses.
  const std::string scaled =
    bound + "  set mass scaling step = " + std::to_string(1.2e9 * dt) + " ns\n";
  const auto heavy = run_bar(8, scaled + "  set maximum added mass = 0.45\n", world);
  check_close("mass scaling step: the step", step_of(heavy) / dt, 1.2, 1e-6);
  check_close("mass scaling step: added mass over mass",
              mass(heavy, "added mass") / mass(plain, "mass"),
              .44,
              1e-5);
  check_close("mass scaling step: mass", mass(heavy, "mass") / mass(plain, "mass"), 1.44, 1e-5);
  check("largest added mass: more is refused",
        has_text(message_of(
                   [&] { run_bar(8, scaled + "  set maximum added mass = 0.43\n", world); }),
                 "the limit is 43 %"));

  // In a row of cubes all elements can stretch in turn with their highest frequency, 2 c/h.
  check_ratio("step of cubes over h/c", dt / std::sqrt(7.85e-9 / 206000), 1e-5);
  const nlohmann::json row = run_bar(8, "  set time step estimate = global\n", world);
  check_ratio("step bound: the same for a row of cubes", step_of(row) / dt, .01);
}

/** Displacement and steps of a static bar under 10 N. */
void relaxation(Communicator &world)
{
  // The lowest frequency of a bar fixed at one end, of 8 cubes: 2 (c/h) sin(pi/(4 n)).
  const double rate  = 2 * std::sqrt(206000 / 7.85e-9) * std::sin(pi / 32);
  const auto   solve = [&](const double part) {
    const std::string entries = "  subsection Relaxation\n    set tolerance = 1e-7\n"
                                  "    set virtual damping = " +
                                std::to_string(part * rate) + " 1/s\n  end\n";
    auto columns = run_text("relaxed", bar(8, entries, "static"), world);
    check_ratio("virtual damping: displacement over F L/(E A)",
                columns["tip displacement x"].back() / (10. * 8 / 206000),
                1e-4);
    return read_json("relaxed/summary.json").at("run").at("steps").get<double>();
  };
  // Strongly damped, what is left falls as exp(-rate^2/zeta t): at zeta = 20 and 40 rates twice
  // as many steps.
  const double critical = solve(2.), strong = solve(20.), stronger = solve(40.);
  check("virtual damping: the critical one is faster", critical < .3 * strong);
  check_close("virtual damping: steps over those of half of it", stronger / strong, 2., .05);
}

/** A ring of one row that is led around its axis, with v = omega r + c r^3 at its start. */
void damping_rate(Communicator &world)
{
  constexpr double omega = 100, c = .1, zeta = 2000;
  const Body       ring("ring", make_ring(20., 30., 5., {{1, 24, 1}}), Material());
  double           m[5] = {0, 0, 0, 0, 0}; // sums of m r^k
  for (unsigned int i = 0; i < ring.n_nodes(); ++i)
    for (unsigned int k = 0; k < 5; ++k)
      m[k] += ring.node_masses()[i] * std::pow(ring.node_positions()[i].head<2>().norm(), k);
  const double momentum = omega + c * m[4] / m[2], mean_speed = omega + c * m[2] / m[0];

  for (const bool is_mean : {false, true})
    {
      run_text("damped",
               "subsection Model\n  set bodies = ring\n  set constraints = across\n"
               "  subsection Constraint across\n    set nodes = all\n"
               "    set kind = displacement\n    set directions = r, z\n  end\n" +
                 model_text::ring("ring", {{20, 30, 5}}, {{1, 24, 1}}, R"(
    set rotating     = yes
    set rotational speed = 100 rad/s
    set initial velocity x = -0.1*y*(x^2 + y^2)
    set initial velocity y = 0.1*x*(x^2 + y^2)
)") + "end\n" +
                 model_text::one_step(std::string("set mass proportional damping = 2000\n"
                                                  "set time step factor = 0.01\n"
                                                  "set damping reference = ") +
                                      (is_mean ? "mean speed\n" : "momentum\n")) +
                 quiet_output(1),
               world);
      const nlohmann::json audit = read_json("damped/summary.json").at("damping audit")[0];
      const std::string    name  = is_mean ? "mean speed: " : "momentum: ";
      check_close(name + "less the momentum rate [rpm]",
                  value_of(audit.at("mean speed rate minus momentum rate")),
                  (mean_speed - momentum) * 30 / pi,
                  1e-3 * std::abs(mean_speed - momentum));
      // -zeta sum m r (v - rate r) = -zeta I (momentum rate - rate), in N m
      const double torque = 1e-3 * zeta * m[2] * (mean_speed - momentum);
      check_close(name + "torque of the damper over the mean speed's",
                  value_of(audit.at("net torque")) / torque,
                  is_mean ? 1. : 0.,
                  1e-3);
    }
}

/** A sphere of a few elements of different sizes, twisted out of its plane for 10 us. */
std::string ball(const std::string &dynamics)
{
  return R"(
subsection Model
  set bodies = ball
  subsection Body ball
    set mesh               = sphere
    set radius             = 10
    set core elements      = 2
    set radial elements    = 1
    set initial velocity z = 1000*x*y
  end
end
subsection Dynamics
  set end time = 10 us
)" + dynamics +
         "end\n" + quiet_output(1);
}

void unequal_elements(Communicator &world)
{
  // The elements beside the worst one do not give way as a free element does.
  run_text("ball", ball("  set time step estimate = element\n"), world);
  const double by_element = step_of(read_json("ball/summary.json"));
  auto         history    = run_text("ball", ball("  set time step estimate = global\n"), world);
  check("step bound: much larger where elements differ",
        step_of(read_json("ball/summary.json")) > 1.3 * by_element);
  check_below("step bound: and the run is stable", history["energy error"].back(), .02);

  const auto exact = run_text("ball", ball("  set stiffness data = double\n"), world),
             rough = run_text("ball", ball("  set stiffness data = single\n"), world);
  double largest = 0, difference = 0;
  for (std::size_t i = 0; i < exact.at("time").size(); ++i)
    {
      const double energy = exact.at("strain energy")[i];
      raise_to(largest, energy);
      raise_to(difference, std::abs(energy - rough.at("strain energy")[i]));
    }
  // 24 bits of the hourglass stiffness, which carries part of this motion.
  check_below("stiffness data: difference of single precision", difference / largest, 1e-7);
  check("stiffness data: there is one", difference / largest > 1e-12);
}

/** 80 us with a sample in the last hundredth of the run, and with the last one a fifth before its
 * end. */
void last_sample(Communicator &world)
{
  const std::string bars = tree_folder() + "/prm/verification/two_bars.prm",
                    text = "Output/steps per sample: the last sample is at ";
  const auto say         = [&](const unsigned int steps) {
    return check_case(bars, world, {"Output/steps per sample=" + std::to_string(steps)});
  };
  check("last sample near the end", !has_text(say(1), text));
  const std::string said = say(1), count = "the run has ";
  const int         n_steps = std::stoi(said.substr(said.find(count) + count.size()));
  check("last sample at 80 % of the run",
        has_text(say(n_steps * 4 / 5), text) && has_text(say(n_steps * 4 / 5), "ends at 0.08 ms"));
  check("one sample at the end", !has_text(say(n_steps), text));
}

int main(int argc, char **argv)
{
  return run_parts(argc,
                   argv,
                   {contact, step, relaxation, damping_rate, unequal_elements, last_sample});
}
