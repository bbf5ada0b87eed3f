// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/model/transmission.h>
#include <vfife/study/cases/damping_figures.h>

#include <sstream>

namespace vfife
{
  namespace
  {
    constexpr unsigned int n_mesh_orders = 3;
  }

  NamedFigures
  list_damping(const DynamicsOptions &dynamics, const Transmission *const pair, Log &log)
  {
    const double zeta = dynamics.mass_damping();
    if (!(zeta > 0))
      return {};
    NamedFigures       figures = {{"damping", {zeta, "1/s"}}};
    std::ostringstream text;
    set_figure_digits(text, 4);
    const auto add = [&](const std::string &where, const double frequency) {
      const double percent = 1e2 * damping_ratio_at(frequency, zeta);
      figures.push_back({"damping ratio at " + where, {percent, "%"}});
      text << (figures.size() > 2 ? ", " : ": ratio ") << percent << " % at " << where << " ("
           << frequency << " Hz)";
    };
    if (dynamics.damping_ratio > 0)
      add("the damping frequency", dynamics.damping_frequency);
    if (pair != nullptr)
      for (unsigned int order = 1; order <= n_mesh_orders; ++order)
        add("mesh order " + std::to_string(order), order * pair->mesh_frequency());
    log.line("damping ", zeta, " 1/s", text.str());
    return figures;
  }
} // namespace vfife
