// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/gear/unloaded_contact/contact_analysis.h>
#include <vfife/output/files/figures.h>
#include <vfife/study/gear/contact_analysis_json.h>

#include <nlohmann/json.hpp>

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

  } // namespace

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
} // namespace vfife
