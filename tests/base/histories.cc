// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Quantities over time: values, integrals and their inverse of constants, tables and formulas
// against closed forms, units of headings, what is refused.
#include "../history_of.h"
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/types.h>

#include <fstream>

using namespace vfife;

constexpr double rpm = pi / 30;

void constants()
{
  const QuantityOverTime speed = history_of("20000 rpm", "rpm");
  check("constant: value, and the factor is one",
        speed.start == 20000 * rpm && speed.factor.is_constant() && speed.factor.value(3.) == 1 &&
          speed.factor.integral(.3) == .3 && speed.factor.find_time(.3) == .3);
  check("constant: another unit", history_of("100 rad/s", "rpm").start == 100.);
}

/** A table from 2 to 5 ms, constant outside: straight lines have closed integrals. */
void tables()
{
  std::ofstream("speed.csv") << "time [ms],speed [rpm]\n2,1000\n3,3000\n5,2000\n";
  const QuantityOverTime  speed = history_of("speed.csv", "rad/s");
  const ParameterHistory &f     = speed.factor;
  check_close("table: value at time zero, that of the first row", speed.start, 1000 * rpm, 1e-12);
  check("table: neither constant nor formula", !f.is_constant() && !f.is_formula());
  check_close("table: factor between rows", f.value(2.25e-3), 1.5, 1e-14);
  check_close("table: factor behind the last row", f.value(1.), 2., 1e-14);
  check_close("table: integral in front of it", f.integral(1e-3), 1e-3, 1e-18);
  check_close("table: integral within it", f.integral(2.5e-3), 2e-3 + .5e-3 * 1.5, 1e-17);
  check_close("table: integral behind it",
              f.integral(7e-3),
              2e-3 + 2e-3 + 2e-3 * 2.5 + 2e-3 * 2,
              1e-17);
  check_close("table: integral before time zero", f.integral(-1e-3), -1e-3, 1e-18);
  for (const double t : {1e-3, 2.7e-3, 4e-3, 9e-3})
    check_close("table: time of an integral", f.find_time(f.integral(t)), t, 1e-15);
  const auto range = f.find_range(4e-3);
  check("table: range", range.first == 1 && std::abs(range.second - 3) < 1e-14);
  check_close("table: its end", f.end(), 5e-3, 1e-18);

  // The same in the units of the description, blanks and no heading.
  std::ofstream("plain.txt") << "2e-3 1000\n3e-3 3000\n5e-3 2000\n";
  const QuantityOverTime plain = history_of("plain.txt", "rpm");
  check_close("table without heading: value", plain.start, 1000 * rpm, 1e-12);
  check_close("table without heading: factor", plain.factor.value(4e-3), 2.5, 1e-14);
}

/** The table of plain.txt in other spellings. */
void spellings()
{
  const auto same = [](const std::string &name, const std::string &text) {
    std::ofstream("spelling.csv", std::ios::binary) << text;
    std::string found;
    const auto  refusal = message_of([&] {
      const QuantityOverTime speed = history_of("spelling.csv", "rpm");
      found                        = std::abs(speed.start / (1000 * rpm) - 1) < 1e-12 &&
                  std::abs(speed.factor.value(4e-3) - 2.5) < 1e-12 &&
                  std::abs(speed.factor.value(2.5e-3) - 2) < 1e-12 && speed.factor.end() == 5e-3
                                        ? ""
                                        : "other numbers";
    });
    check("spelling: " + name, found + refusal == "");
  };
  const std::string rows = "2e-3,1000\n3e-3,3000\n5e-3,2000\n", mark = "\xEF\xBB\xBF";
  same("byte order mark, no heading, CR LF", mark + "2e-3,1000\r\n3e-3,3000\r\n5e-3,2000\r\n");
  same("byte order mark and heading", mark + "time [ms],speed [rpm]\n2,1000\n3,3000\n5,2000\n");
  same("CR", "2e-3,1000\r3e-3,3000\r5e-3,2000\r");
  same("exponents with D", "2D-3,1.0d+03\n3.D-3,3000\n0.5D-2,2D3\n");
  same("empty columns behind, quotes", "\"2e-3\",\"1000\",\n3e-3,3000,\n5e-3,2000,,\n");
  same("semicolons", "time;speed\n2e-3;1000\n3e-3;3000\n5e-3;2000\n");
  same("title, comments, units that stay",
       "Run of today\n# by hand\ntime [ms],speed\n-,-\n"
       "2,1000\n# later\n3,3000\n5,2000\n");
  same("units in round brackets", "Time (ms),Speed (rpm)\n2,1000\n3,3000\n5,2000\n");
  same("units in a line of their own", "t,n\nms,rpm\n2,1000\n3,3000\n5,2000\n");
  same("units between blanks", "time [ms] speed [rpm]\n2 1000\n3 3000\n5 2000\n");
  same("a heading in a comment", "# time [ms],speed\n2,1000\n3,3000\n5,2000\n");
  same("rows alone", rows);
  for (const std::string wrong : {"O.0,0\n1e-3,1\n",
                                  "0,,1\n1e-3,1,1\n",
                                  "0,\n1e-3,1\n",
                                  "0;0,5\n1;1,5\n",
                                  "time [ms],speed [kN]\n0,1\n",
                                  "0,1,2\n"})
    {
      std::ofstream("wrong.csv") << wrong;
      print_refusal([] { history_of("wrong.csv", "rpm"); });
    }
}

