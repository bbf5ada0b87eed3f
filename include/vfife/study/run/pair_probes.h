// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_pair_probes_h
#define vfife_study_run_pair_probes_h

#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <functional>
#include <vector>

namespace vfife
{
  class Log;
  class Table;
  struct ProbeRecord;

  /**
   * The probes of a gear pair that runs, each of which has a copy in every sector: the copies'
   * stresses at one instant are what the probe goes through in a turn
   * (doc/theory/transmission-error.md, Copy of a probe).
   */
  class PairProbes
  {
  public:
    /** What probes like those of the model would show now; collective. */
    using Measure = std::function<std::vector<ProbeValue>(const std::vector<Probe> &)>;

    /** @p meshes: of the whole run. Everything given must outlive the object. */
    PairProbes(Model &model, Measure measure, Log &log, unsigned int meshes);

    /** Moves each probe to the copy that comes, after two thirds of the run, where the loaded pair
     * now has the largest von Mises stress of all copies. Collective. */
    void choose();

    /** Says when the probes pass the mesh. */
    void log_passages() const;

    /** What the rows of probes.csv and the copies now, at the end of the run at @p time [s], tell
     * of each probe; says so. Collective. */
    std::vector<ProbeRecord> judge(double time, const Table &rows) const;

  private:
    /** Von Mises stresses of list_copies() of a probe. Collective. */
    std::vector<double> measure_turn(const Probe &probe) const;

    /** Tooth meshes after the start; negative where a probe has passed before it. */
    double passes_mesh(const Probe &probe) const;

    Model       &model_;
    Measure      measure_;
    Log         &log_;
    unsigned int meshes_;
  };
} // namespace vfife

#endif
