// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_observer_h
#define vfife_model_observer_h

#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  class ByteStream;
  struct Model;
  struct State;

  /** Looks at a run and changes nothing. All functions are called on all ranks. */
  class Observer
  {
  public:
    virtual ~Observer() = default;

    /** Whether observe() is wanted at this state; the solver measures first (State::measured).
     * Equal on all ranks. */
    virtual bool due(const State &state) const = 0;

    virtual void observe(const Model &model, const State &state) = 0;

    /** By which what it has observed is found in a checkpoint, whatever observers there are; ""
     * (default) for one that keeps nothing. Different from that of all others. */
    virtual std::string part_name() const;

    /** For checkpoints: passes what has been observed so far, equal on all ranks. Collective. */
    virtual void serialize(ByteStream &stream);

    /** After the last step, and after a failure with the last state that was reached. */
    virtual void finish(const Model &model, const State &state);
  };

  using Observers = std::vector<std::unique_ptr<Observer>>;
} // namespace vfife

#endif
