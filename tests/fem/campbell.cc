// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Campbell diagrams of made-up vibrations: what is a branch, where straight branches cross the
// orders of the gear mesh (closed form), the units of the tables.
#include "../parts.h"
#include "../tests.h"

#include <vfife/fem/modes/campbell.h>

using namespace vfife;

constexpr unsigned int teeth = 10;

// Waves with the spin lose, waves against it gain: frequencies in turning axes [Hz] at a rate
// [rad/s].
double slower(const double f, const double rate)
{
  return f - .02 * std::abs(rate);
}
double faster(const double f, const double rate)
{
  return f + .03 * std::abs(rate);
}

RotatingMode
mode(const int diameter, const bool is_pair, const double forward, const double frequency)
{
  RotatingMode result;
  result.frequency                  = frequency;
  result.description.nodal_diameter = diameter;
  result.description.is_pair        = is_pair;
  result.description.forward        = forward;
  return result;
}

/** One umbrella and two pairs of two diameters, which part at speed if @p split. */
std::vector<ModesAtSpeed> made_up_modes(const bool split)
{
  std::vector<ModesAtSpeed> speeds;
  for (const double rate : {0., -500., -1000.})
    {
      ModesAtSpeed at_speed;
      at_speed.rate = rate;
      at_speed.modes.push_back(mode(0, false, .5, 0.)); // the free hub
      at_speed.modes.push_back(mode(0, false, .5, 300.));
      for (const double f : {500., 900.})
        if (split && rate != 0)
          {
            at_speed.modes.push_back(mode(2, true, .98, slower(f, rate)));
            at_speed.modes.push_back(mode(2, true, .03, faster(f, rate)));
          }
        else
          {
            at_speed.modes.push_back(mode(2, true, .6, f));
            at_speed.modes.push_back(mode(2, true, .4, f));
          }
      speeds.push_back(at_speed);
    }
  return speeds;
}

void branches()
{
  const std::vector<double> rates        = {0., -500., -1000.};
  const auto                check_branch = [&rates](const std::string                 &name,
                                     const std::vector<CampbellBranch> &list,
                                     const CampbellBranch              &expected) {
    unsigned int found = 0;
    for (const CampbellBranch &branch : list)
      found += branch.nodal_diameter == expected.nodal_diameter && branch.order == expected.order &&
               branch.direction == expected.direction && branch.rates == rates &&
               branch.frequencies == expected.frequencies;
    check(name, found == 1);
  };
  const auto split = make_branches(made_up_modes(true));
  check("split: five branches, the free hub is none", split.size() == 5);
  check_branch("split: umbrella", split, {0, 1, "standing", {}, {300., 300., 300.}});
  for (const unsigned int order : {1u, 2u})
    {
      const double f = order == 1 ? 500. : 900.;
      check_branch("split: forward",
                   split,
                   {2, order, "forward", {}, {f, slower(f, 500.), slower(f, 1000.)}});
      check_branch("split: backward",
                   split,
                   {2, order, "backward", {}, {f, faster(f, 500.), faster(f, 1000.)}});
    }
  // Both lowest forward waves slow down to nothing and are overtaken, one after the other: their
  // branches go on below zero, beside the backward ones.
  const auto two_waves = [](const double rate, const double first, const double second) {
    ModesAtSpeed at_speed;
    at_speed.rate = rate;
    for (const double f : {first, second})
      {
        // Overtaken, it runs against the spin and the energy in turning axes is negative.
        at_speed.modes.push_back(mode(1, true, f > 0 ? .97 : .02, std::abs(f)));
        at_speed.modes.back().kinetic_share = f > 0 ? .6 : -.4;
        at_speed.modes.push_back(mode(1, true, .01, 100. + std::abs(rate)));
      }
    return at_speed;
  };
  const std::vector<CampbellBranch> overtaken = make_branches(
    {two_waves(0., 30., 50.), two_waves(-500., -10., 10.), two_waves(-1000., -50., -30.)});
  check("overtaken: four branches", overtaken.size() == 4);
  check_branch("overtaken: first forward", overtaken, {1, 1, "forward", {}, {30., -10., -50.}});
  check_branch("overtaken: second forward", overtaken, {1, 2, "forward", {}, {50., 10., -30.}});
  check_branch("overtaken: backward", overtaken, {1, 1, "backward", {}, {100., 600., 1100.}});
  Table critical = make_resonance_table();
  add_resonances("rotor", overtaken, teeth, 0, not_known, critical);
  std::vector<double> at;
  for (std::size_t i = 0; i < critical.n_rows(); ++i)
    if (critical.column("excitation").texts[i] == "unbalance")
      {
        at.push_back(critical.numbers("speed")[i] * 2. * pi / 60.);
        check("overtaken: unbalance has no order and stands still in the body",
              critical.column("wave").texts[i] == "forward" &&
                std::isnan(critical.numbers("mesh order")[i]) &&
                critical.numbers("frequency")[i] == 0.);
      }
  check("overtaken: two critical speeds", at.size() == 2);
  check_close("overtaken: first critical speed [rad/s]", at.at(0), -375., 1e-10);
  check_close("overtaken: second critical speed [rad/s]", at.at(1), -625., 1e-10);

  const auto whole = make_branches(made_up_modes(false));
  check("not split: three branches", whole.size() == 3);
  for (const unsigned int order : {1u, 2u})
    {
      const double f = order == 1 ? 500. : 900.;
      check_branch("not split: a branch a pair", whole, {2, order, "standing", {}, {f, f, f}});
    }

  Table points = make_campbell_table();
  add_branches("gear", {{2, 3, "forward", {0., -50.}, {500., 480.}}}, points);
  check("points of a branch: what it is",
        points.n_rows() == 2 && points.column("body").texts[1] == "gear" &&
          points.column("direction").texts[1] == "forward" &&
          points.numbers("nodal diameter")[1] == 2 && points.numbers("order")[1] == 3 &&
          points.numbers("frequency")[1] == 480.);
  check_close("points of a branch: speed [rpm]",
              points.numbers("speed")[1],
              -50. * 60. / (2. * pi),
              1e-10);
}

