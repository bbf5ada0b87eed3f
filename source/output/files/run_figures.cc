// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/output/files/run_figures.h>

#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>

namespace vfife
{
  namespace
  {
    /** A number of summary.json: column of a table of runs, unit, and where it stands. */
    struct Place
    {
      std::string name, unit, pointer;
    };

    const std::vector<Place> places = {
      {"steps", "-", "/run/steps"},
      {"time", "s", "/run/time/value"},
      {"run time", "s", "/run/run time/value"},
      {"energy error", "-", "/energy/error/value"},
      {"contact losses", "-", "/contact losses/count"},
      {"steady", "-", "/steady part/found"},
      {"contact force mean", "N", "/steady part/columns/contact force total/mean"},
      {"contact force peak to peak", "N", "/steady part/columns/contact force total/peak to peak"},
      {"dte mean", "arcsec", "/steady part/columns/dte/mean"},
      {"dte peak to peak", "arcsec", "/steady part/columns/dte/peak to peak"},
      {"rim dte mean", "arcsec", "/steady part/columns/rim dte/mean"},
      {"rim dte peak to peak", "arcsec", "/steady part/columns/rim dte/peak to peak"},
      {"dte at the start", "arcsec", "/transmission error/total at the start/value"},
      {"teeth and rest", "arcsec", "/transmission error/teeth and rest/value"},
      {"web windup", "arcsec", "/transmission error/web windup/value"},
      {"rim tilt and shift", "arcsec", "/transmission error/rim tilt and shift/value"},
      {"centrifugal shift", "arcsec", "/transmission error/centrifugal shift/value"},
      {"swing frequency", "Hz", "/figures/swing frequency, estimated/value"}};

    /** Numbers, and yes or no as 1 or 0; NaN for what is missing or null. */
    double read_number(const Json &json, const std::string &pointer)
    {
      const Json::json_pointer place(pointer);
      if (json.contains(place))
        {
          const Json &value = json.at(place);
          if (value.is_number())
            return value.get<double>();
          if (value.is_boolean())
            return value.get<bool>() ? 1 : 0;
        }
      return std::numeric_limits<double>::quiet_NaN();
    }

    /** Null where there is no file, discarded where it is no JSON. */
    Json read_json(const std::string &path)
    {
      std::ifstream file(path);
      return file ? Json::parse(file, nullptr, false) : Json();
    }
  } // namespace

  double read_figure(const std::string &path, const std::string &pointer)
  {
    const Json json = read_json(path);
    return json.is_structured() ? read_number(json, pointer)
                                : std::numeric_limits<double>::quiet_NaN();
  }

  RunFigures read_run_figures(const std::string &folder)
  {
    RunFigures run;
    const Json json = read_json(folder + "/summary.json");
    if (json.is_object())
      {
        run.status  = json.value("status", "");
        run.failure = json.value("failure", "");
      }
    for (const Place &place : places)
      run.figures.emplace_back(place.name, Figure{read_number(json, place.pointer), place.unit});
    return run;
  }
} // namespace vfife
