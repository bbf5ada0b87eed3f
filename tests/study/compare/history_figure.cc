// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers taken of made-up histories, their errors and orders of convergence.
#include "../../refusal.h"
#include "../../tests.h"

#include <vfife/base/text/table.h>
#include <vfife/base/types.h>
#include <vfife/study/sweep/history_figure.h>

#include <deal.II/base/parameter_handler.h>

using namespace vfife;

/** A pulse of height 3 with ramps of 1 s between 2 s and 7 s, and a vibration of 1.25 Hz. */
Table make_history()
{
  Table table;
  table.add_column("time", "s");
  table.add_column("force", "N");
  table.add_column("end displacement x", "mm");
  for (unsigned int i = 0; i <= 1000; ++i)
    {
      const double t = 0.01 * i;
      table.add_row({t,
                     3 * std::max(0., std::min({1., t - 2, 7 - t})),
                     0.5 * std::sin(2 * pi * 1.25 * t + 0.3) + 0.001});
    }
  return table;
}

Figure take(const std::string &column, const FigureValue value)
{
  HistoryFigure figure;
  figure.column = column;
  figure.value  = value;
  return figure.compute(make_history());
}

void values()
{
  check_close("largest", take("force", FigureValue::largest).value, 3, 1e-12);
  check_close("first", take("end displacement x", FigureValue::first).value, 0.14876, 1e-5);
  check_close("largest size",
              take("end displacement x", FigureValue::largest_size).value,
              0.501,
              1e-3);
  // The ends of both ramps lie between samples only by round-off.
  check_close("time above half", take("force", FigureValue::time_above_half).value, 4, 1e-9);
  check("its unit", take("force", FigureValue::time_above_half).unit == "s");
  // Plateau of 3 s at 3 N, twice half a second at 2.25 N on the mean; 100 samples of a second.
  check_close("mean above half", take("force", FigureValue::mean_above_half).value, 2.8125, 5e-3);
  // The offset moves crossings up and down alike, and those at both ends of the count are of one
  // kind or differ by 0.0013 s.
  check_close("zero crossing rate",
              take("end displacement x", FigureValue::zero_crossing_rate).value,
              1.25,
              1e-3);
}

/** Of a record whose samples all differ: which of them, or how many times which. */
void single_values()
{
  Table table;
  table.add_column("time", "s");
  table.add_column("energy", "mJ");
  // Unequal steps: means and extremes are of the samples, whenever they were.
  const double samples[] = {8, -10, 4, 9, -1};
  const double times[]   = {0, 1, 1.5, 4, 4.5};
  for (unsigned int i = 0; i < 5; ++i)
    table.add_row({times[i], samples[i]});
  const auto taken =
    [&table](const FigureValue value, const std::string &unit, const double expected) {
      HistoryFigure figure;
      figure.column     = "energy";
      figure.value      = value;
      const Figure here = figure.compute(table);
      check_close(word_of(value, figure_value_choices()), here.value, expected, 1e-14);
      check(word_of(value, figure_value_choices()) + ": its unit", here.unit == unit);
    };
  taken(FigureValue::last, "mJ", -1);
  taken(FigureValue::first, "mJ", 8);
  taken(FigureValue::mean, "mJ", 2);
  taken(FigureValue::largest, "mJ", 9);
  taken(FigureValue::where_largest, "s", 4);
  taken(FigureValue::smallest, "mJ", -10);
  taken(FigureValue::largest_size, "mJ", 10);
  taken(FigureValue::peak_to_peak, "mJ", 19);
  taken(FigureValue::change, "-", -1. / 8 - 1);
  // 8 and 9 lie above 4.5.
  taken(FigureValue::mean_above_half, "mJ", 8.5);
  // It begins above, goes down through 4.5 after 3.5/18 s, up a tenth of 2.5 s after 1.5 s, down
  // 0.45 of 0.5 s after 4 s.
  taken(FigureValue::time_above_half, "s", 3.5 / 18 + (4 + .225) - (1.5 + .25));
  // Three crossings are two half periods: the first after 8/18 s, the last 0.9 of 0.5 s after 4
  // s.
  taken(FigureValue::zero_crossing_rate, "Hz", .5 * 2 / (4.45 - 8. / 18));
}

