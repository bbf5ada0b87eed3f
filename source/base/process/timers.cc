// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/timers.h>

namespace vfife
{
  Timers::Timers(const Traffic *const traffic)
    : start_(Clock::now())
    , last_(start_)
    , traffic_(traffic)
    , last_traffic_(traffic != nullptr ? *traffic : Traffic())
  {
    sections_.push_back({"other", Clock::duration::zero(), 0, {}});
    // Deep enough for all nested sections, so that entering one never allocates.
    open_.reserve(32);
    open_.push_back(0);
  }

  unsigned int Timers::section(const std::string &name)
  {
    for (unsigned int i = 0; i < sections_.size(); ++i)
      if (sections_[i].name == name)
        return i;
    sections_.push_back({name, Clock::duration::zero(), 0, {}});
    return sections_.size() - 1;
  }

  double Timers::seconds(const unsigned int section) const
  {
    Clock::duration time = sections_.at(section).time;
    // The open section has not been charged since the clock was last read.
    if (section == open_.back())
      time += Clock::now() - last_;
    return std::chrono::duration<double>(time).count();
  }

  double Timers::total() const
  {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

  void Timers::check_sections(const Communicator &communicator) const
  {
    const unsigned int n = sections_.size();
    if (communicator.min(n) != communicator.max(n))
      throw NumericalError("the ranks time different sections");
  }

  Table Timers::report(const Communicator &communicator) const
  {
    check_sections(communicator);
    const unsigned int n = sections_.size();

    // Time and calls of each section and the total, reduced over the ranks at once.
    std::vector<double> figures;
    for (unsigned int i = 0; i < n; ++i)
      {
        figures.push_back(seconds(i));
        figures.push_back(static_cast<double>(sections_[i].calls));
      }
    figures.push_back(total());
    communicator.max(figures);

    Table table{{"section"}, {"time", "s"}, {"share", "%"}, {"calls", "-"}};
    // Maxima over the ranks: the sections may add up to more than the total.
    const double total_time = figures.back();
    const auto   add        = [&](const unsigned int i) {
      const double time = figures[2 * i];
      table.add_row({sections_[i].name,
                     time,
                     total_time > 0. ? 100. * time / total_time : 0.,
                     figures[2 * i + 1]});
    };
    for (unsigned int i = 1; i < n; ++i)
      add(i);
    add(0);
    table.add_row({"total", total_time, 100., 1});
    return table;
  }

  Table Timers::report_traffic(const Communicator &communicator, const double n_steps) const
  {
    check_sections(communicator);
    std::vector<double> sums, largest;
    for (const Section &section : sections_)
      {
        const Traffic &t        = section.traffic;
        const double   messages = static_cast<double>(t.messages),
                     bytes      = static_cast<double>(t.message_bytes);
        sums.insert(sums.end(),
                    {messages,
                     bytes,
                     static_cast<double>(t.reductions),
                     static_cast<double>(t.reduction_bytes)});
        largest.insert(largest.end(), {messages, bytes});
      }
    communicator.sum(sums);
    communicator.max(largest);

    Table table;
    table.add_text_column("section");
    table.add_column("messages", "-");
    table.add_column("bytes of messages", "B");
    table.add_column("reductions", "-");
    table.add_column("bytes of reductions", "B");
    table.add_column("most messages of a rank", "-");
    table.add_column("most bytes of messages of a rank", "B");
    const double of_ranks = communicator.size() * n_steps;
    for (std::size_t i = 1; i < sections_.size(); ++i)
      if (const double *sum = sums.data() + 4 * i; sum[0] > 0 || sum[2] > 0)
        table.add_row({sections_[i].name,
                       sum[0] / of_ranks,
                       sum[1] / of_ranks,
                       sum[2] / of_ranks,
                       sum[3] / of_ranks,
                       largest[2 * i] / n_steps,
                       largest[2 * i + 1] / n_steps});
    return table;
  }
} // namespace vfife
