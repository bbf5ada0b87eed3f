// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_tests_h
#define vfife_tests_tests_h

#include <cmath>
#include <initializer_list>
#include <iostream>
#include <string>

/** Folder of the sources of this program's tests. */
std::string source_folder();

/** Folder of README.md, prm/ and doc/. */
std::string tree_folder();

/** The program vfife. */
std::string program_file();

/** How many checks of this process have failed; the test then ends with an exit code other than 0.
 */
inline unsigned int &n_failed_checks()
{
  static unsigned int n_failed = 0;
  return n_failed;
}

/**
 * One line per check: "name: ok", or the numbers when it fails, so that the comparison with the
 * .output file shows why. Tolerances are stated in the test, next to the reason for them.
 */
inline void check(const std::string &name, const bool condition)
{
  n_failed_checks() += condition ? 0 : 1;
  std::cout << name << ": " << (condition ? "ok" : "FAILED") << std::endl;
}

inline void check_close(const std::string &name,
                        const double       value,
                        const double       reference,
                        const double       tolerance)
{
  if (std::abs(value - reference) <= tolerance)
    std::cout << name << ": ok" << std::endl;
  else
    {
      ++n_failed_checks();
      std::cout.precision(15);
      std::cout << name << ": FAILED, " << value << " instead of " << reference << " within "
                << tolerance << std::endl;
    }
}

/** The larger of two numbers, and NaN once there was one: std::max() drops it, and a largest error
 * collected so would be "ok". */
template <typename Number>
Number largest_of(const Number first, const Number second)
{
  return second > first || !(second == second) ? second : first;
}

inline double largest_of(const std::initializer_list<double> numbers)
{
  double largest = *numbers.begin();
  for (const double number : numbers)
    largest = largest_of(largest, number);
  return largest;
}

/** The measured number must be below the bound (and a number). */
inline void check_below(const std::string &name, const double value, const double bound)
{
  check_close(name, value, 0., bound);
}

#endif