/** Why there is no number. */
void show_lack(const HistoryFigure &figure, const Table &table)
{
  const FoundFigure found = figure.compute(table);
  check("no number", std::isnan(found.value));
  std::cout << found.fault << std::endl;
}

/** A pulse that the end of the record cuts off: above half of 8 from 1.5 s on. */
void cut_off()
{
  Table table;
  table.add_column("time", "s");
  table.add_column("force", "N");
  for (const auto &[time, force] : {std::make_pair(1., 0.), {2., 8.}, {4., 6.}, {4.5, 5.}})
    table.add_row({time, force});
  HistoryFigure figure;
  figure.column = "force";
  figure.value  = FigureValue::time_above_half;
  check_close("above half at the end", figure.compute(table).value, 3., 1e-14);
}

/** A column by its name of the previous version. */
void former_name()
{
  Table table;
  table.add_column("time", "s");
  table.add_column("removed by the driven speed damping", "mJ");
  table.add_row({0., 0.});
  table.add_row({1., 3.});
  HistoryFigure figure;
  figure.column = "taken by the driven speed damping";
  check_close("a column by its former name", figure.compute(table).value, 3., 0.);
}

/** Rows over speed, up and down. */
void over_speed()
{
  Table table;
  table.add_text_column("direction");
  table.add_column("speed", "rpm");
  table.add_column("amplification", "-");
  table.add_row({"up", 1000., 1.1});
  table.add_row({"up", 2000., 1.3});
  table.add_row({"down", 2000., 1.2});
  table.add_row({"down", 1000., 1.4});
  HistoryFigure figure;
  figure.table  = FigureTable::stress_response;
  figure.column = "amplification";
  figure.value  = FigureValue::where_largest;
  check("file", figure.file() == "stress_response.csv");
  check_close("the speed of the largest", figure.compute(table).value, 1000, 0);
  check("its unit", figure.compute(table).unit == "rpm");
  figure.value = FigureValue::largest;
  check_close("largest of all rows", figure.compute(table).value, 1.4, 0);
  figure.from = 1e-3;
  print_refusal([&]() { figure.check("Sweep/Figure x"); });
  figure.from  = 0;
  figure.value = FigureValue::last;
  print_refusal([&]() { figure.check("Sweep/Figure x"); });
  figure.table = FigureTable::history;
  figure.check("Sweep/Figure x");
}

/** A mesh's vibration of amplitude 3 beside another one of 4, and a mean. */
void shares_of_meshes()
{
  Table table;
  table.add_column("time", "s");
  table.add_column("mesh frequency", "Hz");
  table.add_column("force", "N");
  for (unsigned int i = 0; i <= 1000; ++i)
    {
      const double t = 0.01 * i;
      // Until 2 s something else; ten meshes of 80 samples are left, which both fill.
      table.add_row(
        {t,
         1.25,
         t < 2 - 1e-9 ? 77. * i
                      : 9 + 3 * std::sin(2 * pi * 1.25 * t) + 4 * std::cos(2 * pi * .125 * 3 * t)});
    }
  HistoryFigure figure;
  figure.column = "force";
  figure.value  = FigureValue::periodic_share;
  figure.from   = 2 - 1e-9;
  check_close("periodic share", figure.compute(table).value, 9. / 25, 1e-9);
  check("its unit", figure.compute(table).unit == "-");
  // The other vibration has three whole periods in ten meshes.
  figure.value = FigureValue::periodic_peak_to_peak;
  check_close("peak to peak of the mean mesh cycle", figure.compute(table).value, 6., 1e-9);
  check("its unit", figure.compute(table).unit == "N");
  figure.from = 8.5;
  show_lack(figure, table);
  figure.value = FigureValue::first;
  check_close("first from a time on", figure.compute(table).value, table.numbers("force")[850], 0);
  figure.from = 11;
  show_lack(figure, table);
}

