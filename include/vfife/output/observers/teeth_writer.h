// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_teeth_writer_h
#define vfife_output_observers_teeth_writer_h

#include <vfife/contact/law/hertz.h>
#include <vfife/output/observers/sampled_table.h>

namespace vfife
{
  /** A tooth pair in contact, or another pair of surface groups. */
  struct ToothSample
  {
    const ToothContact &contact;
    /** Teeth of the driver and the driven member; without a gear pair groups of slave and master.
     */
    unsigned int first = 0, second = 0;
  };

  /**
   * teeth.csv, long format: one line a sample and tooth pair in contact: its force, torque, area
   * and pressures (doc/reference/files.md, Columns). Models without a gear pair have groups of
   * facets of the slave and of the master surface instead of the teeth.
   */
  class TeethWriter : public SampledTable<ToothSample>
  {
  public:
    /** @p hertz: contact of one tooth pair; without it there is no column of its pressure. */
    TeethWriter(const OutputFolder &folder,
                const Model        &model,
                std::uint64_t       steps_between,
                const HertzContact &hertz = {});

  private:
    void add_rows(const Model &model, const State &state) override;
  };
} // namespace vfife

#endif
