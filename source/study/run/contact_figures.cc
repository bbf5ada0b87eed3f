// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/table.h>
#include <vfife/contact/law/hertz.h>
#include <vfife/model/model.h>
#include <vfife/output/files/summary.h>
#include <vfife/study/run/contact_figures.h>

#include <cmath>
#include <set>

namespace vfife
{
  namespace
  {
    /** On the driven member [N mm]. */
    double load_torque(const Model &model)
    {
      return std::abs(model.torques.front().value);
    }
  } // namespace

  double compute_penalty_lag(const double contact_energy, const double torque)
  {
    return 2. * contact_energy / torque;
  }

  void log_contact_figures(const Model        &model,
                           const HertzContact &hertz,
                           const double        penalty_lag,
                           Log                &log)
  {
    const double  force = load_torque(model) / model.transmission->arm;
    const Vector2 axes  = hertz.semi_axes(force);
    log.line("of the lag ",
             penalty_lag / arcsecond,
             " arcsec are the contact's penalty springs; Hertz, one tooth pair under all the "
             "torque: ",
             axes[0],
             " x ",
             axes[1],
             " mm, ",
             hertz.largest_pressure(force),
             " MPa");
  }

  void add_contact_figures(const Model        &model,
                           const HertzContact &hertz,
                           const double        penalty_lag,
                           const Table        &teeth,
                           const unsigned int  n_samples,
                           RunSummary         &summary)
  {
    const double force = load_torque(model) / model.transmission->arm;
    summary.transmission_error.push_back(
      {"penalty springs, in teeth and rest", {-penalty_lag / arcsecond, "arcsec"}});
    summary.figures.push_back(
      {"hertz pressure of one tooth pair", {hertz.largest_pressure(force), "MPa"}});

    std::set<double> coast;
    for (std::size_t i = 0; i < teeth.n_rows(); ++i)
      if (teeth.column("side").texts[i] == "coast")
        coast.insert(teeth.numbers("time")[i]);
    const double share = n_samples > 0 ? static_cast<double>(coast.size()) / n_samples : 0.;
    summary.figures.push_back({"samples with contact on the coast side", {share, "-"}});
  }
} // namespace vfife
