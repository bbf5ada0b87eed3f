// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/types.h>
#include <vfife/gear/unloaded_contact/tooth_form.h>
#include <vfife/study/gear/tooth_form_texts.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace vfife
{
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

  void log_forms(const ToothForms &forms, Log &log)
  {
    log.line("teeth (mm)            thickness  tip land  root clearance  tip over fillet  undercut "
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
} // namespace vfife
