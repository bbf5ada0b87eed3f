// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What DynamicRun tells of a run in summary.json.
#include <vfife/base/process/log.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/study/run/dynamic_run.h>

namespace vfife
{
  NamedFigures DynamicRun::list_figures(const Model &model, ExplicitSolver &solver) const
  {
    const Transmission &t      = *model.transmission;
    const double        torque = gear_case_.operation().torque;
    return {{"mesh frequency", {t.mesh_frequency(), "Hz"}},
            {model.bodies[t.driver].name() + " speed", {t.driver_rate * 30. / pi, "rpm"}},
            {model.bodies[t.driven].name() + " torque", {1e-3 * torque, "N m"}},
            {"effective arm", {t.arm, "mm"}},
            {"torque over effective arm", {torque / t.arm, "N"}},
            {"stable step of the elements", {1e9 * solver.element_step(), "ns"}},
            {"contact penalty", {solver.contact().penalties().front(), "N/mm^3"}}};
  }

  void DynamicRun::complete_summary(const Model   &model,
                                    const Table   &history,
                                    const Preload &preload,
                                    RunSummary    &summary,
                                    Log           &log) const
  {
    if (preload.swing.frequency() > 0)
      add_preload(preload, summary);
    if (history.n_rows() < 2 || !(preload.swing.frequency() > 0))
      return;

    const double ramp_end = dynamics_.start == Start::ramp
                              ? gear_case_.operation().ramp / model.transmission->mesh_frequency()
                              : 0.;
    summary.steady        = find_steady_part(history,
                                      output_.history_every,
                                      gear_case_.mesh_frequency() / preload.swing.frequency(),
                                      ramp_end);
    log.line(summary.steady->explain());
    for (const char *name : {"contact force total", "dte", "rim dte"})
      {
        const ColumnStatistics &c = summary.steady->column(name);
        log.line("  ",
                 name,
                 ": mean ",
                 c.mean,
                 " ",
                 c.unit,
                 ", peak to peak ",
                 c.peak_to_peak,
                 " ",
                 c.unit);
      }
  }

  void DynamicRun::add_preload(const Preload &preload, RunSummary &summary) const
  {
    const DeflectionParts &parts = preload.parts;
    summary.transmission_error   = {{"total at the start", {parts.total / arcsecond, "arcsec"}},
                                    {"teeth and rest", {parts.teeth / arcsecond, "arcsec"}},
                                    {"web windup", {parts.web_windup / arcsecond, "arcsec"}},
                                    {"rim tilt and shift", {parts.rim_tilt / arcsecond, "arcsec"}},
                                    {"centrifugal shift", {parts.centrifugal / arcsecond, "arcsec"}}};
    summary.figures.push_back({"torsional stiffness", {1e-3 * preload.swing.stiffness, "N m/rad"}});
    summary.figures.push_back({"inertia of the swing", {1e-3 * preload.swing.inertia, "kg m^2"}});
    summary.figures.push_back({"swing frequency, estimated", {preload.swing.frequency(), "Hz"}});
  }
} // namespace vfife
