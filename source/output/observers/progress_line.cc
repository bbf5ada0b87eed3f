// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/observers/progress_line.h>

#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <unistd.h>

namespace vfife
{
  namespace
  {
    /** Whether somebody looks at a terminal. Ranks of mpirun have one of its own: whoever starts it
     * tells by VFIFE_TERMINAL = no that its output goes to a file. */
    bool shows_terminal()
    {
      const char *const told = std::getenv("VFIFE_TERMINAL");
      return isatty(STDOUT_FILENO) != 0 && !(told != nullptr && std::string(told) == "no");
    }

    /** Whether that part is all of a run, to rounding of the time: then its last line comes. */
    bool is_whole(const double done)
    {
      return done >= 1 - 1e-9;
    }
  } // namespace

  std::string duration_text(const double seconds)
  {
    constexpr double year = 365.25 * 24 * 3600;
    if (!(seconds >= 0))
      return "?";
    if (seconds > year)
      return "more than a year";
    // The two largest units that are not zero.
    const auto         s = static_cast<unsigned long>(std::lround(seconds));
    std::ostringstream text;
    text << std::setfill('0');
    if (s >= 3600)
      text << s / 3600 << " h " << std::setw(2) << s / 60 % 60 << " min";
    else if (s >= 60)
      text << s / 60 << " min " << std::setw(2) << s % 60 << " s";
    else
      text << s << " s";
    return text.str();
  }

  ProgressLine::ProgressLine(Log                &log,
                             const Communicator &communicator,
                             const double        start_time,
                             const double        end_time,
                             const double        whole_end_time,
                             const std::uint64_t steps_between)
    : log_(log)
    , is_writer_(communicator.is_root())
    , is_terminal_(shows_terminal() && log.verbosity() != Verbosity::quiet)
    , start_time_(start_time)
    , end_time_(end_time)
    , whole_end_time_(whole_end_time)
    , steps_between_(steps_between)
    , begin_(WallClock::now())
    , last_line_(begin_)
  {
  }

  bool ProgressLine::due(const State &state) const
  {
    return state.step % steps_between_ == 0;
  }

  std::string ProgressLine::compose(const Model &model, const State &state) const
  {
    // " 25 %  0.250 ms  mesh cycle 2.2  step 40  energy error 1.0e-06  DTE -35.50 arcsec  12 min 03
    // s left"
    const double       done = (state.time - start_time_) / (end_time_ - start_time_);
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << std::setw(3) << std::floor(100 * done + 1e-9)
         << " %  " << std::setprecision(3) << 1e3 * state.time << " ms";
    const Transmission *const t = model.only_transmission();
    if (t)
      text << std::setprecision(1) << "  mesh cycle "
           << t->meshes(state.time) - t->meshes(start_time_);
    text << "  step " << state.step << std::scientific << std::setprecision(1) << "  energy error "
         << state.measured.energy.error();
    if (t)
      text << std::fixed << std::setprecision(2) << "  DTE "
           << state.measured.transmission_error / arcsecond << " arcsec";
    // By what this process has done: a resumed run does not count the part before.
    if (done > first_fraction_ && !is_whole(done))
      text << "  " << duration_text(seconds_since(begin_) * (1 - done) / (done - first_fraction_))
           << " left";
    return text.str();
  }

  void ProgressLine::say_expected_time(const State &state)
  {
    // Enough for caches, contact and the first output to be in the mean.
    constexpr std::uint64_t enough = 200;
    const std::uint64_t     steps  = state.step - first_step_;
    if (said_expected_ || steps < enough)
      return;
    said_expected_           = true;
    const double one         = seconds_since(begin_) / steps;
    const auto   count_until = [&](const double end) {
      return std::llround((end - start_time_) / state.dt);
    };
    const auto whole = count_until(whole_end_time_), part = count_until(end_time_);
    log_.line("one step takes ",
              1e3 * one,
              " ms (mean of the first ",
              steps,
              "); the whole run of ",
              whole,
              " steps takes about ",
              duration_text(one * whole),
              part < whole ? "; this part of " + std::to_string(part) + " steps takes about " +
                               duration_text(one * part)
                           : "");
  }

  void ProgressLine::observe(const Model &model, const State &state)
  {
    // The clock starts with the first state, after meshing and preload.
    if (!has_begun_)
      {
        begin_ = last_line_ = WallClock::now();
        first_step_         = state.step;
        first_fraction_     = (state.time - start_time_) / (end_time_ - start_time_);
        has_begun_          = true;
      }
    if (!is_writer_)
      return;
    say_expected_time(state);

    // On a terminal one line that is written over every second; elsewhere a line every 5 %, at
    // least one a minute.
    const double waited = seconds_since(last_line_);
    // A look at the clock in every sample is cheap, a line is not.
    if (waited < 1)
      return;
    const double done = (state.time - start_time_) / (end_time_ - start_time_);
    if (is_terminal_)
      {
        const std::string text = compose(model, state);
        const std::size_t rest = shown_ > text.size() ? shown_ - text.size() : 0;
        // The line is overwritten; blanks cover what was longer before.
        std::cout << '\r' << text << std::string(rest, ' ') << std::flush;
        shown_ = text.size();
      }
    else if (!is_whole(done) && (done >= last_fraction_ + 0.05 - 1e-9 || waited >= 60))
      {
        log_.line(compose(model, state));
        // The next line comes at the next whole 5 %, also if this one was late.
        last_fraction_ = std::floor(20 * done + 1e-9) / 20;
      }
    else
      return;
    last_line_ = WallClock::now();
  }

  void ProgressLine::finish(const Model &model, const State &state)
  {
    if (!is_writer_)
      return;
    // The line on the terminal is wiped: the last one goes to the log like any other.
    if (shown_ > 0)
      std::cout << '\r' << std::string(shown_, ' ') << '\r' << std::flush;
    shown_ = 0;
    log_.line(compose(model, state), "  in ", duration_text(seconds_since(begin_)));
  }
} // namespace vfife
