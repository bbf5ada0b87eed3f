// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/former_result_names.h>
#include <vfife/base/types.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/measures/root_stress.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace vfife
{
  namespace
  {
    /** A number of summary.json: column of a table of runs, unit, and where it stands. */
    struct Place
    {
      std::string name, unit, pointer;
      bool        is_of_computation = false;
    };

    /** The columns of a table of runs. */
    std::vector<Place> list_places()
    {
      using namespace summary_place;
      return {{"steps", "-", steps, true},
              {column::time, "s", summary_place::time, true},
              {"run time", "s", run_time, true},
              {column::energy_error, "-", energy_error, true},
              {"contact losses", "-", n_contact_losses},
              {"steady", "-", is_steady, true},
              {"ripple steady", "-", is_ripple_steady, true},
              {"contact force mean", "N", steady_mean(column::contact_force_total)},
              {"contact force peak to peak", "N", steady_peak_to_peak(column::contact_force_total)},
              {"dte mean", "arcsec", steady_mean(column::dte)},
              {"dte peak to peak", "arcsec", steady_peak_to_peak(column::dte)},
              {"rim dte mean", "arcsec", steady_mean(column::rim_dte)},
              {"rim dte peak to peak", "arcsec", steady_peak_to_peak(column::rim_dte)},
              {"dte at the start", "arcsec", part_of_error(error_part::total)},
              {"teeth and rest", "arcsec", part_of_error(error_part::teeth_and_rest)},
              {"web windup", "arcsec", part_of_error(error_part::web_windup)},
              {"rim tilt and shift", "arcsec", part_of_error(error_part::rim_tilt_and_shift)},
              {error_part::rim_bending, "arcsec", part_of_error(error_part::rim_bending)},
              {"centrifugal shift", "arcsec", part_of_error(error_part::centrifugal_shift)},
              {"bearings", "arcsec", part_of_error(error_part::bearings)},
              {"shaft bending", "arcsec", part_of_error(error_part::shaft_bending)},
              {column::offset, "um", misalignment_of(column::offset)},
              {column::pinion_axial_shift, "um", misalignment_of(column::pinion_axial_shift)},
              {column::gear_axial_shift, "um", misalignment_of(column::gear_axial_shift)},
              {column::shaft_angle_error, "arcmin", misalignment_of(column::shaft_angle_error)},
              {"torsional mode frequency", "Hz", figure(figure_name::torsional_frequency)}};
    }

    /** A number, yes or no as 1 or 0, the value of a figure; NaN for what is missing or null. */
    double read_number(const Json &json, const std::string &pointer)
    {
      const Json::json_pointer place(pointer);
      const Json              *found = json.contains(place) ? &json.at(place) : nullptr;
      // Figures are objects {"value": ..., "unit": ...}; counts are plain numbers.
      if (found != nullptr && found->is_object())
        found = found->contains("value") ? &found->at("value") : nullptr;
      if (found != nullptr && found->is_number())
        return found->get<double>();
      if (found != nullptr && found->is_boolean())
        return found->get<bool>() ? 1 : 0;
      return not_known;
    }

    bool ends_with(const std::string &figure, const std::string &name)
    {
      return figure.size() > name.size() &&
             figure.compare(figure.size() - name.size(), name.size(), name) == 0;
    }

    /** Names of the figures of a fillet's stresses behind that of a member. */
    struct FilletNames
    {
      const std::string tension, compression, range;

      explicit FilletNames(const bool at_hub)
        : tension(place(at_hub) + column::tension)
        , compression(place(at_hub) + column::compression)
        , range(place(at_hub) + "stress range")
      {
      }

      static std::string place(const bool at_hub)
      {
        return at_hub ? " hub fillet " : " root ";
      }
      bool end(const std::string &figure) const
      {
        return ends_with(figure, tension) || ends_with(figure, compression) ||
               ends_with(figure, range);
      }
    };

    /** The same with members by their present names. */
    Json with_present_names(const std::string &file, const Json &json)
    {
      if (!json.is_structured())
        return json;
      Json same = json.is_array() ? Json::array() : Json::object();
      for (const auto &[name, value] : json.items())
        if (json.is_array())
          same.push_back(with_present_names(file, value));
        else
          same[present_result_name(file, name)] = with_present_names(file, value);
      return same;
    }

    /** Null where there is no file, discarded where it is no JSON. */
    Json read_json(const std::string &path)
    {
      std::ifstream file(path);
      return file ? with_present_names(std::filesystem::path(path).filename().string(),
                                       Json::parse(file, nullptr, false))
                  : Json();
    }

    /** Figures by names that depend on the case: those of figures.json; of summary.json root
     * stresses, pressures on grids of their own, and of each probe largest and median stress per
     * revolution. */
    Json read_figures_of_case(const std::string &folder)
    {
      Json       figures = read_json(folder + "/figures.json");
      const Json summary = read_json(folder + "/summary.json");
      if (!figures.is_object())
        figures = Json::object();
      const auto for_each = [&summary](const char *place, const auto &take) {
        const Json::json_pointer pointer(place);
        if (summary.is_structured() && summary.contains(pointer))
          for (const auto &[name, value] : summary.at(pointer).items())
            take(name, value);
      };
      const FilletNames roots(false), hubs(true);
      for_each(summary_place::figures, [&](const std::string &name, const Json &figure) {
        if (roots.end(name) || hubs.end(name) || ends_with(name, figure_name::on_own_grid) ||
            ends_with(name, figure_name::stress_of_part) ||
            name == figure_name::nearest_wave_speed || name == figure_name::nearest_wave_distance)
          figures[name] = figure;
      });
      for_each(summary_place::probes, [&](const std::string &name, const Json &probe) {
        for (const char *stress :
             {summary_place::largest_of_revolution, summary_place::median_of_revolution})
          if (probe.contains(stress))
            figures[name + " " + stress] = probe.at(stress);
      });
      return figures;
    }
  } // namespace

  double read_figure(const std::string &path, const std::string &pointer)
  {
    const Json json = read_json(path);
    return json.is_structured() ? read_number(json, pointer) : not_known;
  }

  NamedFigures read_geometry(const std::string &folder)
  {
    NamedFigures quantities;
    const Json   json = read_json(folder + "/geometry.json");
    if (json.is_object())
      for (const auto &[member, all] : json.items())
        for (const auto &[name, one] : all.items())
          if (one.is_object() && one.contains("value") && one["value"].is_number())
            quantities.push_back(
              {member + " " + name, {one["value"].get<double>(), one.value("unit", "")}});
    return quantities;
  }

  bool tells_of_computation(const std::string &figure)
  {
    const std::vector<Place> places = list_places();
    return std::any_of(places.begin(), places.end(), [&figure](const Place &place) {
      return place.name == figure && place.is_of_computation;
    });
  }

  RunFigures read_run_figures(const std::string &folder)
  {
    RunFigures run;
    const Json json = read_json(folder + "/summary.json");
    if (json.is_object())
      {
        run.status  = json.value(Json::json_pointer(summary_place::status), "");
        run.failure = json.value(Json::json_pointer(summary_place::failure), "");
      }
    // Every run has all columns; one that has failed or is still to come has NaN.
    for (const Place &place : list_places())
      run.figures.emplace_back(place.name, Figure{read_number(json, place.pointer), place.unit});
    return run;
  }

  NamedFigures list_root_figures(const RootStress &stress)
  {
    NamedFigures figures;
    for (const MemberFilletStress &member : stress.list_members())
      {
        const FilletNames names(member.at_hub);
        figures.push_back({member.body + names.tension, {member.tension, "MPa"}});
        figures.push_back({member.body + names.compression, {member.compression, "MPa"}});
        figures.push_back({member.body + names.range, {member.range, "MPa"}});
      }
    return figures;
  }

  void write_own_figures(const OutputFolder &folder, const NamedFigures &figures)
  {
    write_json(folder, "figures.json", figures_json(figures));
  }

  std::vector<NamedFigures> read_own_figures(const std::vector<std::string> &folders)
  {
    // Names in the order in which cases have them, each with the unit of the first that has it.
    std::vector<Json> files;
    NamedFigures      names;
    for (const std::string &folder : folders)
      {
        files.push_back(read_figures_of_case(folder));
        for (const auto &[name, figure] : files.back().items())
          if (figure.is_object() &&
              std::none_of(names.begin(), names.end(), [&name = name](const auto &known) {
                return known.first == name;
              }))
            names.push_back({name, {not_known, figure.value("unit", "-")}});
      }
    std::vector<NamedFigures> all(folders.size(), names);
    for (std::size_t i = 0; i < folders.size(); ++i)
      for (auto &[name, figure] : all[i])
        figure.value = read_number(files[i], (Json::json_pointer() / name).to_string());
    return all;
  }
} // namespace vfife
