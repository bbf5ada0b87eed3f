// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_pair_probes_h
#define vfife_study_run_pair_probes_h

#include <vfife/model/model.h>

#include <vector>

namespace vfife
{
  class Communicator;
  class ExplicitSolver;
  class Log;
  class Table;
  struct ProbeRecord;
  struct State;

  /**
   * The probes of a gear pair that runs, each of which has a copy in every sector: the copies'
   * stresses at one instant are what the probe goes through in a turn (doc/study.md, Which copy a
   * probe is).
   */
  class PairProbes
  {
  public:
    /** @p meshes: of the whole run. Everything given must outlive the object. */
    PairProbes(Model              &model,
               ExplicitSolver     &solver,
               const Communicator &communicator,
               Log                &log,
               unsigned int        meshes);

    /** Moves each probe to the copy that comes, after two thirds of the run, where the loaded pair
     * in @p state has the largest von Mises stress of all copies. Collective. */
    void choose(const State &state);

    /** Says when the probes pass the mesh. */
    void log_passages() const;

    /** What the rows of probes.csv and the copies in @p state, at the end of the run, tell of each
     * probe; says so. Collective. */
    std::vector<ProbeRecord> judge(const State &state, const Table &rows) const;

  private:
    /** Von Mises stresses of list_copies() of a probe. Collective. */
    std::vector<double> measure_turn(const State &state, const Probe &probe) const;

    /** Tooth meshes after the start; negative where a probe has passed before it. */
    double passes_mesh(const Probe &probe) const;

    Model              &model_;
    ExplicitSolver     &solver_;
    const Communicator &communicator_;
    Log                &log_;
    unsigned int        meshes_;
  };
} // namespace vfife

#endif
