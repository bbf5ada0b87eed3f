// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_study_history_difference_h
#define vfife_tests_study_history_difference_h

#include "../tests.h"

#include <vfife/base/text/table.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <vector>

/**
 * The rule by which histories of one run, made on other numbers of ranks or in parts, are the same
 * (doc/reference/conventions.md). Every column may differ by the larger of
 *   - 1e-8 of its own largest value: what a reader of that column sees;
 *   - 200 units in the last place of the numbers of which its quantity is the sum or the
 *     difference in this run: what is zero but for round-off has no size of its own. Some 10^2 to
 *     10^3 steps collect some 10 to 30 such units at random (doc/verification/dynamics.md, Ranks).
 * No column is left out, and a quantity of an unknown unit is a failure.
 */
namespace histories
{
  /** What a history does not have. */
  struct Bodies
  {
    double coordinate;                                 ///< the largest one [mm]
    double cell;                                       ///< least length of a cell [mm]
    double mass;                                       ///< of all bodies [t]
    double youngs_modulus = 206000, density = 7.85e-9; ///< [MPa], [t/mm^3]
  };

  struct Difference
  {
    double      of_allowed = 0; ///< the largest one over what is allowed
    std::string column;         ///< that has it
  };

  /** Largest value of all columns of a unit. */
  inline double largest_of_unit(const vfife::Table &history, const std::string &unit)
  {
    double size = 0;
    for (const auto &column : history.columns())
      if (column.unit == unit)
        raise_to(size, largest_size(column.numbers));
    return size;
  }

  /** See size_of_parts() [mJ]. */
  inline double energy_of_parts(const vfife::Table &history, const Bodies &bodies)
  {
    const double strain_energy = largest_size(history.numbers("strain energy"));
    const double volume        = bodies.mass / bodies.density;
    return largest_of_unit(history, "mJ") +
           std::sqrt(2. * strain_energy * bodies.youngs_modulus * volume) * bodies.coordinate /
             bodies.cell;
  }

  /**
   * The size of the numbers of which a quantity with that unit is the sum or the difference; zero
   * for what is counted and for the drive's speed and mesh frequency, which are prescribed;
   * negative for a unit that is not known. With x the largest coordinate, h
   * the cell, E Young's modulus, m the mass, c the speed of waves and W the largest energy:
   *   length    x: displacements are differences of places
   *   stress    E x/h: strains are differences of places over h
   *   force     E h x: of a node with the stiffness E h; moments times x
   *   energy    W: energies are differences of each other; and what strains of the round-off x/h
   *             do on the stresses, sqrt(2 U E V) x/h (Cauchy-Schwarz), U the largest strain energy
   *             and V = m/rho the volume
   *   momentum  sum m_i |v_i| <= sqrt(2 m W) (Cauchy-Schwarz), and what forces of that round-off
   *             add in a step h/c to the node that they act on, m_i = rho h^3:
   *             E h x h/c = rho h^3 c x/h; angular momentum times x
   *   angle     the largest angle, at least one radian
   */
  inline double
  size_of_parts(const std::string &unit, const vfife::Table &history, const Bodies &bodies)
  {
    const double x = bodies.coordinate, h = bodies.cell, E = bodies.youngs_modulus;
    const double energy   = largest_of_unit(history, "mJ");
    const double c        = std::sqrt(E / bodies.density);
    const double momentum = std::sqrt(2. * bodies.mass * energy) + bodies.density * h * h * c * x;
    const double degrees  = largest_of({largest_of_unit(history, "deg"), 180. / M_PI});

    const std::map<std::string, double> sizes = {{"s", 0.},
                                                 {"-", 0.},
                                                 {"rpm", 0.},
                                                 {"Hz", 0.},
                                                 {"mm", x},
                                                 {"um", 1e3 * x},
                                                 {"deg", degrees},
                                                 {"arcsec", 3600. * degrees},
                                                 {"MPa", E * x / h},
                                                 {"N", E * h * x},
                                                 {"N mm", E * h * x * x},
                                                 {"N m", 1e-3 * E * h * x * x},
                                                 {"mJ", energy_of_parts(history, bodies)},
                                                 {"N s", momentum},
                                                 {"N mm s", momentum * x},
                                                 {"N m s", 1e-3 * momentum * x}};
    const auto                          found = sizes.find(unit);
    return found == sizes.end() ? -1. : found->second;
  }

  /**
   * What the energy error is divided by, sample by sample, as far as the columns tell: the largest
   * change so far of what is exchanged (EnergyLedger::scale, which is no smaller). The error is a
   * residual over this; the residual is a difference of energies and has their round-off.
   */
  inline std::vector<double> exchanged_energies(const vfife::Table &history)
  {
    const auto change = [&](const std::string &name, const std::size_t i) {
      const auto &values = history.numbers(name);
      return std::abs(values[i] - values[0]);
    };
    std::vector<double> exchanged(history.n_rows(), 0.);
    for (std::size_t i = 0; i < exchanged.size(); ++i)
      exchanged[i] =
        largest_of({i > 0 ? exchanged[i - 1] : 1e-10 * history.numbers("kinetic energy")[0],
                    change("strain energy", i) + change("contact energy", i) +
                      change("relative kinetic energy", i),
                    change("kinetic energy", i)});
    return exchanged;
  }

  /** Samples that are compared, from the first one to before the last. */
  struct Samples
  {
    std::size_t begin = 0, end = std::numeric_limits<std::size_t>::max();
  };

  inline Difference compare(const vfife::Table &one,
                            const vfife::Table &other,
                            const Bodies       &bodies,
                            const Samples      &samples = {})
  {
    constexpr double part = 1e-8, units = 200;
    const double     unit     = units * std::numeric_limits<double>::epsilon();
    const auto       divisors = exchanged_energies(other);
    const double     energy   = energy_of_parts(other, bodies);
    Difference       result;
    for (const auto &column : other.columns())
      {
        if (column.is_text)
          continue;
        const double parts = size_of_parts(column.unit, other, bodies);
        if (parts < 0)
          return {std::numeric_limits<double>::quiet_NaN(),
                  column.name + ", which has the unknown unit " + column.unit};
        const double own    = part * largest_size(column.numbers);
        const auto  &values = one.numbers(column.name);
        for (std::size_t i = samples.begin; i < std::min(samples.end, column.numbers.size()); ++i)
          {
            const double difference = std::abs(values[i] - column.numbers[i]);
            if (difference == 0)
              continue;
            const double allowed = column.name == "energy error" ? unit * energy / divisors[i]
                                                                 : largest_of(own, unit * parts);
            const double worst   = largest_of(result.of_allowed, difference / allowed);
            if (worst != result.of_allowed)
              result = {worst, column.name};
          }
      }
    return result;
  }

  /** Checks it and names the column where it fails; with @p tell always. */
  inline void check_same(const std::string  &name,
                         const vfife::Table &one,
                         const vfife::Table &other,
                         const Bodies       &bodies,
                         const Samples      &samples = {},
                         const bool          tell    = false)
  {
    const bool comparable = one.csv_header() == other.csv_header() &&
                            one.n_rows() == other.n_rows() && one.n_rows() > 3 &&
                            samples.begin < one.n_rows();
    check(name + ": same columns and samples", comparable);
    if (!comparable)
      return;
    const Difference difference = compare(one, other, bodies, samples);
    check_below(name + ": every column within what is allowed", difference.of_allowed, 1.);
    if (tell || !(difference.of_allowed <= 1.))
      std::cout << name << ": " << difference.of_allowed << " of " << difference.column
                << std::endl;
  }
} // namespace histories

#endif
