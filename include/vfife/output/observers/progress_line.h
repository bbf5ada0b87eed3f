// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_progress_line_h
#define vfife_output_observers_progress_line_h

#include <vfife/base/process/wall_clock.h>
#include <vfife/model/observer.h>

#include <cstdint>
#include <string>

namespace vfife
{
  class Communicator;
  class Log;

  /**
   * Says on rank 0 how far a run is: percent, mesh cycles, step, energy error, transmission error,
   * time left. On a terminal one line that is overwritten at most once a second; otherwise a line
   * of the log every 5 %, at most one a second and at least one a minute.
   */
  class ProgressLine : public Observer
  {
  public:
    /** The run goes from @p start_time to @p end_time [s] of the model; of a run that is to do a
     * part only, @p whole_end_time is where it would end. After some 200 steps the expected time of
     * the whole run is said. */
    ProgressLine(Log                &log,
                 const Communicator &communicator,
                 double              start_time,
                 double              end_time,
                 double              whole_end_time,
                 std::uint64_t       steps_between);

    bool due(const State &state) const override;
    void observe(const Model &model, const State &state) override;
    void finish(const Model &model, const State &state) override;

  private:
    void        say_expected_time(const State &state);
    std::string compose(const Model &model, const State &state) const;

    Log                  &log_;
    bool                  is_writer_;
    bool                  is_terminal_;
    double                start_time_, end_time_, whole_end_time_;
    std::uint64_t         steps_between_;
    WallClock::time_point begin_, last_line_; ///< set when the first state is seen
    std::uint64_t         first_step_    = 0;
    bool                  has_begun_     = false;
    bool                  said_expected_ = false;
    double                last_fraction_ = 0, first_fraction_ = 0;
    std::size_t           shown_ = 0; ///< characters of the overwritten line
  };

  /** "3 h 12 min", "2 min 05 s", "41 s". */
  std::string duration_text(double seconds);
} // namespace vfife

#endif
