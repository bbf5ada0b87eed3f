// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/table.h>
#include <vfife/output/measures/probe_record.h>
#include <vfife/study/cases/probe_copies.h>
#include <vfife/study/run/pair_probes.h>

#include <algorithm>
#include <utility>

namespace vfife
{
  namespace
  {
    /** Mesh cycles of a run after which a probe has its largest stress: two thirds. Stress rises
     * in 4 to 16 mesh cycles and falls over 15 to 60, so that what is nearest to the steady value
     * lies before the peak. */
    unsigned int peak_mesh(const unsigned int meshes)
    {
      return 2 * meshes / 3;
    }
  } // namespace

  PairProbes::PairProbes(Model &model, Measure measure, Log &log, const unsigned int meshes)
    : model_(model)
    , measure_(std::move(measure))
    , log_(log)
    , meshes_(meshes)
  {
  }

  std::vector<double> PairProbes::measure_turn(const Probe &probe) const
  {
    std::vector<double> turn;
    for (const ProbeValue &value : measure_(list_copies(model_, probe)))
      turn.push_back(value.von_mises);
    return turn;
  }

  void PairProbes::choose()
  {
    for (Probe &probe : model_.probes)
      {
        // Copy m is where the probe will be after m meshes: the copy that is n meshes behind the
        // place of the largest stress comes there in n meshes. All ranks have the same sums.
        const std::vector<double> turn    = measure_turn(probe);
        const auto                largest = std::max_element(turn.begin(), turn.end());
        const std::size_t         z = turn.size(), n = peak_mesh(meshes_);
        const std::size_t         place = largest - turn.begin();
        log_.line(probe.name,
                  ": largest von Mises stress of all sectors ",
                  *largest,
                  " MPa; the recorded sector reaches this place after ",
                  n,
                  " of ",
                  meshes_,
                  " mesh cycles");
        probe = list_copies(model_, probe)[(place + z - n % z) % z];
      }
  }

  double PairProbes::passes_mesh(const Probe &probe) const
  {
    const double meshes = meshes_to_contact(model_, probe);
    return meshes <= meshes_ ? meshes : meshes - list_copies(model_, probe).size();
  }

  void PairProbes::log_passages() const
  {
    for (const Probe &probe : model_.probes)
      {
        const double meshes = passes_mesh(probe);
        log_.line(probe.name,
                  meshes < 0 ? ": passed the contact " : ": passes the contact after ",
                  meshes < 0 ? -meshes : meshes,
                  meshes < 0 ? " mesh cycles before the start" : " mesh cycles");
      }
  }

  std::vector<ProbeRecord> PairProbes::judge(const double time, const Table &rows) const
  {
    std::vector<ProbeRecord> records;
    const Transmission      &pair = *model_.only_transmission();
    for (const Probe &probe : model_.probes)
      {
        std::vector<double> times, stresses;
        for (std::size_t i = 0; i < rows.n_rows(); ++i)
          if (rows.column(column::probe).texts[i] == probe.name)
            {
              times.push_back(rows.numbers(column::time)[i]);
              stresses.push_back(rows.numbers(column::von_mises)[i]);
            }
        if (times.empty())
          continue;
        records.push_back(make_probe_record(
          probe.name,
          times,
          stresses,
          time,
          measure_turn(probe),
          [&pair](const double at) { return pair.meshes(at); },
          pair.time_of(passes_mesh(probe))));
        log_.line(records.back().explain());
      }
    return records;
  }
} // namespace vfife
