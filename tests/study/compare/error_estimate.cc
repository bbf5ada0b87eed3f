// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Numerical errors of made-up sequences of known order, and which variants they tell apart.
#include "../../tests.h"

#include <vfife/study/sweep/error_bars.h>
#include <vfife/study/sweep/refinement.h>

#include <limits>

using namespace vfife;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/** f_0 + C h^p */
std::vector<double>
power_law(const double limit, const double factor, const double order, const std::vector<double> &h)
{
  std::vector<double> values;
  for (const double size : h)
    values.push_back(limit + factor * std::pow(size, order));
  return values;
}

void known_orders()
{
  for (const double order : {0.6, 1., 2.})
    // Halved sizes, and such as cells of a mesh have.
    for (const std::vector<double> &h : {std::vector<double>{4, 2, 1}, {1.7, 1.2, 1}})
      for (const double factor : {3., -3.})
        {
          const ErrorEstimate e = estimate_error(power_law(50, factor, order, h), h);
          check("order " + std::to_string(order).substr(0, 3) + ": Richardson",
                e.method == ErrorMethod::richardson);
          // 1e-12 of the order is 1e-11 of the error: differences of 0.5 of numbers of 50.
          check_close("its order", e.order, order, 1e-10);
          check_close("its error: 1.25 times the distance to the limit", e.error, 3.75, 1e-9);
        }
  // Of four the last three: the first one is far from any power.
  const ErrorEstimate four = estimate_error({900, 54, 52, 51}, {8, 4, 2, 1});
  check_close("the last three of four", four.error, 1.25, 1e-10);
  std::cout << four.describe() << std::endl;
}

void show(const std::string         &name,
          const std::vector<double> &values,
          const std::vector<double> &sizes = {4, 2, 1})
{
  const ErrorEstimate e = estimate_error(values, sizes);
  std::cout << name << ": " << e.error << ", " << e.describe() << std::endl;
}

void other_sequences()
{
  show("not monotone", {3, 1, 2});
  show("all equal", {5, 5, 5});
  show("the first two equal", {5, 5, 6});
  show("the last two equal", {5, 6, 6});
  show("diverging", {1, 2, 4});
  // First differences 1 and 0.8: order 0.32, with a limit four times the last difference away.
  show("too slow", {0, 1, 1.8});
  // Order 3 would make the error a seventh of the last difference.
  show("too fast", {9, 1, 0});
  show("sizes not known", {7, 3, 1}, {});
  show("two values", {3, 1}, {2, 1});
  show("one of three failed", {7, missing, 1});
  show("two of three failed", {missing, missing, 1});
  show("the finest failed", {7, 3, missing});
  show("one of four failed", {missing, 4, 2, 1}, {8, 4, 2, 1});
  show("failed without a limit", {9, missing, 2, 3}, {8, 4, 2, 1});
}

void show_sizes(const std::string &name, const std::vector<double> &sizes)
{
  std::cout << name << ":";
  for (const double size : sizes)
    std::cout << " " << size;
  std::cout << (sizes.empty() ? " none" : "") << std::endl;
}

void sizes()
{
  show_sizes("cells", derive_sizes({{"4"}, {"6"}, {"12"}}));
  show_sizes("steps", derive_sizes({{"4 us"}, {"2000 ns"}, {"1 us"}}));
  show_sizes("two entries in one ratio", derive_sizes({{"4", "2"}, {"6", "3"}, {"8", "4"}}));
  show_sizes("cells and a size", derive_sizes({{"4", "2 mm"}, {"8", "1 mm"}}));
  show_sizes("two ratios", derive_sizes({{"4", "2"}, {"6", "4"}, {"8", "4"}}));
  show_sizes("one of two changes", derive_sizes({{"4", "3"}, {"6", "3"}, {"8", "3"}}));
  show_sizes("up and down", derive_sizes({{"4"}, {"8"}, {"6"}}));
  show_sizes("twice the same", derive_sizes({{"4"}, {"4"}, {"6"}}));
  show_sizes("zero", derive_sizes({{"4"}, {"2"}, {"0"}}));
  show_sizes("words", derive_sizes({{"nodes"}, {"two pass"}}));
  show_sizes("numbers of cells", derive_sizes_of_cells({1000, 8000, 27000}));
  show_sizes("as many cells", derive_sizes_of_cells({1000, 8000, 8000}));
  show_sizes("cells not known", derive_sizes_of_cells({1000, missing, 8000}));
}

/** Runs 0 to 4 of one variant, 5 to 9 of another: mesh in three steps, penalty in three. */
std::vector<SweepVariant> make_variants()
{
  std::vector<SweepVariant> variants;
  for (const std::size_t first : {0, 5})
    variants.push_back({first == 0 ? "thin" : "thick",
                        first + 4,
                        {{"mesh", {first, first + 1, first + 4}, {4, 2, 1}},
                         {"penalty", {first + 2, first + 3, first + 4}, {4, 2, 1}}}});
  return variants;
}

void show_verdict(const std::string &name, const std::vector<double> &values)
{
  const auto     variants = make_variants();
  const ErrorBar a        = compute_error_bar(variants[0], values),
                 b        = compute_error_bar(variants[1], values),
                 d        = compute_difference(variants[0], variants[1], values);
  std::cout << name << ": " << a.value << " +- " << a.error << ", " << b.value << " +- " << b.error
            << ", difference " << d.value << " +- " << d.error << ": "
            << word_for(judge_difference(a, b, d)) << std::endl;
}

void verdicts()
{
  // By mesh 11, 9, 8, by penalty 9.5, 8.5, 8: of order one, errors 1 and 0.5.
  const std::vector<double> thin = {11, 9, 9.5, 8.5, 8};
  const auto                both = [&thin](const std::vector<double> &thick) {
    std::vector<double> all = thin;
    all.insert(all.end(), thick.begin(), thick.end());
    return all;
  };
  show_verdict("far from each other", both({31, 29, 29.5, 28.5, 28}));
  show_verdict("the same errors, shifted by 1", both({12, 10, 10.5, 9.5, 9}));
  show_verdict("shifted by more than either error", both({13, 11, 11.5, 10.5, 10}));
  show_verdict("other errors", both({9, 9, 9, 9, 9.5}));
  show_verdict("a run failed", both({31, missing, 29.5, 28.5, 28}));
  show_verdict("two runs failed", both({missing, missing, 29.5, 28.5, 28}));
  // By mesh of order 2 and of order 1; the difference, 12, 6, 5, has no order.
  show_verdict("less than its own error", {110, 102, 100, 100, 100, 98, 96, 95, 95, 95});
  const double more = 20 + std::ldexp(1., -36);
  show_verdict("round-off", {20, 20, 20, 20, 20, more, more, more, more, more});
  show_verdict("the variant failed", both({31, 29, 29.5, 28.5, missing}));
}

void tables()
{
  std::vector<NamedFigures> all;
  std::vector<std::string>  runs;
  for (const double value : {11., 9., 9.5, 8.5, 8., 31., missing, 29.5, 28.5, 28.})
    {
      runs.push_back("run_" + std::to_string(runs.size()));
      all.push_back({{"dte", {value, "arcsec"}}, {"force", {missing, "N"}}});
    }
  const ErrorTables tables = compute_error_tables(make_variants(), runs, all);
  tables.bars.write_csv(std::cout);
  tables.differences.write_csv(std::cout);
}

int main()
{
  known_orders();
  std::cout.precision(6);
  other_sequences();
  sizes();
  verdicts();
  tables();
  return 0;
}
