// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Measured flanks: the grid of points that is written and read again as topography or as a measured
// flank, and the machine settings that are found from it, for flanks cut with known settings.
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"
#include "paper_pair.h"

#include <vfife/gear/measurement/measuring_grid.h>
#include <vfife/gear/measurement/settings_fit.h>

#include <fstream>

using namespace vfife;

constexpr double um = 1e-3;

std::vector<Vector3> points_of(const Table &table)
{
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    points.emplace_back(table.numbers("x")[i], table.numbers("y")[i], table.numbers("z")[i]);
  return points;
}

template <typename Reads>
void refuse(const std::string &name, const Reads &reads)
{
  std::cout << name << ": ";
  print_refusal(reads);
}

void write(const std::string &file, const Table &table)
{
  std::ofstream out(file);
  table.write_csv(out);
}

/** A grid of a flank with errors is the topography of one without. */
void grids()
{
  GearPairOptions options                    = paper::options();
  options.gear_errors.convex.terms           = {4. * um, -6. * um, 3. * um, 7. * um, 5. * um};
  options.gear_errors.convex.pitch_amplitude = 9. * um;
  const GearPair      pair(options);
  const MeasuringGrid grid;
  const Table         table = compute_measuring_grid(pair.gear(), FlankSide::convex, 3, grid);
  check("points of the grid", table.n_rows() == 45);
  // position and deviation say the same, the normal leaves the metal
  double off = 0., place = 0.;
  for (std::size_t i = 0; i < 45; ++i)
    {
      const double       L = table.numbers("L")[i], h = table.numbers("h")[i];
      const SurfacePoint point = pair.gear().flank_point(FlankSide::convex, L, h);
      const Vector3      normal(table.numbers("normal x")[i],
                           table.numbers("normal y")[i],
                           table.numbers("normal z")[i]);
      off = largest_of(
        {off,
         (points_of(table)[i] - point.position - table.numbers("deviation")[i] * um * normal)
           .norm(),
         (normal + point.normal).norm()});
      const Vector2 u_v = FlankArea(pair.gear(), FlankSide::convex, {.1, .1}).place_of({L, h});
      raise_to(place,
               (u_v - Vector2((table.numbers("column")[i] - 1.) / 8.,
                              1. - (table.numbers("row")[i] - 1.) / 4.))
                 .norm());
    }
  check_below("positions, deviations, normals", off, 1e-12);
  check_below("tip first, toe first", place, 1e-9);

  write("own_grid.csv", table);
  GearPairOptions again               = paper::options();
  again.gear_errors.convex.topography = "own_grid.csv";
  const GearPair read(again);
  double         between = 0.;
  for (double u = .12; u < .9; u += .07)
    for (double v = .12; v < .9; v += .07)
      {
        const Vector2      L_h   = FlankArea(pair.gear(), FlankSide::convex).point_at({u, v});
        const SurfacePoint point = pair.gear().flank_point(FlankSide::convex, L_h[0], L_h[1]);
        raise_to(between,
                 std::abs(pair.gear().deviation(FlankSide::convex, 3, point) -
                          read.gear().deviation(FlankSide::convex, 50, point)));
      }
  // the terms are parabolas; what a turn does along the normal is nearly one
  check_below("read again as a topography [um]", between / um, .01);

  std::ofstream("five.csv") << "5, 5, 5\n5, 5, 5\n";
  const auto measured =
    read_measured_points("five.csv", read.gear(), FlankSide::concave, MeasuringGrid());
  const Vector2 corner    = FlankArea(read.gear(), FlankSide::concave, {.1, .1}).point_at({1., 0.});
  const SurfacePoint last = read.gear().flank_point(FlankSide::concave, corner[0], corner[1]);
  check("numbers alone: points", measured.size() == 6);
  check_below("numbers alone: the last one is the root's at the heel [mm]",
              (measured.back() - (last.position - 5. * um * last.normal)).norm(),
              1e-9);
  std::ofstream("reversed.csv") << "row,column,h [mm],deviation [um]\n"
                                   "1,1,2,0\n1,2,2,0\n2,1,6,0\n2,2,6,0\n";
  const std::string refusal = message_of([&] {
    read_measured_points("reversed.csv", read.gear(), FlankSide::concave, MeasuringGrid());
  });
  check("a grid from root to tip is refused", has_text(refusal, "rows go from tip to root"));
  write("points.csv", table);
  check_below("positions from a table [mm]",
              (read_measured_points("points.csv", read.gear(), FlankSide::convex, grid)[7] -
               points_of(table)[7])
                .norm(),
              1e-12);
  // The other flank is half a tooth and more away about the axis; so is the next tooth.
  const auto refusal_for = [&](const FlankSide side) {
    return message_of([&] { read_measured_points("points.csv", read.gear(), side, grid); });
  };
  check("points of the other flank are refused",
        has_text(refusal_for(FlankSide::concave),
                 "points.csv: expected points of the concave flank of tooth 0, got ("));
  std::ofstream next("next.csv");
  next << "x [mm],y [mm],z [mm]\n";
  const Vector3 x =
    rotation_about(Vector3::UnitZ(), read.gear().pitch()) * Vector3(points_of(table)[7]);
  next << x[0] << "," << x[1] << "," << x[2] << "\n";
  next.close();
  check("points of the next tooth are refused",
        has_text(message_of(
                   [&] { read_measured_points("next.csv", read.gear(), FlankSide::convex, grid); }),
                 "mm, 4.5"));
}

