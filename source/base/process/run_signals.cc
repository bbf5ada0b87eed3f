// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/run_signals.h>

#include <array>
#include <csignal>
#include <unistd.h>

namespace vfife
{
  namespace
  {
    // A handler can reach nothing but what is static.
    volatile std::sig_atomic_t stop_signal_seen   = 0;
    volatile std::sig_atomic_t field_request_seen = 0;

    constexpr std::array<int, 4> caught = {{SIGTERM, SIGINT, SIGUSR2, SIGUSR1}};

    /** The handler: nothing but setting flags is safe inside one. The loop asks for them. */
    void remember(const int signal)
    {
      if (signal == SIGUSR1)
        field_request_seen = 1;
      else
        stop_signal_seen = signal;
    }

    constexpr std::array<int, 2> noticed = {{SIGINT, SIGUSR2}};

    /** write() and raise() are safe in a handler, streams are not. The handler is gone by then. */
    void say_and_end(const int signal)
    {
      constexpr char text[] =
        "\nvfife: stopped before the first step or between runs: no checkpoint to go on from\n";
      if (write(STDERR_FILENO, text, sizeof(text) - 1) >= 0)
        raise(signal);
      else
        _exit(128 + signal);
    }
  } // namespace

  struct RunSignals::Handlers
  {
    std::array<struct sigaction, caught.size()> before;
  };

  RunSignals::RunSignals()
    : handlers_(std::make_unique<Handlers>())
  {
    // What has come before this run is none of its business.
    stop_signal_seen = field_request_seen = 0;
    for (std::size_t i = 0; i < caught.size(); ++i)
      {
        struct sigaction action = {};
        action.sa_handler       = &remember;
        // SA_RESTART: reading and writing go on after the signal. SA_RESETHAND: the second
        // one of its kind ends the program.
        action.sa_flags = SA_RESTART;
        if (caught[i] == SIGTERM || caught[i] == SIGINT)
          action.sa_flags |= static_cast<int>(SA_RESETHAND);
        sigemptyset(&action.sa_mask);
        sigaction(caught[i], &action, &handlers_->before[i]);
      }
  }

  RunSignals::~RunSignals()
  {
    for (std::size_t i = 0; i < caught.size(); ++i)
      sigaction(caught[i], &handlers_->before[i], nullptr);
  }

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
    : speaks_(speaks)
  {
    for (std::size_t i = 0; speaks_ && i < noticed.size(); ++i)
      {
        struct sigaction action = {};
        action.sa_handler       = &say_and_end;
        action.sa_flags         = static_cast<int>(SA_RESETHAND);
        sigemptyset(&action.sa_mask);
        sigaction(noticed[i], &action, &before_[i]);
      }
  }

  StopNotice::~StopNotice()
  {
    for (std::size_t i = 0; speaks_ && i < noticed.size(); ++i)
      sigaction(noticed[i], &before_[i], nullptr);
  }
} // namespace vfife
