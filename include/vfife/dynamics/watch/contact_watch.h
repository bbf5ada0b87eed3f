// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_watch_contact_watch_h
#define vfife_dynamics_watch_contact_watch_h

#include <vfife/model/state.h>

namespace vfife
{
  class ByteStream;
  class Log;

  /** Counts how often a model that was in contact lets go of it, step by step, and says so. */
  class ContactWatch
  {
  public:
    explicit ContactWatch(Log &log);

    /** Forgets everything: a new run begins. */
    void reset();

    /** Looks at the step of length @p dt [s] that begins at @p time; @p touching: any point of any
     * contact pair, or on a wall, presses. */
    void observe(double time, double dt, bool touching);

    /** For checkpoints. */
    void serialize(ByteStream &stream);

    const ContactLosses &losses() const;

  private:
    Log          &log_;
    ContactLosses losses_;
    bool          touched_ = false; ///< in the step before
  };
} // namespace vfife

#endif
