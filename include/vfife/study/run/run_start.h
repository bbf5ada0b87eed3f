// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_run_start_h
#define vfife_study_run_run_start_h

#include <memory>

namespace vfife
{
  class ByteStream;
  class Communicator;
  class ExplicitSolver;
  class Log;
  struct DynamicsOptions;
  struct Model;
  struct PairPreload;
  struct State;

  /** How a run comes to where its first step begins, and what is learned on the way. */
  class RunStart
  {
  public:
    virtual ~RunStart() = default;

    /** Takes the undeformed bodies that turn at their rates there; not called when a run resumes.
     * Throws NumericalError. Collective. */
    virtual void prepare(State &state) = 0;

    /** For checkpoints: passes what prepare() has found out. */
    virtual void exchange(ByteStream &stream);

    /** What the equilibrium of a gear pair has told; nullptr for starts without one. */
    virtual const PairPreload *preload() const;
  };

  /** The start that Dynamics/start asks for. Everything given must outlive it. */
  std::unique_ptr<RunStart> make_start(const Model           &model,
                                       const DynamicsOptions &options,
                                       ExplicitSolver        &solver,
                                       const Communicator    &communicator,
                                       Log                   &log);
} // namespace vfife

#endif
