// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/run_signals.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/types.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/summary.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/study/reduced/pair_speed_sweep.h>
#include <vfife/study/reduced/speed_ranges.h>
#include <vfife/study/reduced/speed_sweep_files.h>

namespace vfife
{
  namespace
  {
    void stop_if_asked(const RunSignals     &signals,
                       const PairSpeedSweep &sweep,
                       const Communicator   &communicator)
    {
      std::vector<double> signal = {static_cast<double>(signals.stop_signal())};
      communicator.max(signal);
      if (signal[0] > 0)
        throw Interrupted("stopped on request after " + std::to_string(sweep.resonance().n_rows()) +
                          " speeds (resonance.csv). To continue, start a sweep at the next speed");
    }

    NamedFigures list_figures(const PairSpeedSweepSetup &setup, const Table &resonance)
    {
      constexpr double rpm = 30. / pi;
      return {{"cut-off frequency", {setup.cutoff, "Hz"}},
              {"highest frequency of what is stated", {setup.highest_frequency(), "Hz"}},
              {"speeds", {double(resonance.n_rows()), "-"}},
              {figure_name::lowest_speed, {rpm * setup.speeds.lowest_speed, "rpm"}},
              {figure_name::highest_speed, {rpm * setup.speeds.highest_speed, "rpm"}},
              {figure_name::counted_meshes, {double(setup.reduced.counted_meshes), "-"}}};
    }

    /** Warns of speeds whose energies do not balance. */
    void judge_energy(const Table &resonance, Log &log)
    {
      const std::vector<double> &errors = resonance.numbers(column::energy_error);
      std::size_t                worst = 0, n_above = 0;
      for (std::size_t i = 0; i < errors.size(); ++i)
        {
          n_above += errors[i] > largest_energy_error ? 1 : 0;
          worst = errors[i] > errors[worst] ? i : worst;
        }
      if (n_above > 0)
        log.warning("the energy error exceeds ",
                    1e2 * largest_energy_error,
                    " % at ",
                    n_above,
                    " of ",
                    errors.size(),
                    " speeds, with the largest value at ",
                    resonance.numbers(column::speed)[worst],
                    " rpm: ",
                    1e2 * errors[worst],
                    " %. Increase Reduced/steps per mesh cycle, Reduced/steps per mode");
    }
  } // namespace

  void run_speed_sweep(PairSpeedSweep &sweep, RunSummary &summary, OutputFolder &folder, Log &log)
  {
    const auto start = WallClock::now();
    RunSignals signals;
    const auto write = [&]() {
      write_csv(folder, "resonance.csv", sweep.resonance());
      write_csv(folder, "wave_response.csv", sweep.waves());
      write_csv(folder, "stress_response.csv", sweep.stresses());
      stop_if_asked(signals, sweep, folder.communicator());
    };
    try
      {
        sweep.run(write, log);
      }
    catch (const NumericalError &error)
      {
        summary.fail(error.what());
      }
    const PairSpeedSweepSetup &setup = sweep.setup();
    if (setup.options.allowed_amplification > 0)
      {
        Table exceedances = make_exceedance_table();
        add_exceedances(sweep.resonance(),
                        sweep.stresses(),
                        setup.options.allowed_amplification,
                        exceedances);
        write_csv(folder, "exceedances.csv", exceedances);
      }
    summary.run_time = seconds_since(start);
    summary.time     = sweep.time();
    summary.steps    = sweep.n_steps();
    for (const auto &figure : list_figures(setup, sweep.resonance()))
      summary.figures.push_back(figure);
    sweep.near_cutoff().tell(summary.figures, log);
    judge_energy(sweep.resonance(), log);
    // All samples have been looked at.
    write_edge_contact(setup.edges, make_swept_teeth_table(), column::position, 1., folder, log);
    write_summary(folder, summary, log);
    if (summary.status == "failed")
      throw NumericalError(summary.failure);
    log.line(sweep.resonance().n_rows(), " speeds in ", duration_text(summary.run_time));
  }
} // namespace vfife