void formulas()
{
  const QuantityOverTime speed = history_of("2000 + 1e5*t + 500*(1 - cos(2*pi*40*t))", "rpm");
  const auto             exact = [](const double t) {
    return t + 25. * t * t + .25 * (t - std::sin(80 * pi * t) / (80 * pi));
  };
  check_close("formula: value at time zero", speed.start, 2000 * rpm, 1e-12);
  double wrong = 0, inverse = 0;
  for (const double t : {.0371, 1e-5, .1, .0123, .2})
    {
      raise_to(wrong, std::abs(speed.factor.integral(t) / exact(t) - 1));
      raise_to(inverse, std::abs(speed.factor.find_time(exact(t)) / t - 1));
    }
  check_below("formula: integral to round-off", wrong, 1e-14);
  check_below("formula: time of an integral", inverse, 1e-13);
  check_close("formula: before time zero", speed.factor.integral(-.01), exact(-.01), 1e-16);
  // In whatever order: a run that goes on begins with a late time.
  const QuantityOverTime late = history_of("2000 + 1e5*t + 500*(1 - cos(2*pi*40*t))", "rpm");
  check("formula: the same digits in another order",
        late.factor.integral(.1876) == speed.factor.integral(.1876) &&
          late.factor.integral(.0371) == speed.factor.integral(.0371));
  // A jump within a panel.
  const QuantityOverTime jump = history_of("t < 0.00123 ? 1000 : 3000", "rpm");
  check_close("formula with a jump: integral",
              jump.factor.integral(.01),
              .00123 + 3 * (.01 - .00123),
              1e-15);
  check_close("formula: range",
              history_of("1000 + 1e5*t*(0.01 - t)", "rpm").factor.find_range(.01).second,
              1.0025,
              1e-12);
}

/** What muParser reads otherwise than it is written, and what has no value somewhere. */
void expressions()
{
  const auto value = [](const char *formula, const double x) {
    return Expression(formula)(Vector3(x, 0, 0), 0.);
  };
  check("expression: arguments of functions",
        value("max(x, 0.5) + pow (x, 3) + if(x > 1, 2, 3) + sum(1,5,x)", 2.) == 2. + 8. + 2. + 8.);
  check("expression: conditions in conditions", value("x < 1 ? 0 : x <= 3 ? 1 : 2", 2.) == 1.);
  check("expression: brackets around comparisons", value("(x < 5) == (x != 7)", 2.) == 1.);
  check("expression: a division by zero that has a limit", value("exp(-1/x)", 0.) == 0.);
  check("expression: a condition leaves a place out",
        value("x > 1 ? sqrt(x - 1) : 7", 0.) == 7. &&
          Expression("x > 1 && sqrt(x - 1) > 1").holds(Vector3(5, 0, 0)) &&
          !Expression("x > 1 && sqrt(x - 1) > 1").holds(Vector3::Zero()));
  for (const char *formula : {"0,5*x",
                              "(0,5)*x",
                              "2*(x > 9,5)",
                              "sin(0,5*x)",
                              "x = 5",
                              "x > 1 && x = 5",
                              "0 < x < 5",
                              "x > 1 == 1"})
    print_refusal([formula] { const Expression refused(formula); });
  for (const char *formula :
       {"sqrt(x - 10)*100", "1/x", "log(x - 1)", "x/x", "(x - 1)^0.5", "min(5, sqrt(-1 - x))"})
    print_refusal([formula] { Expression(formula, "Section/entry")(Vector3::Zero(), 0.); });
  for (const char *formula : {"1/x > 2", "sqrt(x - 10) > 2", "log(x)"})
    print_refusal([formula] { Expression(formula).holds(Vector3::Zero()); });
  // A history that has no value later on names its entry.
  ParameterHistory         history;
  dealii::ParameterHandler prm;
  history.declare(prm);
  prm.set("history", "sqrt(1e-3 - t)");
  history.check("Model/Load pull");
  check_close("history: as long as it has a value", history.value(0.), std::sqrt(1e-3), 1e-18);
  print_refused_entry([&] { history.value(2e-3); });
}

void refusals()
{
  std::ofstream("back.csv") << "0,1000\n1,2000\n1,3000\n";
  std::ofstream("metres.csv") << "time [m],speed [rpm]\n0,1000\n";
  std::ofstream("negative.csv") << "0,1000\n1,-2000\n";
  std::ofstream("three.csv") << "0,1000,7\n";
  for (const char *text : {"20000 rmp",
                           "20000 mm",
                           "-3 rpm",
                           "1000 + * t",
                           "1000 + 0,5*t",
                           "1000/t",
                           "1e5*t",
                           "missing.csv",
                           "back.csv",
                           "metres.csv",
                           "negative.csv",
                           "three.csv"})
    print_refusal([text] { history_of(text, "rpm", Range::not_negative()); });
  print_refusal([] { history_of("1000 - 1e6*t", "rpm").factor.find_time(1.); });
}

int main()
{
  return run_parts({constants, tables, spellings, formulas, expressions, refusals});
}
