// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_probe_writer_h
#define vfife_output_observers_probe_writer_h

#include <vfife/base/text/table.h>
#include <vfife/model/observer.h>
#include <vfife/output/files/csv_stream.h>

#include <cstdint>

namespace vfife
{
  /**
   * probes.csv, long format: one line a sample and probe: time [s], probe, displacement r, theta, z
   * [um], von mises [MPa], stress components [MPa] in the cylindrical axes of the body.
   */
  class ProbeWriter : public Observer
  {
  public:
    ProbeWriter(const OutputFolder &folder, std::uint64_t steps_between);

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
