// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/column_names.h>
#include <vfife/lumped/speed_sweep.h>

namespace vfife
{
  namespace
  {
    const Choices<SweepKind> sweep_kinds = {{"none", SweepKind::none},
                                            {"up", SweepKind::up},
                                            {"up and down", SweepKind::up_and_down}};
  } // namespace

  void SpeedSweepOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_choice(prm,
                   "sweep",
                   kind,
                   sweep_kinds,
                   "Speed sweep: none, rising speeds, or rising and then falling speeds");
    declare_quantity(prm,
                     "lowest speed",
                     lowest_speed,
                     "rpm",
                     "Lowest pinion speed of the sweep",
                     Range::not_negative());
    declare_quantity(prm,
                     "highest speed",
                     highest_speed,
                     "rpm",
                     "Highest pinion speed of the sweep",
                     Range::not_negative());
    declare_integer(
      prm, "speeds", n_speeds, "Number of equally spaced speeds in the sweep", 2, 100000);
  }

  void SpeedSweepOptions::check(const std::string &section) const
  {
    if (kind != SweepKind::none && !(lowest_speed > 0 && highest_speed > lowest_speed))
      throw InputError(section + "/lowest speed", "must be positive and below highest speed");
  }

  Table make_resonance_response_table()
  {
    return {{column::direction},
            {column::speed, "rpm"},
            {column::mesh_frequency, "Hz"},
            {column::mean_dte, "arcsec"},
            {"rms dte", "arcsec"},
            {column::peak_to_peak_dte, "arcsec"},
            {column::mean_force, "N"},
            {"rms force", "N"},
            {column::peak_to_peak_force, "N"},
            {column::largest_force, "N"},
            {"losses of contact", "-"},
            {column::time_without_contact, "-"},
            {"time on coast flanks", "-"},
            {column::energy_error, "-"}};
  }

  void add_response(const std::string    &direction,
                    const double          speed,
                    const unsigned int    teeth,
                    const LumpedResponse &response,
                    Table                &table)
  {
    table.add_row({direction,
                   speed * 30 / pi,
                   speed * teeth / (2 * pi),
                   response.mean_error / arcsecond,
                   response.rms_error / arcsecond,
                   response.pp_error / arcsecond,
                   response.mean_force,
                   response.rms_force,
                   response.pp_force,
                   response.largest_force,
                   response.losses,
                   response.time_apart,
                   response.time_coast,
                   response.energy_error});
  }

  std::vector<double> list_speeds(const SpeedSweepOptions &options, const bool upwards)
  {
    std::vector<double> speeds;
    for (unsigned int i = 0; i < options.n_speeds; ++i)
      {
        const unsigned int place = upwards ? i : options.n_speeds - 1 - i;
        speeds.push_back(options.lowest_speed + place *
                                                  (options.highest_speed - options.lowest_speed) /
                                                  (options.n_speeds - 1));
      }
    return speeds;
  }

  void sweep_speeds(const LumpedModel       &model,
                    const LumpedRunOptions  &run,
                    const SpeedSweepOptions &options,
                    Table                   &table)
  {
    if (options.kind == SweepKind::none)
      return;
    // One solver for both passes: it keeps the motion from speed to speed, also where the
    // sweep turns round.
    LumpedSolver solver(model, run);
    const auto   pass = [&](const std::string &direction) {
      for (const double speed : list_speeds(options, direction == "up"))
        add_response(direction,
                     speed,
                     model.pair().driver_teeth,
                     solver.run(speed * model.pair().driver_teeth / (2 * pi)),
                     table);
    };
    pass("up");
    if (options.kind == SweepKind::up_and_down)
      pass("down");
  }
} // namespace vfife
