// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_explicit_stepping_h
#define vfife_study_run_explicit_stepping_h

#include <vfife/study/run/stepping.h>

#include <vector>

namespace vfife
{
  class ExplicitSolver;
  class FieldWriter;
  class RunStart;
  struct DynamicsOptions;

  /** The steps of ExplicitSolver, whatever the model. One whose step turns out too long goes back
   * and on with a shorter one. */
  class ExplicitStepping : public Stepping
  {
  public:
    /** Everything given must outlive the object. The step of @p solver is set; the first one is
     * where @p start takes the state. */
    ExplicitStepping(const RunMeans &means, ExplicitSolver &solver, RunStart &start);

    /** Adds the fields as often as @p output says for a step of @p dt [s]; never: on SIGUSR1 only.
     */
    void add_fields(const OutputOptions &output, double dt, const DynamicsOptions &dynamics);

  private:
    /** A checkpoint in memory, of this rank. */
    struct Snapshot
    {
      std::string common, own;
      double      alternating_share; ///< ExplicitSolver::alternating_share()
    };

    void serialize(ByteStream &common, ByteStream *own) override;
    void prepare() override;
    void take_steps(RunSignals &signals, bool resumed) override;
    void end() override;
    void keep_snapshot();
    bool go_back(const NumericalError &error);

    ExplicitSolver &solver_;
    RunStart       &start_;
    FieldWriter    *fields_ = nullptr;
    std::vector<Snapshot>
      snapshots_; ///< the first and the last two, while the step may be too long
  };
} // namespace vfife

#endif
