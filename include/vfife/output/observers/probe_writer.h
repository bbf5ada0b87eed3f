// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_probe_writer_h
#define vfife_output_observers_probe_writer_h

#include <vfife/output/observers/sampled_table.h>

#include <string>

namespace vfife
{
  /** A probe by its name. */
  struct ProbeSample
  {
    const std::string &name;
    const ProbeValue  &value;
  };

  /**
   * probes.csv, long format: one line a sample and probe: displacement and stresses in the
   * cylindrical axes of the body (doc/reference/files.md, Columns).
   */
  class ProbeWriter : public SampledTable<ProbeSample>
  {
  public:
    ProbeWriter(const OutputFolder &folder, std::uint64_t steps_between);

  private:
    void add_rows(const Model &model, const State &state) override;
  };
} // namespace vfife

#endif