/** Records that have no such number. */
void lacks()
{
  const Table   table = make_history();
  HistoryFigure figure;
  figure.column = "force";
  figure.value  = FigureValue::change;
  show_lack(figure, table);
  figure.value = FigureValue::zero_crossing_rate;
  figure.from  = 5;
  show_lack(figure, table);
  figure.value = FigureValue::mean_above_half;
  figure.from  = 7.5;
  show_lack(figure, table);
  figure.value = FigureValue::largest;
  check("a number has no fault", figure.compute(table).fault.empty());
}

/** Half a newton more each mesh, of which a straight rise adds nothing within one, beside a
 * vibration of the mesh. */
void trend()
{
  Table table;
  table.add_column("time", "s");
  table.add_column("mesh frequency", "Hz");
  table.add_column("force", "N");
  for (unsigned int i = 0; i <= 800; ++i)
    table.add_row({.01 * i, 1.25, 2. + .5 * .0125 * i + std::sin(2 * pi * .0125 * i)});
  HistoryFigure figure;
  figure.column = "force";
  figure.value  = FigureValue::trend;
  check_close("trend", figure.compute(table).value, .5, 1e-12);
  check("trend: its unit", figure.compute(table).unit == "N/mesh");
  figure.from = 7;
  check("trend of less than two meshes", std::isnan(figure.compute(table).value));
}

/** As a section of a parameter file has it. */
double read_and_take(const std::string &value)
{
  HistoryFigure            figure;
  dealii::ParameterHandler prm;
  figure.declare(prm);
  prm.parse_input_from_string("set column = force\nset value = " + value + "\n");
  return figure.compute(make_history()).value;
}

void words()
{
  // The pulse's area is 12 N s; 1001 samples in 10 s.
  check_close("word mean", read_and_take("mean"), 1200. / 1001, 1e-12);
  check_close("word largest", read_and_take("largest"), 3, 1e-12);
  check_close("word smallest", read_and_take("smallest"), 0, 0);
  check_close("smallest", take("end displacement x", FigureValue::smallest).value, -0.499, 1e-3);
}

void orders()
{
  HistoryFigure figure;
  figure.reference = "4";
  check_close("error", figure.compute_error(5), 0.25, 1e-15);
  figure.reference = "0";
  check_close("error beside zero", figure.compute_error(5), 5, 0);
  check_close("second order, cells", compute_order(0.4, 0.1, {"10", "2"}, {"20", "2"}), 2, 1e-12);
  check_ratio("first order, a size", compute_order(0.4, -0.2, {"2 mm"}, {"1 mm"}), 1e-12);
  check_close("cells in one ratio", compute_order(0.9, 0.1, {"10", "60"}, {"30", "180"}), 2, 1e-12);
  check("none between unequal ratios",
        std::isnan(compute_order(0.4, 0.1, {"10", "60"}, {"20", "180"})));
  check_close("sizes in two units", compute_order(0.4, 0.1, {"1 mm"}, {"500 um"}), 2, 1e-12);
  check("none between a bare number and one with a unit",
        std::isnan(compute_order(0.4, 0.1, {"1"}, {"500 um"})));
  check("none between dimensions", std::isnan(compute_order(0.4, 0.1, {"1 mm"}, {"0.5 s"})));
  check("none between words",
        std::isnan(compute_order(0.4, 0.1, {"polar", "80"}, {"three nodes", "10"})));
  check("none of equal runs", std::isnan(compute_order(0.4, 0.1, {"10"}, {"10"})));
}

void show_error(const HistoryFigure &figure)
{
  print_refusal([&] {
    figure.check("Sweep/Figure end");
    figure.compute(make_history());
  });
}

int main()
{
  values();
  single_values();
  cut_off();
  former_name();
  over_speed();
  shares_of_meshes();
  trend();
  lacks();
  words();
  orders();
  HistoryFigure figure;
  show_error(figure);
  figure.column = "end displacment x";
  show_error(figure);
  figure.table = FigureTable::teeth;
  show_error(figure);
  figure.value = FigureValue::largest;
  show_error(figure);
  figure.reference = "abc";
  show_error(figure);
  return 0;
}
