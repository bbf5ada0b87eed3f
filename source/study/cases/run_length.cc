// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/table.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/output/files/checkpoint.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_reader.h>
#include <vfife/output/measures/steady_part.h>
#include <vfife/output/output_options.h>
#include <vfife/study/cases/case.h>
#include <vfife/study/cases/run_length.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** To which vibrations have to fall: the ripple is judged to a tenth. */
    constexpr double fall = 10;

    /** The time of the last sample in the results [s]. */
    double end_of_record(const OutputFolder &folder)
    {
      return read_result_table(folder.file("history.csv")).numbers(column::time).back();
    }
  } // namespace

  RunTimes plan_times(const Case            &run_case,
                      const DynamicsOptions &dynamics,
                      const OutputOptions   &output,
                      const Transmission    *pair,
                      const double           dt)
  {
    RunTimes times;
    times.sample_steps = output.compute_history_steps(pair, dt);
    const double time = run_case.end_time(), sample = times.sample_steps * dt;
    const double last  = sample * std::ceil(time / sample * (1. - 1e-9));
    times.whole        = pair == nullptr || std::abs(last - time) <= 1e-9 * time ? time : last;
    const auto largest = dynamics.largest_steps;
    times.end          = largest > 0 ? std::min(times.whole, largest * dt) : times.whole;
    return times;
  }

  unsigned int count_meshes(const Transmission &pair, const double time)
  {
    return static_cast<unsigned int>(pair.meshes(time) + 1e-6);
  }

  unsigned int count_steady_meshes(const double           mesh_frequency,
                                   const double           swing_period,
                                   const DynamicsOptions &dynamics)
  {
    const double elastic = dynamics.mass_damping(), swing = dynamics.mesh_damping;
    // What is not damped at all does not fall; a damper of one alone is that of the other, through
    // the part that the swing has of deformation.
    const double rate =
      elastic > 0 && swing > 0 ? std::min(elastic, swing) : std::max(elastic, swing);
    if (!(rate > 0))
      return 0;
    const double time   = 2. / rate * std::log(fall);
    const double meshes = std::ceil(mesh_frequency * time - 1e-9);
    const double least  = std::max(meshes, 2. * std::ceil(swing_period - 1e-9));
    return static_cast<unsigned int>(std::min(1e9, meshes + least));
  }

  void
  check_lengths(const Case &run_case, const DynamicsOptions &dynamics, const OutputOptions &output)
  {
    if (!run_case.list_lengths(dynamics).empty() && !(output.checkpoint_every > 0))
      throw InputError("Output/checkpoint interval",
                       "must be positive with Operation/mesh cycles = until steady: the run "
                       "continues from the checkpoint at its end");
  }

  void run_lengths(Case                        &run_case,
                   const DynamicsOptions       &dynamics,
                   const OutputFolder          &folder,
                   std::optional<Checkpoint>   &checkpoint,
                   const std::function<bool()> &once,
                   Log                         &log)
  {
    const std::vector<unsigned int> lengths = run_case.list_lengths(dynamics);
    if (lengths.empty())
      {
        once();
        return;
      }
    // What is beyond the checkpoint, if anything, belongs to the length in which it was written.
    double reached = 0;
    if (checkpoint)
      reached = end_of_record(folder);
    for (std::size_t i = 0; i < lengths.size(); ++i)
      {
        run_case.set_length(lengths[i]);
        const bool last = i + 1 == lengths.size();
        if (!last && run_case.end_time() < reached * (1. - 1e-9))
          continue;
        if (once())
          {
            log.line("the ripple is steady within ", lengths[i], " mesh cycles");
            return;
          }
        // A limit of the number of steps has ended the run, which has said so.
        if (dynamics.largest_steps > 0 && end_of_record(folder) < run_case.end_time() * (1. - 1e-9))
          return;
        if (last)
          {
            log.warning("the ripple is still transient after ",
                        lengths[i],
                        " mesh cycles: Operation/maximum mesh cycles");
            return;
          }
        log.line("the ripple is still transient after ",
                 lengths[i],
                 " mesh cycles: the run continues to ",
                 lengths[i + 1]);
        checkpoint = read_checkpoint(folder.path(), folder.communicator(), log);
      }
  }
} // namespace vfife
