// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_process_run_signals_h
#define vfife_base_process_run_signals_h

#include <memory>
#include <string>

namespace vfife
{
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

    /** "SIGTERM" */
    static std::string name(int signal);

  private:
    struct Handlers;
    std::unique_ptr<Handlers> handlers_;
  };
} // namespace vfife

#endif