void mode_table()
{
  ModesAtSpeed at_speed;
  at_speed.rate       = 200.;
  at_speed.axis_point = Vector3(7., 8., 9.);
  at_speed.modes.push_back(mode(3, true, .9, 700.));
  at_speed.modes.push_back(mode(3, true, .1, 800.));
  RotatingMode &first  = at_speed.modes[0];
  first.residual       = 1e-7;
  first.kinetic_share  = .6;
  first.effective_mass = {{1., 2., 3., 4., 5., 6.}};
  ModeDescription &d   = first.description;
  d.nodal_circles      = 1;
  d.share              = .97;
  d.axial              = .5;
  d.radial             = .3;
  d.tangential         = .2;
  Table table          = make_mode_table();
  add_modes("gear", at_speed, 20., table);
  const auto value = [&table](const char *name) { return table.numbers(name)[0]; };
  check("modes: numbered from one", value("mode") == 1 && table.numbers("mode")[1] == 2);
  check_close("modes: speed [rpm]", value("speed"), 200. * 60. / (2. * pi), 1e-10);
  check("modes: each number in its column",
        value("frequency") == 700. && value("residual") == 1e-7 && value("nodal diameter") == 3 &&
          value("nodal circles") == 1 && value("share of the diameter") == .97 &&
          value("axial") == .5 && value("radial") == .3 && value("tangential") == .2);
  check("modes: directions",
        table.column("direction").texts == std::vector<std::string>({"forward", "backward"}));
  check_close("modes: damping ratio, zeta T/(T + U) over omega",
              value("damping ratio"),
              20. * .6 / (2. * pi * 700.),
              1e-15);
  // t -> kg, t mm^2 -> kg mm^2
  for (unsigned int c = 0; c < 3; ++c)
    {
      const std::string axis = std::string(1, "xyz"[c]);
      check_close("modes: effective mass [kg]",
                  value(("effective mass " + axis).c_str()),
                  1e3 * (1 + c),
                  1e-9);
      check_close("modes: effective inertia [kg mm^2]",
                  value(("effective inertia " + axis).c_str()),
                  1e3 * (4 + c),
                  1e-9);
      check("modes: about the axis' point [mm]",
            value(("axis point " + axis).c_str()) == at_speed.axis_point[c]);
    }
}

/** A force of so many multiples of the speed, as the turning body feels it. */
struct Met
{
  std::string  wave;
  unsigned int mesh_order;
  double       multiple;
};

