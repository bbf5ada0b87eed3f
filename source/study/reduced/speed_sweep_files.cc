// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/run_signals.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/study/reduced/pair_speed_sweep.h>
#include <vfife/study/reduced/speed_ranges.h>
#include <vfife/study/reduced/speed_sweep_files.h>
#include <vfife/study/start_summary.h>

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
        throw Interrupted("stopped as asked after " + std::to_string(sweep.resonance().n_rows()) +
                          " speeds, which resonance.csv has; a sweep does not go on, but may "
                          "begin at the next speed");
    }
  } // namespace

  void run_speed_sweep(const Model           &model,
                       const SpeedSweepFiles &files,
                       PairSpeedSweep        &sweep,
                       OutputFolder          &folder,
                       Log                   &log)
  {
    const auto start = WallClock::now();
    RunSignals signals;
    const auto write = [&]() {
      write_csv(folder, "resonance.csv", sweep.resonance());
      write_csv(folder, "wave_response.csv", sweep.waves());
      write_csv(folder, "stress_response.csv", sweep.stresses());
      stop_if_asked(signals, sweep, folder.communicator());
    };
    RunSummary summary = start_summary("reduced", model, folder);
    try
      {
        sweep.run(write, log);
      }
    catch (const NumericalError &error)
      {
        summary.status  = "failed";
        summary.failure = error.what();
      }
    if (files.allowed_amplification > 0)
      {
        Table exceedances = make_exceedance_table();
        add_exceedances(sweep.resonance(),
                        sweep.stresses(),
                        files.allowed_amplification,
                        exceedances);
        write_csv(folder, "exceedances.csv", exceedances);
      }
    summary.run_time = seconds_since(start);
    summary.figures  = {{"cut-off frequency", {files.cutoff, "Hz"}},
                        {"speeds", {double(sweep.resonance().n_rows()), "-"}}};
    write_summary(folder, summary);
    if (summary.status == "failed")
      throw NumericalError(summary.failure);
    log.line(sweep.resonance().n_rows(), " speeds in ", duration_text(summary.run_time));
  }
} // namespace vfife
