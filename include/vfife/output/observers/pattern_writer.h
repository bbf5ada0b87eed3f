// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_pattern_writer_h
#define vfife_output_observers_pattern_writer_h

#include <vfife/model/observer.h>
#include <vfife/output/measures/contact_pattern.h>

#include <cstdint>
#include <string>

namespace vfife
{
  class OutputFolder;

  /** pattern.csv: the contact pattern of a gear pair over the last mesh cycle of the run, a row a
   * place of a flank. */
  class PatternWriter : public Observer
  {
  public:
    /** Samples from @p start [s] on are looked at. */
    PatternWriter(const OutputFolder &folder,
                  const Model        &model,
                  double              start,
                  std::uint64_t       steps_between);

    bool        due(const State &state) const override;
    void        observe(const Model &model, const State &state) override;
    std::string part_name() const override;
    void        serialize(ByteStream &stream) override;
    void        finish(const Model &model, const State &state) override;

  private:
    const OutputFolder &folder_;
    double              start_;
    std::uint64_t       steps_between_;
    ContactPattern      pattern_;
  };
} // namespace vfife

#endif
