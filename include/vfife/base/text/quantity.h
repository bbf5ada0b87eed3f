// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_quantity_h
#define vfife_base_text_quantity_h

#include <string>
#include <vector>

namespace vfife
{
  /** A unit that a user may write behind a number. */
  struct Unit
  {
    std::string name;      ///< "rpm"
    std::string dimension; ///< "an angular speed": units of one dimension are exchangeable
    double      factor;    ///< internal value = number * factor (internal: mm, s, t, N, MPa, rad)
  };

  /** All units, the internal one of each dimension among them. */
  const std::vector<Unit> &known_units();

  /**
   * The unit of that name; several blanks count as one.
   * @throws InputError that names the nearest known unit.
   */
  const Unit &find_unit(const std::string &name);

  /** The names of all units of a dimension, in the order of known_units(). */
  std::vector<std::string> units_of(const std::string &dimension);

  /** A number as the user wrote it, with its unit. */
  struct Quantity
  {
    double      number;
    const Unit *unit;

    /** The value in internal units. */
    double internal() const
    {
      return number * unit->factor;
    }

    /** The number that stands before @p other (of the same dimension) for the same value. */
    double in(const Unit &other) const
    {
      return unit == &other ? number : number * (unit->factor / other.factor);
    }
  };

  /**
   * Reads "5 mm", "20000 rpm", "800 N m" or a bare number, which is in @p unit_of_bare_number ("-":
   * a pure number).
   * @throws InputError if there is no number, the unit is not known or is of another dimension than
   *         @p unit_of_bare_number; the message names the wrong unit, the allowed ones and the
   * nearest known one.
   */
  Quantity read_quantity(const std::string &text, const std::string &unit_of_bare_number);

  /** read_quantity() as value in internal units. */
  double parse_quantity(const std::string &text, const std::string &unit_of_bare_number);

  /** The number that stands before @p unit for an internal @p value. */
  double in_unit(double value, const std::string &unit);

  /**
   * The shortest text of a bare number in @p unit that reads back as @p value (internal units) to
   * within 4e-16 relative: the text of a default ("70" for 70 * pi / 180 in "deg").
   */
  std::string quantity_text(double value, const std::string &unit);
} // namespace vfife

#endif
