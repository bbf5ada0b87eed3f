// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_history_writer_h
#define vfife_output_observers_history_writer_h

#include <vfife/base/text/table.h>
#include <vfife/model/observer.h>
#include <vfife/output/files/csv_stream.h>

#include <cstdint>

namespace vfife
{
  /**
   * history.csv: one line a sample. With a gear pair: time [s], pinion angle and gear angle [deg],
   * dte and rim dte [arcsec], contact force total [N], contact torque on the gear [N m], teeth in
   * contact [-], largest penetration [um], energies [mJ], energy error [-]; other models: time,
   * contact force total, largest penetration, energies, energy error. The table stays in memory on
   * all ranks for later analysis.
   */
  class HistoryWriter : public Observer
  {
  public:
    /** A sample every @p steps_between steps (>= 1). */
    HistoryWriter(const OutputFolder &folder, const Model &model, std::uint64_t steps_between);

    bool due(const State &state) const override;
    void observe(const Model &model, const State &state) override;
    void exchange(ByteStream &stream) override;
    void finish(const Model &model, const State &state) override;

    const Table &table() const;

  private:
    std::uint64_t steps_between_;
    Table         table_;
    CsvStream     file_;
  };
} // namespace vfife

#endif
