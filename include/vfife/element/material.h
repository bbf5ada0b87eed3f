// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_element_material_h
#define vfife_element_material_h

#include <vfife/base/parameter_handler.h>

#include <string>
#include <vector>

namespace vfife
{
  /**
   * Isotropic linear elastic material. The defaults are the reference steel.
   */
  struct Material
  {
    std::string name           = "steel";
    double      density        = 7.85e-9; ///< [t/mm^3]
    double      youngs_modulus = 206000.; ///< [MPa]
    double      poissons_ratio = 0.29;    ///< [-]
    double      expansion      = 1.2e-5;  ///< thermal, linear [1/K]

    /** Declares "density", "Young's modulus", "Poisson's ratio" and "thermal expansion" in the
     * subsection entered. */
    void declare(dealii::ParameterHandler &prm);

    /** Throws InputError when a value is not possible (entries named relative to @p section). */
    void check(const std::string &section) const;

    /**
     * Sentences about entries of section "Material NAME" whose values no solid has, and about the
     * speed of sound in a bar, sqrt(E/rho), where density and modulus do not go together. Each
     * states the range of solids, from soft gels, foams and rubber to osmium, beryllium and
     * diamond, and the units in which the number would be that of a solid.
     */
    std::vector<std::string> find_doubts() const;

    /** First Lame constant, E nu / ((1 + nu)(1 - 2 nu)) [MPa]. */
    double lambda() const
    {
      return youngs_modulus * poissons_ratio / ((1. + poissons_ratio) * (1. - 2. * poissons_ratio));
    }

    /** Second Lame constant, the shear modulus [MPa]. */
    double mu() const
    {
      return youngs_modulus / (2. * (1. + poissons_ratio));
    }
  };
} // namespace vfife

#endif
