// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_bearing_writer_h
#define vfife_output_observers_bearing_writer_h

#include <vfife/output/measures/bearing_columns.h>
#include <vfife/output/measures/pair_mounting.h>
#include <vfife/output/observers/sampled_table.h>

namespace vfife
{
  /** bearings.csv, long format: one line a sample and bearing of the model. */
  class BearingWriter : public SampledTable<BearingSample>
  {
  public:
    BearingWriter(const OutputFolder &folder, std::uint64_t steps_between);

  private:
    void add_rows(const Model &model, const State &state) override;
  };

  /** bearing_curves.csv, where any bearing's law is no straight line. */
  void write_bearing_curves(const OutputFolder &folder, const std::vector<Bearing> &bearings);

  /** misalignment.csv: how the members of a gear pair stand to each other, one line a sample. */
  class MisalignmentWriter : public SampledTable<Mounting>
  {
  public:
    /** @p motion_of: of the members' bores now; without it those of the state's nodes. */
    MisalignmentWriter(const OutputFolder &folder,
                       const Model        &model,
                       std::uint64_t       steps_between,
                       RingMotions         motion_of = nullptr);

  private:
    void add_rows(const Model &model, const State &state) override;

    const OutputFolder &folder_;
    PairMounting        mounting_;
    RingMotions         motion_of_;
  };
} // namespace vfife

#endif
