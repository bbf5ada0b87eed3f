// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/quantity.h>
#include <vfife/base/types.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace vfife
{
  namespace
  {
    /** "N  m" and "N m" are one unit. */
    std::string single_blanks(const std::string &text)
    {
      std::string result;
      for (const char letter : trimmed(text))
        if (letter != ' ' && letter != '\t')
          result += letter;
        else if (result.back() != ' ')
          result += ' ';
      return result;
    }

    /** How units are written elsewhere, and here. */
    constexpr std::array<std::pair<const char *, const char *>, 7> other_spellings = {
      {{"Nm", "N m"},
       {"kNm", "kN m"},
       {"Nmm", "N mm"},
       {"1/min", "rpm"},
       {"min^-1", "rpm"},
       {"\u00b0", "deg"},
       {"\u00b5m", "um"}}};

    /** nullptr if it is not known. */
    const Unit *find_known(const std::string &name)
    {
      std::string wanted = single_blanks(name);
      for (const auto &[spelling, own] : other_spellings)
        if (wanted == spelling)
          wanted = own;
      for (const Unit &unit : known_units())
        if (unit.name == wanted)
          return &unit;
      return nullptr;
    }

    std::vector<std::string> all_names()
    {
      std::vector<std::string> names;
      for (const Unit &unit : known_units())
        names.push_back(unit.name);
      return names;
    }

    /** "a length (mm, m, um)" */
    std::string dimension_text(const Unit &unit)
    {
      if (unit.dimension == find_known("-")->dimension)
        return unit.dimension + " (without a unit, or with %)";
      return unit.dimension + " (" + list_of(units_of(unit.dimension)) + ")";
    }
  } // namespace

  const std::vector<Unit> &known_units()
  {
    // Words of the dimensions carry their article, because messages say "the unit must be an angle
    // (...)".
    // Factors lead to the units inside: mm, s, t, N, MPa, mJ, rad.
    static const std::vector<Unit> units = {
      {"-", "a pure number", 1.},
      {"%", "a pure number", 1e-2},
      {"mm", "a length", 1.},
      {"cm", "a length", 10.},
      {"m", "a length", 1e3},
      {"um", "a length", 1e-3},
      {"s", "a time", 1.},
      {"ms", "a time", 1e-3},
      {"us", "a time", 1e-6},
      {"ns", "a time", 1e-9},
      {"rad", "an angle", 1.},
      {"deg", "an angle", degree},
      {"arcmin", "an angle", 60. * arcsecond},
      {"arcsec", "an angle", arcsecond},
      {"rad/s", "an angular speed", 1.},
      {"rpm", "an angular speed", pi / 30.},
      {"deg/s", "an angular speed", degree},
      {"Hz", "a frequency", 1.},
      {"kHz", "a frequency", 1e3},
      {"1/s", "a rate", 1.},
      {"N", "a force", 1.},
      {"kN", "a force", 1e3},
      {"N mm", "a torque", 1.},
      {"N m", "a torque", 1e3},
      {"kN m", "a torque", 1e6},
      {"mJ", "an energy", 1.},
      {"J", "an energy", 1e3},
      {"MPa", "a stress or pressure", 1.},
      {"Pa", "a stress or pressure", 1e-6},
      {"kPa", "a stress or pressure", 1e-3},
      {"GPa", "a stress or pressure", 1e3},
      {"N/mm^2", "a stress or pressure", 1.},
      {"t", "a mass", 1.},
      {"kg", "a mass", 1e-3},
      {"g", "a mass", 1e-6},
      {"t/mm^3", "a density", 1.},
      {"kg/m^3", "a density", 1e-12},
      {"g/cm^3", "a density", 1e-9},
      {"t mm^2", "a moment of inertia", 1.},
      {"kg mm^2", "a moment of inertia", 1e-3},
      {"kg m^2", "a moment of inertia", 1e3},
      {"N/mm", "a stiffness", 1.},
      {"N/m", "a stiffness", 1e-3},
      {"N/um", "a stiffness", 1e3},
      {"MN/m", "a stiffness", 1e3},
      {"N mm/rad", "a torsional stiffness", 1.},
      {"N m/rad", "a torsional stiffness", 1e3},
      {"MN m/rad", "a torsional stiffness", 1e9},
      {"N s/mm", "a viscous damping coefficient", 1.},
      {"N s/m", "a viscous damping coefficient", 1e-3},
      {"N mm s/rad", "a torsional damping coefficient", 1.},
      {"N m s/rad", "a torsional damping coefficient", 1e3},
      {"N/mm^3", "a penalty stiffness", 1.},
      {"MPa/mm", "a penalty stiffness", 1.},
      {"mm^2", "an area", 1.},
      {"mm/s", "a speed", 1.},
      {"m/s", "a speed", 1e3},
      {"mm/s^2", "an acceleration", 1.},
      {"m/s^2", "an acceleration", 1e3},
      {"mm/rad", "a length per angle", 1.},
      {"1/mm", "a curvature", 1.},
      {"K", "a temperature difference", 1.},
      {"1/K", "a thermal expansion", 1.},
    };
    return units;
  }

  const Unit &find_unit(const std::string &name)
  {
    const Unit *const unit = find_known(name);
    if (unit == nullptr)
      throw InputError("the unit \"" + name + "\" is not known" + did_you_mean(name, all_names()));
    return *unit;
  }

  std::vector<std::string> units_of(const std::string &dimension)
  {
    std::vector<std::string> names;
    for (const Unit &unit : known_units())
      if (unit.dimension == dimension)
        names.push_back(unit.name);
    return names;
  }

  Quantity read_quantity(const std::string &text, const std::string &unit_of_bare_number)
  {
    const Unit  &expected = find_unit(unit_of_bare_number);
    std::string  name;
    const double number = read_number(text, name);
    if (name.empty())
      return {number, &expected};

    // "0,5": what follows the number is no unit but a decimal comma.
    if (name[0] == ',')
      throw InputError("the decimal sign is a point, not a comma");

    // "1 rpm, 2 rpm"; the name of no unit has a comma.
    if (name.find_first_of(",;") != std::string::npos)
      throw InputError("expected one value, got a list. Use a sweep for several values");

    // A known unit of the right dimension; else the message says whether the unit is another one's
    // or not known at all.
    const Unit *const unit = find_known(name);
    if (unit != nullptr && unit->dimension == expected.dimension)
      return {number, unit};

    std::string message = "the unit must be " + dimension_text(expected);
    if (expected.name == "-")
      message = "must be " + dimension_text(expected);
    if (unit != nullptr)
      throw InputError(message + ", and \"" + name + "\" is " + unit->dimension);

    // "nm" is more likely a misspelt "mm" than anything else when a length is asked for
    const std::vector<std::string> same_dimension = units_of(expected.dimension);
    const std::string              nearest        = nearest_name(name, same_dimension);
    throw InputError(message + ", and \"" + name + "\" is not known" +
                     did_you_mean(name, nearest.empty() ? all_names() : same_dimension));
  }

  double parse_quantity(const std::string &text, const std::string &unit_of_bare_number)
  {
    return read_quantity(text, unit_of_bare_number).internal();
  }

  double in_unit(const double value, const std::string &unit)
  {
    return value / find_unit(unit).factor;
  }

  std::string quantity_text(const double value, const std::string &unit)
  {
    const double factor = find_unit(unit).factor;
    const double number = value / factor;

    // the quotient is often one bit off a short number: 70 * pi / 180 divided by pi / 180
    char text[32];
    std::snprintf(text, sizeof(text), "%.15g", number);
    std::string  rest;
    const double rounded = std::isfinite(number) ? read_number(text, rest) : number;
    return number_text(std::abs(rounded * factor - value) <= 4e-16 * std::abs(value) ? rounded
                                                                                     : number);
  }
} // namespace vfife
