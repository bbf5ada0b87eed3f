// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_process_run_signals_h
#define vfife_base_process_run_signals_h

#include <memory>

namespace vfife
{
  class SignalHandlers;

  /**
   * Signals to a run, caught for the life of this object (one at a time in a process): SIGTERM,
   * SIGINT and SIGUSR2, which mpirun passes on untouched, ask it to stop; SIGUSR1 asks for a field
   * file. A second SIGTERM or SIGINT ends the program at once, as it does without this object.
   */
  class RunSignals
  {
  public:
    RunSignals();
    ~RunSignals();
    RunSignals(const RunSignals &)            = delete;
    RunSignals &operator=(const RunSignals &) = delete;

    /** Number of the signal that asked this process to stop; 0: none. */
    int stop_signal() const;

    /** Whether this process was asked for a field file since the last call. */
    bool take_field_request();

  private:
    std::unique_ptr<SignalHandlers> handlers_;
  };

  /**
   * Where no run catches them, SIGINT and SIGUSR2 end the program as usual; for the life of this
   * object it says so in one line before. SIGTERM stays silent: mpirun sends it to all ranks when
   * one of them has failed and has said why.
   */
  class StopNotice
  {
  public:
    /** @param speaks whether this process is the one that prints */
    explicit StopNotice(bool speaks);
    ~StopNotice();
    StopNotice(const StopNotice &)            = delete;
    StopNotice &operator=(const StopNotice &) = delete;

  private:
    std::unique_ptr<SignalHandlers> handlers_;
  };
} // namespace vfife

#endif
