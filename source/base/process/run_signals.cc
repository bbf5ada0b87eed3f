// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/run_signals.h>

#include <csignal>
#include <unistd.h>
#include <utility>
#include <vector>

namespace vfife
{
  namespace
  {
    // A handler can reach nothing but what is static.
    volatile std::sig_atomic_t stop_signal_seen   = 0;
    volatile std::sig_atomic_t field_request_seen = 0;

    /** The handler: nothing but setting flags is safe inside one. The loop asks for them. */
    void remember(const int signal)
    {
      if (signal == SIGUSR1)
        field_request_seen = 1;
      else
        stop_signal_seen = signal;
    }

    /** write() and raise() are safe in a handler, streams are not. The handler is gone by then. */
    void say_and_end(const int signal)
    {
      constexpr char text[] =
        "\nvfife: stopped before the first step or between runs; no checkpoint exists\n";
      [[maybe_unused]] const auto written = write(STDERR_FILENO, text, sizeof(text) - 1);
      raise(signal);
    }
  } // namespace

  class SignalHandlers
  {
  public:
    /** Sets @p handler for signals, each with its flags of sigaction. */
    SignalHandlers(void (*handler)(int), const std::vector<std::pair<int, int>> &signals)
    {
      for (const auto &[signal, flags] : signals)
        {
          struct sigaction action = {}, before = {};
          action.sa_handler = handler;
          action.sa_flags   = flags;
          sigemptyset(&action.sa_mask);
          sigaction(signal, &action, &before);
          before_.emplace_back(signal, before);
        }
    }

    ~SignalHandlers()
    {
      for (const auto &[signal, before] : before_)
        sigaction(signal, &before, nullptr);
    }

    SignalHandlers(const SignalHandlers &)            = delete;
    SignalHandlers &operator=(const SignalHandlers &) = delete;

  private:
    std::vector<std::pair<int, struct sigaction>> before_;
  };

  RunSignals::RunSignals()
  {
    // What has come before this run is none of its business.
    stop_signal_seen = field_request_seen = 0;
    // SA_RESTART: reading and writing go on after the signal. SA_RESETHAND: the second one of its
    // kind ends the program.
    constexpr int again = SA_RESTART, once = SA_RESTART | static_cast<int>(SA_RESETHAND);
    handlers_ =
      std::make_unique<SignalHandlers>(&remember,
                                       std::vector<std::pair<int, int>>{{SIGTERM, once},
                                                                        {SIGINT, once},
                                                                        {SIGUSR2, again},
                                                                        {SIGUSR1, again}});
  }

  RunSignals::~RunSignals() = default;

  int RunSignals::stop_signal() const
  {
    return stop_signal_seen;
  }

  bool RunSignals::take_field_request()
  {
    const bool seen    = field_request_seen != 0;
    field_request_seen = 0;
    return seen;
  }

  StopNotice::StopNotice(const bool speaks)
  {
    constexpr int once = static_cast<int>(SA_RESETHAND);
    if (speaks)
      handlers_ = std::make_unique<SignalHandlers>(
        &say_and_end, std::vector<std::pair<int, int>>{{SIGINT, once}, {SIGUSR2, once}});
  }

  StopNotice::~StopNotice() = default;
} // namespace vfife
