// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_tests_h
#define vfife_tests_tests_h

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

/** Folder of the sources of this program's tests. */
std::string source_folder();

/** Folder of README.md, prm/ and doc/. */
std::string tree_folder();

/** The program vfife. */
std::string program_file();

/** Checks of this process; with a failed one the test ends with an exit code other than 0. */
struct CheckCounts
{
  unsigned int passed = 0, failed = 0;
};

inline CheckCounts &check_counts()
{
  static CheckCounts counts;
  return counts;
}

/** Prints what fails, with its numbers, so that the comparison with the .output file shows why; the
 * test's program prints how many checks have passed. Tolerances are stated in the test, next to the
 * reason for them. */
inline void check(const std::string &name, const bool condition)
{
  ++(condition ? check_counts().passed : check_counts().failed);
  if (!condition)
    std::cout << name << ": FAILED" << std::endl;
}

inline void check_close(const std::string &name,
                        const double       value,
                        const double       reference,
                        const double       tolerance)
{
  if (std::abs(value - reference) <= tolerance)
    {
      ++check_counts().passed;
      return;
    }
  ++check_counts().failed;
  std::cout.precision(15);
  std::cout << name << ": FAILED, " << value << " instead of " << reference << " within "
            << tolerance << std::endl;
}

inline bool has_text(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
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

/** Raises a largest number to this one where it is larger, or NaN. */
template <typename Number>
void raise_to(Number &largest, const Number number)
{
  largest = largest_of(largest, number);
}

/** The largest magnitude of some numbers. */
template <typename Numbers>
double largest_size(const Numbers &numbers)
{
  double largest = 0;
  for (const double number : numbers)
    raise_to(largest, std::abs(number));
  return largest;
}

inline double sum_of(const std::vector<double> &numbers)
{
  return std::accumulate(numbers.begin(), numbers.end(), 0.);
}

inline double mean_of(const std::vector<double> &numbers)
{
  return sum_of(numbers) / numbers.size();
}

/** The largest difference between the numbers of two lists; infinite where their lengths differ. */
inline double largest_difference(const std::vector<double> &a, const std::vector<double> &b)
{
  double largest = a.size() == b.size() ? 0. : HUGE_VAL;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    raise_to(largest, std::abs(a[i] - b[i]));
  return largest;
}

/** The same over the largest magnitude of the numbers in @p a. */
inline double relative_difference(const std::vector<double> &a, const std::vector<double> &b)
{
  return largest_difference(a, b) / std::max(largest_size(a), 1e-300);
}

/** The measured number must be below the bound (and a number). */
inline void check_below(const std::string &name, const double value, const double bound)
{
  check_close(name, value, 0., bound);
}

/** Two numbers must be equal within the tolerance of their ratio. */
inline void check_ratio(const std::string &name, const double ratio, const double tolerance)
{
  check_close(name, ratio, 1., tolerance);
}

#endif
