// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/case_sections.h>
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/number_list.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/quantity.h>
#include <vfife/gear/driving.h>
#include <vfife/gear/measurement/measuring_grid.h>
#include <vfife/gear/measurement/settings_fit.h>
#include <vfife/gear/spiral_bevel/gear_pair.h>
#include <vfife/output/files/figures.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/study/study_kinds.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

namespace vfife
{
  namespace
  {
    /** Section Flank fit. */
    struct FlankFitOptions
    {
      DrivingMember            member = DrivingMember::pinion;
      FlankSide                side   = FlankSide::concave;
      std::string              measured; ///< file; empty: grids alone are written
      std::vector<std::string> settings = {"point radius",
                                           "blade angle",
                                           "radial distance",
                                           "blank offset",
                                           "sliding base",
                                           "machine center to back",
                                           "machine root angle",
                                           "ratio of roll"};
      std::string              largest_changes;  ///< one for each setting; empty: no limits
      bool                     free_turn = true; ///< the flank's place about the axis is found too
      double                   threshold = 1e-3; ///< of singular values, part of the largest
      MeasuringGrid            grid;

      void declare(dealii::ParameterHandler &prm);
      /** The largest changes [internal units]; throws InputError (@p section: of the entries) where
       * they are no positive quantities of the settings. */
      std::vector<double> limits(const std::string &section) const;
    };

    /** A dimensionless setting is stored as it is written, whatever its unit is called. */
    double shown(const FittedSetting &setting, const double value)
    {
      return setting.unit == "mm" || setting.unit == "deg" ? in_unit(value, setting.unit) : value;
    }

    double root_mean_square(const std::vector<double> &values)
    {
      double sum = 0.;
      for (const double value : values)
        sum += value * value;
      return std::sqrt(sum / values.size());
    }

    double largest(const std::vector<double> &values)
    {
      double most = 0.;
      for (const double value : values)
        most = std::max(most, std::abs(value));
      return most;
    }

    class FlankFitStudy : public StudyKind
    {
    public:
      void declare(dealii::ParameterHandler &prm, const ParameterFile &) override
      {
        declare_section(prm, spiral_bevel_section, pair_);
        declare_section(prm, "Flank fit", options_);
      }

      void check() const override
      {
        pair_.check(spiral_bevel_section);
        if (!options_.measured.empty() && !is_there(options_.measured))
          throw InputError("Flank fit/measured flank",
                           "file \"" + options_.measured + "\" does not exist");
        options_.limits("Flank fit");
      }

      void inspect(Communicator &, Log &log) override
      {
        const GearPair pair(pair_);
        if (!options_.measured.empty())
          {
            log.line(read_points(pair).size(), " measured points");
            make_fit(pair);
          }
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      const GearMember &member(const GearPair &pair) const
      {
        return options_.member == DrivingMember::pinion ? pair.pinion() : pair.gear();
      }

      std::vector<Vector3> read_points(const GearPair &pair) const;
      SettingsFit          make_fit(const GearPair &pair) const;
      Json report(const MachineSettings &given, const SettingsFitResult &found, Log &log) const;
      /** fitted_pair.prm: the pair with the settings that were found. */
      void
      write_pair(const GearPair &pair, const SettingsFitResult &found, const OutputFolder &) const;

      GearPairOptions pair_;
      FlankFitOptions options_;
    };
  } // namespace

  void FlankFitOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_choice(prm,
                   "member",
                   member,
                   Choices<DrivingMember>{{"pinion", DrivingMember::pinion},
                                          {"gear", DrivingMember::gear}},
                   "Member with the measured flank");
    declare_choice(prm,
                   "flank",
                   side,
                   Choices<FlankSide>{{"concave", FlankSide::concave},
                                      {"convex", FlankSide::convex}},
                   "Measured flank");
    declare_file_name(prm,
                      "measured flank",
                      measured,
                      "Measured flank: points (columns x, y, z [mm], in the member's frame, on "
                      "tooth 0) or a grid of deviations from the designed flank [um]; empty: only "
                      "grids are written");
    declare_names(prm,
                  "settings",
                  settings,
                  "Machine settings to identify, by the names of their entries");
    declare_text(prm,
                 "largest changes",
                 largest_changes,
                 "Maximum change of each machine setting, in the same order, such as 0.1 mm, "
                 "0.2 deg; empty: no limits");
    declare_switch(prm,
                   "free turn",
                   free_turn,
                   "Also identifies the angular position of the flank about the axis");
    declare_number(prm,
                   "threshold",
                   threshold,
                   "Combinations of settings whose effect on the flank is below this part of the "
                   "largest effect are not changed",
                   Range::between(0., 0.5));
    declare_section(prm, "Grid", grid);
  }

  std::vector<double> FlankFitOptions::limits(const std::string &section) const
  {
    const std::string              entry = section + "/largest changes";
    const std::vector<std::string> texts =
      largest_changes.empty() ? std::vector<std::string>() : split_at_commas(largest_changes);
    if (!texts.empty() && texts.size() != settings.size())
      throw InputError(entry,
                       "expected one value for each of the " + std::to_string(settings.size()) +
                         " settings, in their order, or none, got " + std::to_string(texts.size()));
    std::vector<double> changes;
    for (std::size_t i = 0; i < texts.size(); ++i)
      for (const FittedSetting &setting : fitted_settings())
        if (setting.name == settings[i])
          try
            {
              const bool has_unit = setting.unit == "mm" || setting.unit == "deg";
              changes.push_back(
                read_quantity_in_range(texts[i], has_unit ? setting.unit : "-", Range::positive()));
            }
          catch (const InputError &error)
            {
              throw InputError(entry, settings[i] + ": " + error.what());
            }
    return changes;
  }

