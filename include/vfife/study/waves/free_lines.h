// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_free_lines_h
#define vfife_study_waves_free_lines_h

#include <vfife/base/text/table.h>

#include <vector>

namespace vfife
{
  struct Model;
  struct ReducedBody;
  struct WaveLine;
  struct WavesOptions;

  /** Where mesh orders meet waves of the driven body by itself. */
  class FreeLines
  {
  public:
    /** All must outlive the object. @p body: the driven one; @p sense: of its Body::axis about the
     * axis of the sectors. */
    FreeLines(const WavesOptions &options,
              const Model        &model,
              const ReducedBody  &body,
              double              sense);

    /** The lines that the options ask for, ascending by speed, with a damping [1/s]. Throws
     * InputError. */
    std::vector<WaveLine> find(double zeta) const;

    /** waves_frequencies.csv. */
    Table list_frequencies() const;

  private:
    const WavesOptions &options_;
    const Model        &model_;
    const ReducedBody  &body_;
    double              sense_;
  };
} // namespace vfife

#endif
