// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/element/material.h>

namespace vfife
{
  void Material::declare(dealii::ParameterHandler &prm)
  {
    declare_quantity(prm, "density", density, "kg/m^3", "Mass density", Range::positive());
    declare_quantity(
      prm, "Young's modulus", youngs_modulus, "MPa", "Young's modulus", Range::positive());
    declare_number(prm,
                   "Poisson's ratio",
                   poissons_ratio,
                   "Poisson's ratio, at least 0 and below 0.5",
                   Range::between(0., 0.499));
  }


  void Material::check(const std::string &section) const
  {
    if (!(density > 0.))
      throw InputError(section + "/density", "The density of " + name + " must be positive.");
    if (!(youngs_modulus > 0.))
      throw InputError(section + "/Young's modulus",
                       "Young's modulus of " + name + " must be positive.");
    if (!(poissons_ratio >= 0. && poissons_ratio < 0.5))
      throw InputError(section + "/Poisson's ratio",
                       "Poisson's ratio of " + name + " must be at least 0 and below 0.5.");
  }
} // namespace vfife
