// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/law/hertz.h>
#include <vfife/model/model.h>
#include <vfife/model/pair_measures.h>
#include <vfife/study/pressure/pressure_depth.h>

#include <cmath>

namespace vfife
{
  double choose_pressure_depth(const double given, const Model &model, const HertzContact &hertz)
  {
    // doc/theory/pressure-grid.md: below three half widths the mesh does not
    // see what is left.
    const double force = std::abs(load_torque(model)) / model.only_transmission()->arm;
    return given > 0 ? given : 3. * hertz.semi_axes(force)[1];
  }
} // namespace vfife
