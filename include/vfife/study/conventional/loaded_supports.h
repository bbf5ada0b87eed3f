// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_supports_h
#define vfife_study_conventional_loaded_supports_h

#include <vfife/base/text/table.h>
#include <vfife/output/measures/pair_mounting.h>
#include <vfife/output/measures/support_leads.h>

namespace vfife
{
  class FemSpace;
  class OutputFolder;
  struct PairEquilibriumResult;

  /** What bearings and shafts do at the positions of a loaded tooth contact analysis: rows of
   * bearings.csv and misalignment.csv. */
  class LoadedSupports
  {
  public:
    /** The model must have a transmission and outlive this. */
    explicit LoadedSupports(const Model &model);

    /** @p position in mesh cycles. */
    void add_position(const FemSpace &space, double position, const PairEquilibriumResult &result);

    /** Rows of misalignment.csv; none where nothing changes the mounting. */
    const Table &misalignments() const
    {
      return misalignments_;
    }

    /** The files of what there is, and the curves of the bearings. */
    void write(const OutputFolder &folder) const;

  private:
    const Model &model_;
    PairMounting mounting_;
    SupportLeads leads_;
    Table        bearings_, misalignments_;
  };
} // namespace vfife

#endif
