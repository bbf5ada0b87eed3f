// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/figure_text.h>
#include <vfife/contact/law/hertz.h>
#include <vfife/model/model.h>
#include <vfife/model/pair_measures.h>
#include <vfife/study/cases/torque_pressure.h>

#include <sstream>

namespace vfife
{
  TorquePressure::TorquePressure(const HertzContact &hertz, const double force)
    : semi_axes(hertz.semi_axes(force))
    , largest(hertz.largest_pressure(force))
  {
  }

  TorquePressure::TorquePressure(const HertzContact &hertz, const Model &model)
    : TorquePressure(hertz, load_torque(model) / model.only_transmission()->arm)
  {
  }

  std::string TorquePressure::describe() const
  {
    std::ostringstream text;
    text << "Hertzian contact of one tooth pair under the whole torque: " << semi_axes[0] << " x "
         << semi_axes[1] << " mm, " << largest << " MPa";
    return text.str();
  }

  std::string TorquePressure::find_excess(const double limit) const
  {
    if (limit == 0 || largest <= limit)
      return "";
    std::ostringstream text;
    set_figure_digits(text, 4);
    text << "Hertzian pressure of one tooth pair under the whole torque, " << largest
         << " MPa, exceeds the limit of " << limit << " MPa (Operation/contact stress limit)";
    return text.str();
  }
} // namespace vfife
