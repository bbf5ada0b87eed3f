// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_process_timers_h
#define vfife_base_process_timers_h

#include <vfife/base/process/traffic.h>
#include <vfife/base/text/table.h>

#include <chrono>
#include <string>
#include <vector>

namespace vfife
{
  class Communicator;

  /**
   * Where the time goes, and what is sent to other ranks meanwhile: every moment since construction
   * belongs to exactly one section, the innermost open one, or to "other" if none is open. Sections
   * add up to the total. Entering and leaving a section reads the clock once each (some 50 ns in
   * all), no allocation: fit for every part of a step of 1 ms.
   */
  class Timers
  {
  public:
    /** Times a section for the life of the object. Scopes may be nested: the outer section stands
     * still meanwhile. */
    class Scope
    {
    public:
      Scope(Timers &timers, const unsigned int section)
        : timers_(timers)
      {
        timers_.enter(section);
      }

      ~Scope()
      {
        timers_.leave();
      }

      Scope(const Scope &)            = delete;
      Scope &operator=(const Scope &) = delete;

    private:
      Timers &timers_;
    };

    /** @p traffic: what is counted beside the time, Communicator::traffic(); it must outlive the
     * object. nullptr: nothing. */
    explicit Timers(const Traffic *traffic = nullptr);

    /** The number of the section of that name, new or known; look it up before the loop. */
    unsigned int section(const std::string &name);

    /** Opens a section until the result goes out of scope. */
    Scope time(const unsigned int section)
    {
      return Scope(*this, section);
    }

    /** Seconds spent in a section of this rank, without sections nested in it. */
    double seconds(unsigned int section) const;

    /** Seconds since construction. */
    double total() const;

    /**
     * Table with columns section, time [s], share [%], calls [-], and the last rows "other" and
     * "total". Collective: times and calls are the largest over the ranks, so that with load
     * imbalance they add up to more than the total.
     * @throws NumericalError if the ranks have not the same number of sections.
     */
    Table report(const Communicator &communicator) const;

    /**
     * Table of what a rank sends in each section that has sent something, "other" not among them:
     * the means over the ranks of messages, their bytes, reductions and the bytes brought into
     * them, and the most messages and bytes of them of a rank, all divided by @p n_steps.
     * Collective.
     * @throws NumericalError if the ranks have not the same number of sections.
     */
    Table report_traffic(const Communicator &communicator, double n_steps) const;

  private:
    using Clock = std::chrono::steady_clock;

    struct Section
    {
      std::string        name;
      Clock::duration    time;
      unsigned long long calls;
      Traffic            traffic;
    };

    void enter(const unsigned int section)
    {
      charge_open_section();
      open_.push_back(section);
      ++sections_[section].calls;
    }

    void leave()
    {
      charge_open_section();
      open_.pop_back();
    }

    void charge_open_section()
    {
      const Clock::time_point now = Clock::now();
      sections_[open_.back()].time += now - last_;
      last_ = now;
      if (traffic_ != nullptr)
        {
          sections_[open_.back()].traffic += *traffic_ - last_traffic_;
          last_traffic_ = *traffic_;
        }
    }

    void check_sections(const Communicator &communicator) const;

    std::vector<Section>      sections_; ///< the first is "other"
    std::vector<unsigned int> open_;     ///< the innermost is the last; never empty
    Clock::time_point         start_;
    Clock::time_point         last_;
    const Traffic            *traffic_;
    Traffic                   last_traffic_; ///< when the clock was last read
  };
} // namespace vfife

#endif
