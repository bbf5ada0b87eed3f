// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/json.h>
#include <vfife/output/files/result_places.h>

#include <nlohmann/json.hpp>

namespace vfife
{
  namespace
  {
    /** The pointer to the member @p name of what is at @p place; names may have any characters. */
    std::string below(const std::string &place, const std::string &name)
    {
      return (Json::json_pointer(place) / name).to_string();
    }
  } // namespace

  // Names may hold a slash, which a pointer of JSON would take for a step down: below() escapes it.
  std::string summary_place::figure(const std::string &name)
  {
    return below(figures, name);
  }

  std::string summary_place::part_of_error(const std::string &name)
  {
    return below(transmission_error, name);
  }

  std::string summary_place::misalignment_of(const std::string &column)
  {
    return below(misalignment, column);
  }

  std::string summary_place::passage_of(const std::string &probe)
  {
    return below(below(probes, probe), passes_mesh);
  }

  std::string summary_place::steady_mean(const std::string &column)
  {
    return below(below(steady_columns, column), "mean");
  }

  std::string summary_place::steady_peak_to_peak(const std::string &column)
  {
    return below(below(steady_columns, column), "peak to peak");
  }

  std::string figure_name::speed_of(const std::string &body)
  {
    return body + " speed";
  }

  std::string figure_name::torque_of(const std::string &body)
  {
    return body + " torque";
  }

  std::string lumped_place::first_frequency()
  {
    return below(below(below("", modes), "0"), frequency);
  }

  std::string lumped_place::response_figure(const std::string &column)
  {
    return below(below("", response), column);
  }
} // namespace vfife
