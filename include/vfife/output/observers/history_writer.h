// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_history_writer_h
#define vfife_output_observers_history_writer_h

#include <vfife/contact/contact_impulse.h>
#include <vfife/output/observers/sampled_table.h>

#include <functional>

namespace vfife
{
  /**
   * history.csv: one line a sample, of what is measured of the whole model. Gear pairs have angles,
   * transmission errors, contact, energies; other models contact, energies, momenta and all probes
   * (doc/reference/files.md, Columns). A column is one line of the list in the source.
   */
  class HistoryWriter : public SampledTable<Measurements>
  {
  public:
    /** Integrals of the contact of a gear pair up to now. */
    using ImpulseReader = std::function<ContactImpulse()>;

    /** Without @p impulse there are no columns of it. */
    HistoryWriter(const OutputFolder  &folder,
                  const Model         &model,
                  std::uint64_t        steps_between,
                  const ImpulseReader &impulse = nullptr);

  private:
    void add_rows(const Model &model, const State &state) override;
  };
} // namespace vfife

#endif
