// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/number_list.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/quantity.h>
#include <vfife/model/transmission.h>
#include <vfife/study/pressure/instant_options.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Each takes from a tenth of a second to seconds. */
    constexpr std::size_t most_instants = 1000;

    std::string path_of(const char *entry)
    {
      return std::string(InstantOptions::section) + "/" + entry;
    }

    /** To as many digits as a message needs. */
    std::string rounded(const double value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }

    struct Instant
    {
      double value;
      bool   is_time; ///< [s], else mesh cycles
    };

    /** A number alone counts mesh cycles. */
    Instant read_instant(const std::string &text)
    {
      const std::optional<double> meshes = plain_number(text);
      const Instant               instant =
        meshes ? Instant{*meshes, false} : Instant{parse_quantity(text, "s"), true};
      if (!(instant.value >= 0.))
        throw InputError("lies before the start of the run");
      return instant;
    }

    Instant read_entry(const std::string &text)
    {
      try
        {
          return read_instant(text);
        }
      catch (const InputError &error)
        {
          throw InputError(path_of("instants"), "\"" + text + "\": " + error.what());
        }
    }
  } // namespace

  void InstantOptions::declare(dealii::ParameterHandler &prm)
  {
    const Subsection subsection(prm, section);
    declare_number_list(
      prm,
      "instants",
      instants,
      "Instants at which pressures of all teeth in contact are computed on the "
      "contact's own grid, independent of mesh and penalty: mesh cycles since the "
      "start, as 12.5, or times, as 1.4 ms");
    declare_number(prm,
                   "every",
                   every,
                   "Interval of further such instants at the end of the run, in mesh cycles, as "
                   "0.125",
                   Range::positive().or_word("none"));
    declare_number(prm,
                   "last",
                   last,
                   "Length of the end of the run with these instants, in mesh cycles; 1 covers "
                   "the whole engagement of a tooth; whole run: the whole run",
                   Range::positive().or_word("whole run"));
    declare_integer(prm,
                    "pressure cells",
                    cells,
                    "Elements of the contact's own grid across the width of each contact; 10 to "
                    "20 are sufficient",
                    4,
                    64);
    declare_quantity(prm,
                     "pressure depth",
                     depth,
                     "mm",
                     "Minimum depth of the layer under the flanks whose flexibility is exact on "
                     "that grid; auto: one and a half Hertzian contact widths under the whole load",
                     Range::positive().or_word("auto"));
  }

  void InstantOptions::check() const
  {
    for (const std::string &text : instants)
      read_entry(text);
  }

  std::string InstantOptions::asking_entry() const
  {
    return path_of(every > 0 ? "every" : "instants");
  }

  std::vector<double> InstantOptions::find_times(const Transmission &pair,
                                                 const double        end_time) const
  {
    const double        end = pair.meshes(end_time);
    std::vector<double> times;
    const auto          say_end = [&] {
      return "the end of the run, after " + rounded(end) + " mesh cycles, " +
             rounded(1e3 * end_time) + " ms";
    };
    for (const std::string &text : instants)
      {
        const Instant instant = read_entry(text);
        // To what round-off makes of the end.
        const double at = instant.is_time ? pair.meshes(instant.value) : instant.value;
        if (at > end * (1. + 1e-9))
          throw InputError(path_of("instants"), "\"" + text + "\" lies after " + say_end());
        times.push_back(instant.is_time ? instant.value : pair.time_of(std::min(at, end)));
      }
    if (every > 0)
      {
        if (last > end * (1. + 1e-9))
          throw InputError(path_of("last"), rounded(last) + " mesh cycles lie before " + say_end());
        const double span = last > 0 ? last : end;
        if (every > span * (1. + 1e-9))
          throw InputError(path_of("every"),
                           rounded(every) + " mesh cycles are more than the " + rounded(span) +
                             " with such instants (" + path_of("last") + ")");
        // The end stands where the first of them does, a mesh cycle or several later.
        const double n = std::ceil(span / every * (1. - 1e-9));
        if (n > most_instants)
          throw InputError(path_of("every"),
                           "expected at most " + std::to_string(most_instants) + " instants, got " +
                             rounded(n));
        for (unsigned int i = 0; i < n; ++i)
          times.push_back(pair.time_of(std::max(0., end - span) + i * every));
      }
    if (times.size() > most_instants)
      throw InputError(path_of("instants"),
                       "expected at most " + std::to_string(most_instants) + " instants, got " +
                         std::to_string(times.size()));
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(),
                            times.end(),
                            [&](const double a, const double b) {
                              return b - a <= 1e-9 * end_time;
                            }),
                times.end());
    return times;
  }
} // namespace vfife
