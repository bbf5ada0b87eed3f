// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/element/material.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    // Of solids, each end with room: aerogels to osmium (22,590 kg/m^3), soft gels to diamond
    // (1.2e6 MPa), gels (10 m/s at 0.1 MPa) and rubber (30 m/s) to beryllium and diamond (12,600
    // and 18,000 m/s). Metals and ceramics above 3000 kg/m^3 have 8000 MPa and more.
    constexpr double least_density = 1., largest_density = 23000.;  // [kg/m^3]
    constexpr double least_modulus = 1e-3, largest_modulus = 1.3e6; // [MPa]
    constexpr double least_speed = 10., largest_speed = 20000.;     // [m/s]
    constexpr double dense = 3000., least_dense_modulus = 1000.;    // [kg/m^3], [MPa]
    constexpr double light = 100.;                                  // [kg/m^3]

    bool is_between(const double value, const double least, const double largest)
    {
      return value >= least && value <= largest;
    }

    /** Speed of sound in a bar [m/s]. */
    double sound_speed(const double density, const double modulus)
    {
      return std::sqrt(1e6 * modulus / density);
    }

    bool is_too_soft(const double density, const double modulus)
    {
      return density > dense && modulus < least_dense_modulus;
    }

    bool is_solid(const double density, const double modulus)
    {
      return is_between(density, least_density, largest_density) &&
             is_between(modulus, least_modulus, largest_modulus) &&
             is_between(sound_speed(density, modulus), least_speed, largest_speed) &&
             !is_too_soft(density, modulus);
    }

    struct OtherUnit
    {
      const char *name;
      double      factor; ///< to the unit of a bare number
    };
    const std::vector<OtherUnit> densities = {{"g/cm^3", 1e3},
                                              {"t/mm^3", 1e12},
                                              {"kg/mm^3", 1e9},
                                              {"lb/in^3", 27679.9}};
    const std::vector<OtherUnit> moduli    = {{"Pa", 1e-6},
                                              {"GPa", 1e3},
                                              {"kPa", 1e-3},
                                              {"psi", 6.89476e-3}};

    template <typename... Parts>
    std::string text(const Parts &...parts)
    {
      std::ostringstream message;
      (message << ... << parts);
      return message.str();
    }

    /** "; in g/cm^3 the number is that of a solid, 7850 kg/m^3"; empty where it is in none. */
    template <typename Fits>
    std::string likely_unit(const std::vector<OtherUnit> &units,
                            const double                  number,
                            const std::string            &unit,
                            const Fits                   &fits)
    {
      std::vector<std::string> found;
      for (const OtherUnit &other : units)
        if (fits(number * other.factor))
          found.push_back(text(other.name, " (", number * other.factor, " ", unit, ")"));
      return found.empty() ? "" : "; it fits a solid in " + list_of(found);
    }
  } // namespace

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
    declare_quantity(prm,
                     "thermal expansion",
                     expansion,
                     "1/K",
                     "Coefficient of linear thermal expansion, for bodies with a temperature");
  }

  std::vector<std::string> Material::find_doubts() const
  {
    // In the units of bare numbers, as the user most likely has written them.
    const double rho = 1e12 * density, E = youngs_modulus;
    const bool   rho_fits = is_between(rho, least_density, largest_density),
               E_fits     = is_between(E, least_modulus, largest_modulus);

    std::vector<std::string> found;
    const auto               doubt_density = [&](const std::string &reason) {
      const auto fits = [&](const double other) {
        return E_fits ? is_solid(other, E) : is_between(other, light, largest_density);
      };
      found.push_back(text("Material ", name, "/density = ", rho, " kg/m^3 ", reason) +
                      likely_unit(densities, rho, "kg/m^3", fits));
    };
    const auto doubt_modulus = [&](const std::string &reason) {
      const auto fits = [&](const double other) {
        return rho_fits ? is_solid(rho, other) : is_between(other, 1., largest_modulus);
      };
      found.push_back(text("Material ", name, "/Young's modulus = ", E, " MPa ", reason) +
                      likely_unit(moduli, E, "MPa", fits));
    };
    const std::string of_none = "is outside the range of solids ";
    if (!rho_fits)
      doubt_density(text(of_none, "(", least_density, " to ", largest_density, " kg/m^3)"));
    if (!E_fits)
      doubt_modulus(text(of_none, "(", least_modulus, " to ", largest_modulus, " MPa)"));
    if (!rho_fits || !E_fits || is_solid(rho, E))
      return found;

    // Each may be, both together are not: the density is to blame where it is that of a foam.
    const std::string speed = text("gives a speed of sound of ",
                                   sound_speed(rho, E),
                                   " m/s (solids: ",
                                   least_speed,
                                   " to ",
                                   largest_speed,
                                   " m/s)");
    if (rho < light)
      doubt_density(text("with Young's modulus = ", E, " MPa ", speed));
    else if (is_too_soft(rho, E))
      doubt_modulus(text("with density = ",
                         rho,
                         " kg/m^3 is outside the range of solids: above ",
                         dense,
                         " kg/m^3 they have at least ",
                         least_dense_modulus,
                         " MPa"));
    else
      doubt_modulus(text("with density = ", rho, " kg/m^3 ", speed));
    return found;
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