/**
 * The branch f = f0 + slope |Omega|/(2 pi) meets k |Omega|/(2 pi) at |Omega| = 2 pi f0/(k -
 * slope), with the frequency k f0/(k - slope): straight lines, which interpolation leaves as they
 * are.
 */
void check_line(const std::string      &direction,
                const int               diameter,
                const std::vector<Met> &expected,
                const double            sense = 1.)
{
  const double f0 = 400., slope = direction == "forward" ? -.4 : direction == "backward" ? .7 : 0.;
  CampbellBranch branch;
  branch.nodal_diameter = diameter;
  branch.order          = 4;
  branch.direction      = direction;
  for (const double rate : {0., 30., 400., 1000., 2600.})
    {
      branch.rates.push_back(sense * rate);
      branch.frequencies.push_back(f0 + slope * rate / (2 * pi));
    }
  Table table = make_resonance_table();
  add_resonances("gear", {branch}, teeth, 2, 2.5, table);
  const std::string name = direction + ", " + std::to_string(diameter) + " diameters: ";
  check(name + "number of crossings", table.n_rows() == expected.size());
  for (std::size_t i = 0; i < std::min(expected.size(), table.n_rows()); ++i)
    {
      const double k = expected[i].multiple;
      check(name + "which they are",
            table.column("body").texts[i] == "gear" &&
              table.column("wave").texts[i] == expected[i].wave &&
              table.numbers("mesh order")[i] == expected[i].mesh_order &&
              table.numbers("nodal diameter")[i] == diameter && table.numbers("order")[i] == 4);
      check_ratio(name + "speed [rpm]",
                  table.numbers("speed")[i] / (sense * 60. * f0 / (k - slope)),
                  1e-13);
      check_ratio(name + "speed of the pinion [rpm]",
                  table.numbers("pinion speed")[i] / (2.5 * 60. * f0 / (k - slope)),
                  1e-13);
      check_ratio(name + "frequency [Hz]",
                  table.numbers("frequency")[i] / (k * f0 / (k - slope)),
                  1e-13);
    }
}

void crossings()
{
  // 10 teeth, h diameters: a wave against the spin at 10 m + h times the speed, one with it at 10
  // m - h; the constant load (m = 0) stands in space and runs against the spin.
  const std::string f = "forward", b = "backward", s = "standing";
  check_line(f, 2, {{f, 1, 8.}, {f, 2, 18.}});
  check_line(b, 2, {{b, 0, 2.}, {b, 1, 12.}, {b, 2, 22.}});
  check_line(s, 2, {{b, 0, 2.}, {b, 1, 12.}, {f, 1, 8.}, {b, 2, 22.}, {f, 2, 18.}});
  check_line(s, 0, {{s, 1, 10.}, {s, 2, 20.}});
  // More waves than teeth: both of the first order run against the spin.
  check_line(b, 13, {{b, 0, 13.}, {b, 1, 23.}, {b, 1, 3.}, {b, 2, 33.}});
  check_line(f, 13, {{f, 2, 7.}});
  // As many waves as teeth: one stands still in the body, and excites nothing.
  check_line(b, 10, {{b, 0, 10.}, {b, 1, 20.}, {b, 2, 30.}});
  check_line(f, 10, {{f, 2, 10.}});
  check_line(s, -1, {});
  // Turning the other way, speeds are negative.
  check_line(b, 2, {{b, 0, 2.}, {b, 1, 12.}, {b, 2, 22.}}, -1.);

  // There and back: 8 times 0, 10, 20 turns a second against 40, 60 and 300 Hz. Between the first
  // speeds excesses of 40 and -20 Hz meet at 2/3, between the others -20 and 140 Hz at 1/8.
  const CampbellBranch bent  = {2, 1, f, {0., 20. * pi, 40. * pi}, {40., 60., 300.}};
  Table                table = make_resonance_table();
  add_resonances("gear", {bent}, teeth, 1, 1., table);
  check("bent branch: two crossings", table.n_rows() == 2);
  check_close("bent branch: first [rpm]", table.numbers("speed")[0], 400., 1e-10);
  check_close("bent branch: first [Hz]", table.numbers("frequency")[0], 160. / 3., 1e-11);
  check_close("bent branch: second [rpm]", table.numbers("speed")[1], 675., 1e-10);
  check_close("bent branch: second [Hz]", table.numbers("frequency")[1], 90., 1e-11);
}

int main()
{
  return run_parts({branches, mode_table, crossings});
}
