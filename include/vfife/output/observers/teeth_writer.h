// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_teeth_writer_h
#define vfife_output_observers_teeth_writer_h

#include <vfife/base/text/table.h>
#include <vfife/contact/law/hertz.h>
#include <vfife/model/observer.h>
#include <vfife/output/files/csv_stream.h>

#include <cstdint>

namespace vfife
{
  /**
   * teeth.csv, long format: one line a sample and tooth pair in contact: time [s], side, pinion
   * tooth, gear tooth, force [N] (magnitude of the resultant), torque [N m] on the gear, largest
   * pressure [MPa] of a point, area [mm^2], mean pressure [MPa] (force over area), hertz pressure
   * [MPa] (largest one of Hertz's ellipse under that force at the mean contact). Models without a
   * gear pair have slave group and master group instead of the teeth.
   */
  class TeethWriter : public Observer
  {
  public:
    /** @p hertz: contact of one tooth pair; without it there is no column of its pressure. */
    TeethWriter(const OutputFolder &folder,
                const Model        &model,
                std::uint64_t       steps_between,
                const HertzContact &hertz = {});

    bool due(const State &state) const override;
    void observe(const Model &model, const State &state) override;
    void exchange(ByteStream &stream) override;
    void finish(const Model &model, const State &state) override;

    const Table &table() const;

  private:
    std::uint64_t steps_between_;
    HertzContact  hertz_;
    Table         table_;
    CsvStream     file_;
  };
} // namespace vfife

#endif
