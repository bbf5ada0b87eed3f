// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_run_start_h
#define vfife_study_run_run_start_h

#include <memory>

namespace vfife
{
  class ByteStream;
  class Communicator;
  class Compliance;
  class ExplicitSolver;
  class Log;
  struct DynamicsOptions;
  struct Model;
  struct PairPreload;
  struct State;

  /** What a run starts with. Everything must outlive the start. */
  struct StartMeans
  {
    const Model           &model;
    const DynamicsOptions &options;
    ExplicitSolver        &solver;
    /** Of the model, as PairStart asks for, until the start has used it; or nullptr. */
    std::shared_ptr<Compliance> compliance;
    const Communicator         &communicator;
    Log                        &log;
  };

  /** How a run comes to where its first step begins, and what is learned on the way. */
  class RunStart
  {
  public:
    virtual ~RunStart() = default;

    /** Takes the undeformed bodies that turn at their rates there; not called when a run resumes.
     * Throws NumericalError. Collective. */
    virtual void prepare(State &state) = 0;

    /** For checkpoints: passes what prepare() has found out. */
    virtual void serialize(ByteStream &)
    {
    }

    /** The same of what later versions have added; not called where a checkpoint has none of it. */
    virtual void serialize_later(ByteStream &)
    {
    }

    /** What the equilibrium of a gear pair has told; nullptr for starts without one. */
    virtual const PairPreload *preload() const
    {
      return nullptr;
    }
  };
} // namespace vfife

#endif
