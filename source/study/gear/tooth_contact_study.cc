// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/case_sections.h>
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/json.h>
#include <vfife/base/types.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>
#include <vfife/gear/unloaded_contact/tooth_form.h>
#include <vfife/gear/unloaded_contact/unequal_teeth.h>
#include <vfife/output/files/figures.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/output_options.h>
#include <vfife/output/pictures.h>
#include <vfife/study/cases/gear/gear_case.h>
#include <vfife/study/start_summary.h>
#include <vfife/study/study_kinds.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace vfife
{
  namespace
  {
    /** A point of a flank: where it is in the meridian plane (L, h) and in space, normal and
     * principal curvatures. */
    Json point_json(const SurfacePoint &point, const Vector2 &L_h, const Vector2 &curvatures)
    {
      // In the member's frame as it is generated, before the turn onto a tooth.
      NamedFigures figures = {{"L", {L_h[0], "mm"}}, {"h", {L_h[1], "mm"}}};
      const char  *names[] = {"x", "y", "z"};
      for (unsigned int i = 0; i < 3; ++i)
        figures.push_back({names[i], {point.position[i], "mm"}});
      for (unsigned int i = 0; i < 3; ++i)
        figures.push_back({std::string("normal ") + names[i], {point.normal[i], "-"}});
      figures.push_back({"smaller principal curvature", {curvatures[0], "1/mm"}});
      figures.push_back({"larger principal curvature", {curvatures[1], "1/mm"}});
      return figures_json(figures);
    }

    /** Who drives, how the members turn about + their axes, and what that makes of the contact. */
    Json working_json(const GearPair &pair, const ContactAnalysisOptions &options)
    {
      const bool   pinion_drives = options.driving == DrivingMember::pinion;
      const double sense         = options.direction == TurningDirection::forward ? 1. : -1.;
      const double ratio         = pinion_drives ? pair.speed_ratio() : 1. / pair.speed_ratio();
      // the driver's torque acts with its rotation, the load against that of the driven member
      const double on_pinion = pinion_drives ? sense : -sense, on_gear = on_pinion;
      Json         json             = figures_json({{"pinion turns", {sense, "-"}},
                                                    {"gear turns", {-sense, "-"}},
                                                    {"torque on the pinion", {on_pinion, "-"}},
                                                    {"torque on the gear", {on_gear, "-"}},
                                                    {"driven speed over driver speed", {ratio, "-"}}});
      json["driving member"]        = name_of(options.driving);
      json["direction of rotation"] = name_of(options.direction);
      json["side"]                  = side_name(options.working_side());
      return json;
    }

    /** All that tca.json says of one side of the pair. Places on the path are in pitches, angles of
     * the gear in arcsec; @p gear_pitch [rad]. */
    Json side_json(const ContactAnalysis &a, const double gear_pitch)
    {
      // Names as a designer reads them; numbers with their units, places on the path in pitches.
      const ContactEllipse &ellipse = a.mean.ellipse;
      Json                  json;
      json["mean contact on the generated pinion flank"] =
        point_json(a.mean.contact.pinion, a.mean.contact.pinion_L_h, a.pinion_curvatures);
      json["mean contact on the generated gear flank"] =
        point_json(a.mean.contact.gear, a.mean.contact.gear_L_h, a.gear_curvatures);
      json["ellipse at the mean contact"] = figures_json(
        {{"smaller relative curvature", {ellipse.relative_curvatures[0], "1/mm"}},
         {"larger relative curvature", {ellipse.relative_curvatures[1], "1/mm"}},
         {"semi-axis a", {ellipse.semi_axes[0], "mm"}},
         {"semi-axis b", {ellipse.semi_axes[1], "mm"}},
         {"major axis to the lengthwise direction", {a.mean.major_angle / degree, "deg"}}});
      json["path"] =
        figures_json({{"start", {a.ends[0].place, "pitches"}},
                      {"end", {a.ends[1].place, "pitches"}},
                      {"contact ratio", {a.contact_ratio, "-"}},
                      {"gear L at the start", {a.path.front().contact.gear_L_h[0], "mm"}},
                      {"gear L at the end", {a.path.back().contact.gear_L_h[0], "mm"}},
                      {"angle to the lengthwise direction", {a.path_angle / degree, "deg"}}});
      json["path"]["ended by"] = {a.ends[0].border, a.ends[1].border};
      // Beyond either end of the path an edge may remain in contact.
      for (const unsigned int i : {0u, 1u})
        {
          const PathEnd &end  = a.ends[i];
          Json          &part = json[i == 0 ? "beyond the start" : "beyond the end"];
          part =
            figures_json({{"edge contact starts at", {end.place, "pitches"}},
                          {"lag", {end.lag / arcsecond, "arcsec"}},
                          {"edge stays in contact for", {end.reach, "pitches"}},
                          {"approach before edge contact", {end.approach / arcsecond, "arcsec"}}});
          part["border"]  = end.border;
          part["is edge"] = end.is_edge;
        }

      // The lag as sum c_i p^i [arcsec] over the place p on the path [pitches].
      NamedFigures lag;
      for (unsigned int i = 0; i < 2; ++i)
        lag.push_back({"power " + std::to_string(i), {a.lag_offset[i] / arcsecond, "arcsec"}});
      for (unsigned int i = 0; i < 3; ++i)
        lag.push_back(
          {"power " + std::to_string(i + 2), {a.lag_polynomial[i] / arcsecond, "arcsec"}});
      lag.push_back({"largest deviation of the polynomial", {a.fit_error / arcsecond, "arcsec"}});
      json["lag over pitches"]                 = figures_json(lag);
      json["transfer point inside the flanks"] = a.hands_over && !a.over_an_edge;
      json["has a transfer point"]             = a.hands_over;
      if (a.hands_over)
        json["transfer point"] =
          figures_json({{"place", {a.hand_over, "pitches"}},
                        {"lag", {a.hand_over_lag / arcsecond, "arcsec"}},
                        {"peak to peak", {a.peak_to_peak / arcsecond, "arcsec"}},
                        {"share of the gear's pitch", {a.peak_to_peak / gear_pitch, "-"}}});
      return json;
    }

    /** A number with a fixed number of decimals, for the log. */
    std::string fixed(const double value, const int decimals)
    {
      char text[64];
      std::snprintf(text, sizeof text, "%.*f", decimals, value);
      return text;
    }

    /** Figures of the teeth at some sections of both members, with units: the part "teeth" of
     * tca.json. */
    Json form_json(const ToothForms &forms)
    {
      Json json = figures_json({{"backlash angle of the gear", {forms.play / arcsecond, "arcsec"}},
                                {"normal backlash", {forms.backlash, "mm"}}});
      for (const auto *member : {&forms.pinion, &forms.gear})
        for (const ToothSection &section : *member)
          json[member == &forms.pinion ? "pinion" : "gear"][section.place] =
            figures_json({{"cone distance", {section.cone_distance, "mm"}},
                          {"transverse thickness", {section.thickness, "mm"}},
                          {"tip land", {section.tip_land, "mm"}},
                          {"root clearance", {section.root_clearance, "mm"}},
                          {"mating tip over the fillet", {section.fillet_distance, "mm"}},
                          {"undercut indicator at the fillet", {section.regularity, "-"}}});
      return json;
    }

    /** A table of the same, play, backlash and the warnings. */
    void log_forms(const ToothForms &forms, Log &log)
    {
      log.line(
        "teeth (mm)            thickness  tip land  root clearance  tip over fillet  undercut "
        "indicator");
      for (const auto *member : {&forms.pinion, &forms.gear})
        for (const ToothSection &section : *member)
          {
            char row[128], over_fillet[32] = "not known";
            if (std::isfinite(section.fillet_distance))
              std::snprintf(over_fillet, sizeof over_fillet, "%.3f", section.fillet_distance);
            std::snprintf(row,
                          sizeof row,
                          "  %-7s %-7s %14.3f %9.3f %15.3f %16s %19.2f",
                          member == &forms.pinion ? "pinion" : "gear",
                          section.place.c_str(),
                          section.thickness,
                          section.tip_land,
                          section.root_clearance,
                          over_fillet,
                          section.regularity);
            log.line(row);
          }
      char play[128] = "backlash as mounted   not known: no contact inside the flanks of one side";
      if (std::isfinite(forms.play))
        std::snprintf(
          play,
          sizeof play,
          "backlash as mounted   %.4f mm normal at the mean point, %.1f arcsec at the gear",
          forms.backlash,
          forms.play / arcsecond);
      log.line(play);
      for (const std::string &message : forms.findings.warnings())
        log.warning(message);
    }

    /** What a designer looks at first, of one side. */
    void log_side(const ContactAnalysis &a, Log &log)
    {
      // L along the cone and h above the pitch cone in mm, places on the path in pitches, lags of
      // the gear in arcsec.
      const UnloadedContactPoint &p = a.mean.contact;
      log.line(side_name(a.side), " side");
      log.line("  mean contact        pinion L ",
               fixed(p.pinion_L_h[0], 3),
               ", h ",
               fixed(p.pinion_L_h[1], 3),
               " mm; gear L ",
               fixed(p.gear_L_h[0], 3),
               ", h ",
               fixed(p.gear_L_h[1], 3),
               " mm");
      log.line("  path                ",
               fixed(a.ends[0].place, 3),
               " (",
               a.ends[0].border,
               ") to ",
               fixed(a.ends[1].place, 3),
               " (",
               a.ends[1].border,
               ") pitches, contact ratio ",
               fixed(a.contact_ratio, 2),
               ", ",
               fixed(a.path_angle / degree, 1),
               " deg to the lengthwise direction");
      log.line("  ellipse             ",
               fixed(a.mean.ellipse.semi_axes[0], 3),
               " x ",
               fixed(a.mean.ellipse.semi_axes[1], 3),
               " mm semi-axes, major axis at ",
               fixed(a.mean.major_angle / degree, 1),
               " deg");
      std::string polynomial;
      for (unsigned int i = 0; i < 2; ++i)
        if (a.lag_offset[i] != 0.)
          polynomial += fixed(a.lag_offset[i] / arcsecond, 3) + (i == 0 ? " " : " p ");
      for (unsigned int i = 0; i < 3; ++i)
        polynomial +=
          fixed(a.lag_polynomial[i] / arcsecond, 3) + " p^" + std::to_string(i + 2) + " ";
      log.line("  lag of the gear     ",
               polynomial,
               "arcsec (p pitches; within ",
               fixed(a.fit_error / arcsecond, 4),
               ")");
      log.line("  edge contact        after ",
               fixed(a.ends[0].approach / arcsecond, 1),
               " and ",
               fixed(a.ends[1].approach / arcsecond, 1),
               " arcsec of approach at these ends");
      if (a.hands_over)
        log.line("  transfer point      at p = ",
                 fixed(a.hand_over, 3),
                 " with ",
                 fixed(a.hand_over_lag / arcsecond, 3),
                 " arcsec, ",
                 fixed(a.peak_to_peak / arcsecond, 3),
                 " arcsec peak to peak");
      else
        log.warning(side_name(a.side),
                    a.contact_ratio < 1.
                      ? " side: contact is interrupted before the next tooth pair engages (contact "
                        "ratio below 1)"
                      : " side: no transfer point on the flanks: contact passes to the next tooth "
                        "pair at an edge");
      if (a.over_an_edge)
        log.warning(side_name(a.side),
                    " side: the path of contact ends before the next tooth pair engages; there an "
                    "edge is in contact");
    }

    /** What can be said of blanks and settings before flanks are generated. */
    void warn(const GearPairOptions &options, Log &log)
    {
      for (const std::string &message : options.examine().warnings())
        log.warning(message);
    }

    /** pair.prm: blanks and settings with everything derived or proposed, as a parameter file. */
    void write_pair(const GearPair &pair, const OutputFolder &folder)
    {
      GearPairOptions options = pair.options();
      // What was proposed stands among the settings now: read again, nothing is to be proposed.
      options.proposal = PairProposal();
      dealii::ParameterHandler prm;
      declare_section(prm, spiral_bevel_section, options);
      // measured errors stay where they are
      const AbsoluteFileNames absolute(prm);
      folder.write_file("pair.prm", [&](std::ostream &out) { print_parameters(out, prm); });
    }

    void log_derived(const GearPair &pair, Log &log)
    {
      const GearPairOptions &o = pair.options();
      log.line("pair ",
               o.pinion.blank.teeth,
               "/",
               o.gear.blank.teeth,
               ": ratio of roll gear ",
               o.gear.concave.ratio_of_roll,
               " (concave), ",
               o.gear.convex.ratio_of_roll,
               " (convex), pinion ",
               fixed(o.pinion.concave.ratio_of_roll, 9),
               " (concave), ",
               fixed(o.pinion.convex.ratio_of_roll, 9),
               " (convex)");
    }

    /** For tables of several analyses. */
    NamedFigures list_figures(const std::vector<ContactAnalysis> &sides)
    {
      NamedFigures figures;
      for (const ContactAnalysis &a : sides)
        {
          const std::string of = side_name(a.side) + std::string(" side, ");
          figures.push_back({of + "contact ratio", {a.contact_ratio, "-"}});
          figures.push_back({of + "path angle", {a.path_angle / degree, "deg"}});
          figures.push_back({of + "ellipse semi-axis a", {a.mean.ellipse.semi_axes[0], "mm"}});
          figures.push_back({of + "mean contact L", {a.mean.contact.gear_L_h[0], "mm"}});
          figures.push_back({of + "mean contact h", {a.mean.contact.gear_L_h[1], "mm"}});
          for (const unsigned int i : {0u, 1u})
            if (a.ends[i].is_edge)
              figures.push_back({of + "approach before the " + a.ends[i].border + " carries",
                                 {a.ends[i].approach / arcsecond, "arcsec"}});
          if (a.hands_over)
            figures.push_back({of + "peak to peak", {a.peak_to_peak / arcsecond, "arcsec"}});
        }
      return figures;
    }

    bool has_equal_teeth(const GearPair &pair)
    {
      return pair.pinion().has_equal_teeth() && pair.gear().has_equal_teeth();
    }

    /** transmission_meshes.csv, and what it says in figures. */
    Table
    follow_teeth(const GearPair &pair, const ContactAnalysisOptions &options, Json &json, Log &log)
    {
      const unsigned int meshes = options.meshes > 0 ? options.meshes : pair.gear().blank().teeth;
      const Table        table  = transmission_of_meshes(pair, options, meshes);
      const auto        &errors = table.numbers("transmission error");
      const double least = errors.empty() ? 0. : *std::min_element(errors.begin(), errors.end());
      const double most  = errors.empty() ? 0. : *std::max_element(errors.begin(), errors.end());
      const double cycle = UnequalTeeth::hunting_cycle(pair);
      log.line("unequal teeth         transmission error from ",
               fixed(least, 3),
               " to ",
               fixed(most, 3),
               " arcsec over ",
               meshes,
               " mesh cycles; the same teeth are in contact again after ",
               cycle);
      log.line(
        "                      all values above are for the flank deviations common to all teeth");
      json["unequal teeth"] = figures_json({{"mesh cycles", {double(meshes), "-"}},
                                            {"hunting cycle", {cycle, "-"}},
                                            {"least transmission error", {least, "arcsec"}},
                                            {"largest transmission error", {most, "arcsec"}},
                                            {"peak to peak", {most - least, "arcsec"}}});
      return table;
    }

    class ToothContactStudy : public StudyKind
    {
    public:
      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        // Torque, speed and material of the same case, where the file has them: for its checks.
        file.read_known([&](dealii::ParameterHandler &known) { gear_case_.declare(known, file); });
        declare_section(prm, spiral_bevel_section, pair_);
        options_.declare(prm);
        output_.declare(prm);
      }

      void check() const override
      {
        pair_.check(spiral_bevel_section);
        output_.check("Output");
      }

      void inspect(Communicator &, Log &log) override
      {
        warn(pair_, log);
        log_derived(GearPair(pair_), log);
        gear_case_.report_checks(RunPlan(), log);
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      GearCase               gear_case_;
      GearPairOptions        pair_;
      ContactAnalysisOptions options_;
      OutputOptions          output_;
    };
  } // namespace

  void ToothContactStudy::run(OutputFolder &folder, Log &log)
  {
    log.set_verbosity(output_.verbosity);
    warn(pair_, log);
    const GearPair pair(pair_);
    log_derived(pair, log);
    RunSummary summary     = start_summary("tooth contact analysis", Model(), folder);
    summary.contradictions = gear_case_.report_checks(RunPlan(), log);
    Json                         json;
    std::vector<ContactAnalysis> sides;
    json["working"]                    = working_json(pair, options_);
    json["marking compound thickness"] = figure_json(1e3 * options_.marking_thickness, "um");
    // Both sides, whichever works: the other one carries when the load or the drive turns round.
    for (const MeshSide side : {MeshSide::drive, MeshSide::coast})
      {
        try
          {
            sides.push_back(analyse_contact(pair, side, options_));
          }
        catch (const NumericalError &error)
          {
            if (side == options_.working_side())
              throw;
            log.warning(error.what());
            continue;
          }
        log_side(sides.back(), log);
        json[side_name(side)] = side_json(sides.back(), pair.gear().pitch());
      }
    const ToothForms forms = measure_tooth_forms(pair);
    log_forms(forms, log);
    // Teeth that cannot be made end the study, but only after the log has shown them.
    forms.findings.raise();
    json["teeth"] = form_json(forms);
    if (!folder.is_writer())
      return;
    if (!has_equal_teeth(pair))
      write_csv(folder, "transmission_meshes.csv", follow_teeth(pair, options_, json, log));
    write_pair(pair, folder);
    write_own_figures(folder, list_figures(sides));
    write_csv(folder, "ease_off.csv", ease_off_table(pair));
    write_csv(folder, "transmission.csv", transmission_table(pair, options_));
    write_csv(folder, "tca.csv", lag_table(pair, sides, options_));
    write_csv(folder, "path.csv", path_table(pair, sides));
    write_summary(folder, summary, log);
    write_json(folder, "tca.json", json);
    if (output_.pictures)
      draw_pictures(folder, log);
  }

  std::unique_ptr<StudyKind> make_tooth_contact_study()
  {
    return std::make_unique<ToothContactStudy>();
  }
} // namespace vfife
