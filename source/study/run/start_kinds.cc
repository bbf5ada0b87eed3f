// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/dynamics/equilibrium/relaxation.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/study/run/pair_preload.h>
#include <vfife/study/run/start_kinds.h>

namespace vfife
{
  namespace
  {
    /** The bodies as they are: what ExplicitSolver::start() has made. */
    class UndeformedStart : public RunStart
    {
    public:
      void prepare(State &) override
      {
      }
    };

    /** Equilibrium of a general model under its loads and centrifugal force, then let go. */
    class RelaxedStart : public RunStart
    {
    public:
      explicit RelaxedStart(const StartMeans &means)
        : relaxation_(means.model,
                      means.options.relaxation,
                      means.solver.vfife_operator(),
                      means.solver.contact(),
                      means.solver.walls(),
                      means.communicator,
                      means.log)
        , solver_(means.solver)
        , log_(means.log)
      {
      }

      void prepare(State &state) override
      {
        // The loads of time zero and the centrifugal force; then each body gets its rigid velocity.
        const RelaxationReport report = relaxation_.solve(state, Relaxation::Loads());
        log_.line("equilibrium before the start: ", report.describe());
        solver_.set_windings(relaxation_.windings());
        solver_.set_initial_velocities(state);
      }

    private:
      Relaxation      relaxation_;
      ExplicitSolver &solver_;
      Log            &log_;
    };
  } // namespace

  std::unique_ptr<RunStart> make_start(const StartMeans &means)
  {
    if (means.options.start == Start::undeformed)
      return std::make_unique<UndeformedStart>();
    if (!means.model.transmissions.empty())
      return std::make_unique<PreloadedPair>(means);
    return std::make_unique<RelaxedStart>(means);
  }
} // namespace vfife