  std::vector<Vector3> FlankFitStudy::read_points(const GearPair &pair) const
  {
    return for_entry("Flank fit/measured flank", [&] {
      return read_measured_points(options_.measured, member(pair), options_.side, options_.grid);
    });
  }

  SettingsFit FlankFitStudy::make_fit(const GearPair &pair) const
  {
    const std::vector<Vector3> points = read_points(pair);
    try
      {
        return SettingsFit(member(pair),
                           options_.side,
                           options_.settings,
                           options_.free_turn,
                           options_.threshold,
                           points,
                           options_.limits("Flank fit"));
      }
    catch (const InputError &error)
      {
        throw InputError(error.entry().empty() ? "Flank fit/settings" : error.entry(),
                         error.what());
      }
  }

  Json FlankFitStudy::report(const MachineSettings   &given,
                             const SettingsFitResult &found,
                             Log                     &log) const
  {
    const double before = root_mean_square(found.before) / micrometre,
                 after  = root_mean_square(found.after) / micrometre;
    log.line(found.before.size(),
             " points, ",
             found.iterations,
             " steps, ",
             found.directions,
             " independent changes");
    log.line("deviation             ",
             before,
             " um before, ",
             after,
             " um after (root mean square); largest ",
             largest(found.after) / micrometre,
             " um");
    if (!found.unfinished.empty())
      log.warning("flank fit: " + found.unfinished + ". The best settings found are used");
    for (const std::string &name : found.at_limit)
      log.warning(
        "flank fit: " + name +
        " is at its limit (Flank fit/largest changes); the flank requires a larger change");
    Json json                       = figures_json({{"points", {double(found.before.size()), "-"}},
                                                    {"independent changes", {double(found.directions), "-"}},
                                                    {"root mean square before", {before, "um"}},
                                                    {"root mean square after", {after, "um"}},
                                                    {"largest before", {largest(found.before) / micrometre, "um"}},
                                                    {"largest after", {largest(found.after) / micrometre, "um"}},
                                                    {"turn about the axis", {found.turn / arcsecond, "arcsec"}}});
    json["came to rest"]            = found.unfinished.empty();
    json["at their largest change"] = found.at_limit;
    json["member"]                  = vfife::name_of(options_.member);
    json["flank"]                   = name_of(options_.side);
    for (const FittedSetting &setting : fitted_settings())
      {
        const double is  = shown(setting, found.settings.*setting.value),
                     was = shown(setting, given.*setting.value);
        const bool free =
          std::count(options_.settings.begin(), options_.settings.end(), setting.name);
        if (!free)
          continue;
        log.line("  ", setting.name, " ", was, " -> ", is, " ", setting.unit);
        json["settings"][setting.name] = figures_json({{"given", {was, setting.unit}},
                                                       {"found", {is, setting.unit}},
                                                       {"change", {is - was, setting.unit}}});
      }
    return json;
  }

  void FlankFitStudy::write_pair(const GearPair          &pair,
                                 const SettingsFitResult &found,
                                 const OutputFolder      &folder) const
  {
    GearPairOptions    options = pair.options();
    GearMemberOptions &own =
      options_.member == DrivingMember::pinion ? options.pinion : options.gear;
    own.settings(options_.side) = found.settings;
    // each flank has all of its own now, and nothing is to be proposed
    own.both         = GearMemberOptions().both;
    own.point_width  = 0.;
    options.proposal = PairProposal();
    dealii::ParameterHandler prm;
    declare_section(prm, spiral_bevel_section, options);
    const AbsoluteFileNames absolute(prm);
    folder.write_file("fitted_pair.prm", [&](std::ostream &out) { print_parameters(out, prm); });
  }

  void FlankFitStudy::run(OutputFolder &folder, Log &log)
  {
    const GearPair pair(pair_);
    if (folder.is_writer())
      for (const GearMember *each : {&pair.pinion(), &pair.gear()})
        for (const FlankSide side : {FlankSide::concave, FlankSide::convex})
          write_csv(folder,
                    "grid_" + each->name() + "_" + name_of(side) + ".csv",
                    compute_measuring_grid(*each, side, 0, options_.grid));
    Json json = Json::object();
    if (!options_.measured.empty())
      {
        const SettingsFitResult found = make_fit(pair).solve();
        json = report(member(pair).generated_flank(options_.side).settings(), found, log);
        if (folder.is_writer())
          {
            write_csv(folder, "flank_fit.csv", fit_table(found));
            write_pair(pair, found, folder);
          }
      }
    // last: it says that the study has come to its end
    if (folder.is_writer())
      write_json(folder, "flank_fit.json", json);
  }

  std::unique_ptr<StudyKind> make_flank_fit_study()
  {
    return std::make_unique<FlankFitStudy>();
  }
} // namespace vfife
