// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers with units: every unit's factor against its definition, the messages for wrong units,
// texts of defaults.

#include <vfife/base/text/figure_text.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/quantity.h>
#include <vfife/base/types.h>

#include "../refusal.h"
#include "../tests.h"

#include <sstream>

using namespace vfife;

void check_value(const std::string &text, const std::string &unit, const double value)
{
  // factors are rounded once, the product once more
  check_close(text, parse_quantity(text, unit), value, 4e-16 * std::abs(value));
}

void refuse(const std::string &text, const std::string &unit)
{
  std::cout << "<" << text << "> ";
  print_refusal([&] { parse_quantity(text, unit); });
}

void check_values()
{
  check_value("5 mm", "m", 5.);
  check_value("0.005 m", "mm", 5.);
  check_value("  +5e3um ", "mm", 5.);
  check_value("5", "m", 5000.);
  check_value("-5", "mm", -5.);
  check_value("2 ms", "s", 2e-3);
  check_value("180 deg", "rad", pi);
  check_value("3600 arcsec", "deg", pi / 180.);
  check_value("60 arcmin", "deg", pi / 180.);
  check_value("20000 rpm", "rad/s", 20000. * 2. * pi / 60.);
  check_value("360 deg/s", "rpm", 2. * pi);
  check_value("9 kHz", "Hz", 9000.);
  check_value("1000", "1/s", 1000.);
  check_value("800 N m", "N mm", 8e5);
  check_value("0.8  kN   m", "N m", 8e5);
  check_value("800 Nm", "N mm", 8e5);
  check_value("0.8 kNm", "N m", 8e5);
  check_value("12000 1/min", "rad/s", 400. * pi);
  check_value("12000 min^-1", "rpm", 400. * pi);
  check_value("60\u00b0", "rad", pi / 3.);
  check_value("5 \u00b5m", "mm", 5e-3);
  check_value("206 GPa", "MPa", 206000.);
  check_value("206000 N/mm^2", "Pa", 206000.);
  check_value("7850 kg/m^3", "t/mm^3", 7.85e-9);
  check_value("7.85 g/cm^3", "t/mm^3", 7.85e-9);
  check_value("2 kg", "t", 2e-3);
  check_value("1 kg m^2", "t mm^2", 1e3);
  check_value("3 m/s", "mm/s", 3000.);
  check_value("2 MPa/mm", "N/mm^3", 2.);
  check_value("80 %", "-", 0.8);
}

/** A unit in units of the SI and the powers of length, mass and time in it. */
struct Definition
{
  std::string name;
  double      size;
  int         length, mass, time;
};

/** Units inside are those that follow from mm, t and s: a unit of m^a kg^b s^c is 1e3^a 1e-3^b of
 * them. */
void check_definitions()
{
  const double                  second_of_arc = pi / 180 / 3600;
  const std::vector<Definition> definitions   = {{"-", 1., 0, 0, 0},
                                                 {"%", 1e-2, 0, 0, 0},
                                                 {"mm", 1e-3, 1, 0, 0},
                                                 {"cm", 1e-2, 1, 0, 0},
                                                 {"m", 1., 1, 0, 0},
                                                 {"um", 1e-6, 1, 0, 0},
                                                 {"s", 1., 0, 0, 1},
                                                 {"ms", 1e-3, 0, 0, 1},
                                                 {"us", 1e-6, 0, 0, 1},
                                                 {"ns", 1e-9, 0, 0, 1},
                                                 {"rad", 1., 0, 0, 0},
                                                 {"deg", pi / 180, 0, 0, 0},
                                                 {"arcmin", 60 * second_of_arc, 0, 0, 0},
                                                 {"arcsec", second_of_arc, 0, 0, 0},
                                                 {"rad/s", 1., 0, 0, -1},
                                                 {"rpm", 2 * pi / 60, 0, 0, -1},
                                                 {"deg/s", pi / 180, 0, 0, -1},
                                                 {"Hz", 1., 0, 0, -1},
                                                 {"kHz", 1e3, 0, 0, -1},
                                                 {"1/s", 1., 0, 0, -1},
                                                 {"N", 1., 1, 1, -2},
                                                 {"kN", 1e3, 1, 1, -2},
                                                 {"N mm", 1e-3, 2, 1, -2},
                                                 {"N m", 1., 2, 1, -2},
                                                 {"kN m", 1e3, 2, 1, -2},
                                                 {"mJ", 1e-3, 2, 1, -2},
                                                 {"J", 1., 2, 1, -2},
                                                 {"MPa", 1e6, -1, 1, -2},
                                                 {"Pa", 1., -1, 1, -2},
                                                 {"kPa", 1e3, -1, 1, -2},
                                                 {"GPa", 1e9, -1, 1, -2},
                                                 {"N/mm^2", 1e6, -1, 1, -2},
                                                 {"t", 1e3, 0, 1, 0},
                                                 {"kg", 1., 0, 1, 0},
                                                 {"g", 1e-3, 0, 1, 0},
                                                 {"t/mm^3", 1e12, -3, 1, 0},
                                                 {"kg/m^3", 1., -3, 1, 0},
                                                 {"g/cm^3", 1e3, -3, 1, 0},
                                                 {"t mm^2", 1e-3, 2, 1, 0},
                                                 {"kg mm^2", 1e-6, 2, 1, 0},
                                                 {"kg m^2", 1., 2, 1, 0},
                                                 {"N/mm", 1e3, 0, 1, -2},
                                                 {"N/m", 1., 0, 1, -2},
                                                 {"N/um", 1e6, 0, 1, -2},
                                                 {"MN/m", 1e6, 0, 1, -2},
                                                 {"N mm/rad", 1e-3, 2, 1, -2},
                                                 {"N m/rad", 1., 2, 1, -2},
                                                 {"MN m/rad", 1e6, 2, 1, -2},
                                                 {"N s/mm", 1e3, 0, 1, -1},
                                                 {"N s/m", 1., 0, 1, -1},
                                                 {"N mm s/rad", 1e-3, 2, 1, -1},
                                                 {"N m s/rad", 1., 2, 1, -1},
                                                 {"N/mm^3", 1e9, -2, 1, -2},
                                                 {"MPa/mm", 1e9, -2, 1, -2},
                                                 {"mm^2", 1e-6, 2, 0, 0},
                                                 {"mm/s", 1e-3, 1, 0, -1},
                                                 {"m/s", 1., 1, 0, -1},
                                                 {"mm/s^2", 1e-3, 1, 0, -2},
                                                 {"m/s^2", 1., 1, 0, -2},
                                                 {"mm/rad", 1e-3, 1, 0, 0},
                                                 {"1/mm", 1e3, -1, 0, 0},
                                                 {"K", 1., 0, 0, 0},
                                                 {"1/K", 1., 0, 0, 0}};
  check("every unit has its definition here", definitions.size() == known_units().size());
  double worst = 0.;
  for (const Definition &d : definitions)
    {
      const double inside = std::pow(1e3, d.length) * std::pow(1e-3, d.mass);
      raise_to(worst, std::abs(parse_quantity("1", d.name) / (d.size * inside) - 1));
    }
  check_below("factors of all units beside their definitions", worst, 1e-14);
}

