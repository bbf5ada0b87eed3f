// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/types.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/fem/fem_options.h>
#include <vfife/model/model.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/summary.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/reduced/body_reduction.h>
#include <vfife/reduced/pair_readings.h>
#include <vfife/reduced/reduced_options.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/reduced/resonance/nearest_wave.h>
#include <vfife/study/nearest_wave_summary.h>

#include <string>
#include <utility>

namespace vfife
{
  namespace
  {
    std::optional<NearestWave> find_wave_of_run(const Model           &model,
                                                const double           ring_rate,
                                                const DynamicsOptions &dynamics,
                                                const Communicator    &communicator)
    {
      require_reducible(model);
      const FemOptions     fem = make_fem_options(dynamics.stiffness);
      const ReducedOptions options;
      const Transmission  &t         = *model.only_transmission();
      const double         frequency = t.mesh_frequency();
      const double         cutoff =
        2. * pi *
        options.find_cutoff(frequency, ReducedOptions::rings_of_waves * ring_rate / (2. * pi));
      std::vector<ReducedBody> bodies;
      for (unsigned int b = 0; b < model.bodies.size(); ++b)
        bodies.push_back(reduce_body(model,
                                     b,
                                     {list_touch_nodes(model, b),
                                      list_readings(model, b, fem, 0),
                                      fem,
                                      model.bodies[b].rate,
                                      cutoff,
                                      options.reach},
                                     communicator));
      const ModalDamping damping{dynamics.mass_damping(), dynamics.mesh_damping};
      ReducedPair        pair(model,
                       std::move(bodies),
                       {1. / (frequency * options.steps_per_mesh), damping.modes, damping.turn});
      return find_nearest_wave(model, damping, pair);
    }
  } // namespace

  void report_nearest_wave(const NearestWave &nearest, Log &log, RunSummary &summary)
  {
    log.line("nearest resonance of a wave: ", nearest.describe());
    summary.nearest_wave = nearest.describe();
    summary.figures.push_back({figure_name::nearest_wave_speed, {nearest.speed * 30. / pi, "rpm"}});
    summary.figures.push_back({figure_name::nearest_wave_distance, {100. * nearest.distance, "%"}});
  }

  void report_nearest_wave(const std::function<std::optional<NearestWave>()> &find,
                           Log                                               &log,
                           RunSummary                                        &summary)
  {
    const auto  start = WallClock::now();
    std::string reason;
    try
      {
        if (const auto nearest = find())
          report_nearest_wave(*nearest, log, summary);
        else
          reason = "mesh orders 1 to 3 excite no wave near this speed";
      }
    catch (const InputError &error)
      {
        reason = error.what();
      }
    catch (const NumericalError &error)
      {
        reason = error.what();
      }
    if (!reason.empty())
      log.line("nearest resonance of a wave: not available, ", reason);
    log.line("  waves in contact found in ", duration_text(seconds_since(start)));
  }

  void report_nearest_wave_of_run(const Model           &model,
                                  const double           ring_rate,
                                  const DynamicsOptions &dynamics,
                                  const Communicator    &communicator,
                                  Log                   &log,
                                  RunSummary            &summary)
  {
    const Transmission &t = *model.only_transmission();
    if (!t.has_constant_rate() || t.driver_rate == 0)
      return;
    report_nearest_wave([&] { return find_wave_of_run(model, ring_rate, dynamics, communicator); },
                        log,
                        summary);
  }
} // namespace vfife