/** The paper's pair with other settings of the pinion's concave flank. */
GearPairOptions changed()
{
  GearPairOptions  options  = paper::options();
  MachineSettings &settings = options.pinion.concave;
  settings.radial_distance += .08;
  settings.blade_angle += .05 * degree;
  settings.sliding_base -= .04;
  settings.blank_offset += .06;
  return options;
}

void settings()
{
  const GearPair  pair(paper::options()), other(changed());
  const FlankSide side = FlankSide::concave;
  const Table     grid = compute_measuring_grid(other.pinion(), side, 0, MeasuringGrid());
  // The same number of unknowns as were changed; the ratio of roll follows from the others.
  const std::vector<std::string> some = {
    "radial distance", "blade angle", "sliding base", "blank offset", "ratio of roll"};
  const SettingsFitResult found =
    SettingsFit(pair.pinion(), side, some, false, 1e-8, points_of(grid)).solve();
  check("changed settings: the flank was far away", largest_size(found.before) > 50. * um);
  check_below("changed settings: the flank [um]", largest_size(found.after) / um, 1e-3);
  const MachineSettings is  = other.pinion().generated_flank(side).settings();
  const MachineSettings was = pair.pinion().generated_flank(side).settings();
  for (const FittedSetting &setting : fitted_settings())
    check_below("changed settings: " + setting.name + " over what counts",
                (found.settings.*setting.value - is.*setting.value) / setting.scale,
                1e-3);
  check("they differ", std::abs(is.ratio_of_roll - was.ratio_of_roll) > 1e-4);

  // All at once: not all can be told, the flank is found all the same.
  std::vector<std::string> all;
  for (const FittedSetting &setting : fitted_settings())
    all.push_back(setting.name);
  const SettingsFitResult every =
    SettingsFit(pair.pinion(), side, all, true, 1e-5, points_of(grid)).solve();
  check_below("all settings: the flank [um]", largest_size(every.after) / um, 1.);
  check("all settings: some cannot be told", every.directions < all.size() + 1);

  // Limits of the changes: the blank offset, which is 0.06 mm off, stops at its limit, and what
  // is reached is the best within it.
  const std::vector<double> limits = {1., 1. * degree, 1., .02, .1};
  const SettingsFitResult   limited =
    SettingsFit(pair.pinion(), side, some, false, 1e-8, points_of(grid), limits).solve();
  check_close("limited changes: blank offset [mm]",
              std::abs(limited.settings.blank_offset - was.blank_offset),
              .02,
              1e-9);
  check("limited changes: it is named, and the search comes to rest",
        limited.at_limit == std::vector<std::string>{"blank offset"} && limited.unfinished.empty());
  check("limited changes: better than before, not as good as without limits",
        largest_size(limited.after) < largest_size(limited.before) &&
          largest_size(limited.after) > largest_size(found.after));

  // A turn alone: the gear's flank with pitch deviation F at its mean radius.
  GearPairOptions options                    = paper::options();
  options.gear_errors.convex.pitch_amplitude = 12. * um;
  const GearPair          pitch(options);
  const double            r = 116.49 * std::sin(pitch.gear().blank().pitch_angle);
  const SettingsFitResult turned =
    SettingsFit(pitch.gear(),
                FlankSide::convex,
                {"blade angle", "radial distance"},
                true,
                1e-5,
                points_of(
                  compute_measuring_grid(pitch.gear(), FlankSide::convex, 0, MeasuringGrid())))
      .solve();
  const double sense = pitch.gear().lower_side() == FlankSide::convex ? -1. : 1.;
  check_close("a turned flank: its turn [um]", turned.turn * r / um, sense * 12., 1e-3);
  check_below("a turned flank: radial distance [mm]",
              turned.settings.radial_distance - 107.42,
              1e-5);

  refuse("unknown setting", [&]() {
    SettingsFit(pair.pinion(), side, {"radial distanc"}, true, 1e-5, points_of(grid));
  });
  refuse("few points",
         [&]() { SettingsFit(pair.pinion(), side, some, true, 1e-5, {Vector3(1., 2., 3.)}); });
  refuse("points elsewhere", [&]() {
    SettingsFit(pair.pinion(), side, {"radial distance"}, false, 1e-5, {Vector3(0., 0., -500.)})
      .solve();
  });
}

int main()
{
  return run_parts({grids, settings});
}