void check_texts()
{
  std::cout << quantity_text(70. * pi / 180., "deg") << " "
            << quantity_text(20000. * pi / 30., "rpm") << " " << quantity_text(8e5, "N m") << " "
            << number_text(0.1) << std::endl;

  // a text must read back as the same value to the last bit but one, whatever the unit
  double worst = 0.;
  for (const Unit &unit : known_units())
    for (double value = 1.2345678901234567e-9; value < 1e12; value *= 7.1)
      raise_to(worst,
               std::abs(
                 parse_quantity(quantity_text(value, unit.name) + " " + unit.name, unit.name) /
                   value -
                 1.));
  check_below("texts of quantities read back", worst, 5e-16);

  bool exact = true;
  for (double value = -1.2345678901234567e-300; std::abs(value) < 1e300; value *= -7.1)
    {
      std::string rest;
      exact = exact && read_number(number_text(value), rest) == value && rest.empty();
    }
  check("texts of numbers read back exactly", exact);

  for (const auto &[value, text] :
       std::vector<std::pair<double, std::string>>{{54.2495, "54.2"},
                                                   {-0.96712, "-0.967"},
                                                   {1829.4, "1829"},
                                                   {-999.7, "-1000"},
                                                   {3817605.2, "3817605"},
                                                   {2.5e7, "2.5e+07"},
                                                   {0., "0"},
                                                   {1.234e-5, "1.23e-05"}})
    check("figure " + text, figure_text(value) == text);

  // Four digits, as checks and warnings have them: other numbers as ever.
  std::ostringstream four;
  set_figure_digits(four, 4);
  four << 12850.8 << ' ' << 1285.08 << ' ' << 9999.6 << ' ' << -987654.3 << ' ' << 2.34567e7 << ' '
       << 1.23456 << ' ' << 2e-5 << ' ' << 123456 << ' ' << std::fixed << 12850.81234;
  check("figures of four digits: " + four.str(),
        four.str() == "12851 1285 10000 -987654 2.346e+07 1.235 2e-05 123456 12850.8123");
}

int main()
{
  check_values();
  check_definitions();
  check_texts();

  refuse("5 kg", "mm");
  refuse("5 mm, 6 mm", "mm");
  refuse("5 nm", "mm");
  refuse("800 NM", "N m");
  refuse("20 furlongs", "mm");
  refuse("5 RPM", "rpm");
  refuse("5 mm", "-");
  refuse("mm", "mm");
  refuse("", "mm");
  refuse("nan", "mm");
  refuse("1e999", "mm");
  refuse("100 Hz", "1/s");
  refuse("5,3", "-");

  check("distance of a swap is 1", edit_distance("Gera", "gear") == 1);
  check("distance", edit_distance("kitten", "sitting") == 3);
  check("nearest",
        nearest_name("web thicknes", {"Rim thickness", "Web thickness", "Web angle"}) ==
          "Web thickness");
  check("none is alike", nearest_name("speed", {"Rim thickness", "Bore"}).empty());
  check("part of a name",
        nearest_name("thickness", {"Bore", "Web thickness of the gear"}) ==
          "Web thickness of the gear");
  return 0;
}
