// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Tables as CSV and JSON, texts of CSV files, the log, the timers, and the neighbours of facets.

#include <vfife/base/facet_surface.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/timers.h>
#include <vfife/base/text/csv_text.h>
#include <vfife/base/text/table.h>

#include "../refusal.h"
#include "../tests.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

using namespace vfife;

void check_table()
{
  Table table;
  table.add_column("time", "s");
  table.add_text_column("side");
  table.add_column("force", "N");
  table.add_row({0, "drive", 1. / 3.});
  table.add_row({1e-7, "coast, \"back\"", -2});
  table.add_row({2u, "", std::numeric_limits<double>::quiet_NaN()});

  check("header", table.csv_header() == "time [s],side,force [N]");
  check("row", table.csv_row(0) == "0,drive,0.3333333333333333");
  check("quoted text", table.csv_row(1) == "1e-07,\"coast, \"\"back\"\"\",-2");
  check("not a number", table.csv_row(2) == "2,,nan");
  std::ostringstream csv;
  table.write_csv(csv);
  check("csv",
        csv.str() == table.csv_header() + "\n" + table.csv_row(0) + "\n" + table.csv_row(1) + "\n" +
                       table.csv_row(2) + "\n");

  std::stringstream text;
  table.write_json(text);
  const Json json = Json::parse(text);
  check("json is the same written and made", json == table.json());
  check("json",
        json["columns"][2]["unit"] == "N" && json["rows"][0][2].get<double>() == 1. / 3. &&
          json["rows"][1][1] == "coast, \"back\"" && json["rows"][2][2].is_null());
  check("numbers of a column", table.numbers("time") == std::vector<double>({0., 1e-7, 2.}));

  check("a number is refused as text",
        refuses<std::logic_error>([&] {
          table.add_row({1, 2, 3});
        }) &&
          table.n_rows() == 3);
}
void check_csv_text()
{
  std::istringstream file("time [s], side,\"a \"\"b\"\", c [1]\"\r\n 0 ,\"x, y\",3\n\n1,,\n");
  const CsvText      text = read_csv(file, "the table");
  check("headings",
        text.headings.size() == 3 && text.headings[0].name == "time" &&
          text.headings[0].unit == "s" && text.headings[1].name == "side" &&
          !text.headings[1].unit && text.headings[2].name == "a \"b\", c");
  check("cells",
        text.rows.size() == 2 &&
          text.rows[0].cells == std::vector<std::string>({"0", "x, y", "3"}) &&
          text.rows[1].cells == std::vector<std::string>({"1", "", ""}) &&
          text.rows[1].place == "the table, line 4");
  std::istringstream other("\xEF\xBB\xBF"
                           "a [s],b\r1,2\r");
  const CsvText      same = read_csv(other, "the table");
  check("byte order mark, lines that end by CR",
        same.headings[0].name == "a" && same.headings[0].unit == "s" && same.rows.size() == 1 &&
          same.rows[0].place == "the table, line 2");
  for (const char *wrong : {"",
                            "a,b\n1,2\n3\n",
                            "0,1\n1,2\n",
                            "a,b,a\n1,2,3\n",
                            "\xFF\xFE"
                            "a\n"})
    print_refusal([&] {
      std::istringstream in(wrong);
      read_csv(in, "the table");
    });
}

void check_log()
{
  std::ostringstream screen, file, other_screen;
  Log                log(screen, true);
  log.line("mass ", 3.5, " kg");
  log.detail("not shown");
  log.write_to(file);
  for (unsigned int i = 0; i < 3; ++i)
    log.warning("web is thin");
  log.set_verbosity(Verbosity::quiet);
  log.line("end");
  log.warning("quiet");
  check("screen", screen.str() == "mass 3.5 kg\nwarning: web is thin\nwarning: quiet\n");
  check("file", file.str() == "mass 3.5 kg\nwarning: web is thin\nend\nwarning: quiet\n");
  check("warnings",
        log.warnings().size() == 2 && log.warnings()[0].count == 3 && log.warnings()[1].count == 1);

  Log other(other_screen, false);
  other.line("nothing");
  other.warning("kept");
  check("other ranks are silent", other_screen.str().empty() && other.warnings().size() == 1);
}

void check_timers()
{
  Timers             timers;
  const unsigned int outer = timers.section("outer"), inner = timers.section("inner");
  for (unsigned int i = 0; i < 2; ++i)
    {
      const auto outer_scope = timers.time(outer);
      const auto inner_scope = timers.time(inner);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  check("a known name gives the same section", timers.section("outer") == outer);
  // the outer section does nothing but open the inner one; a loaded machine may take its time for
  // that
  check("the outer clock stands still",
        timers.seconds(inner) >= 0.04 && timers.seconds(outer) < timers.seconds(inner));

  const Table               table = timers.report(Communicator(MPI_COMM_SELF));
  const std::vector<double> time  = table.numbers("time");
  check("rows", table.n_rows() == 4 && table.column("section").texts[2] == "other");
  check("calls", table.numbers("calls")[1] == 2.);
  // the clock runs on between reading sections and total: a scheduler's time slice at most
  check_close("sections add up", time[0] + time[1] + time[2], time[3], 0.1 * time[3]);
}

void check_neighbours()
{
  // 2 x 1 facets side by side: facet 0 meets facet 1 with its side xi = 1
  FacetSurface surface;
  surface.name   = "top";
  surface.facets = {{{0, 1, 4, 3}}, {{1, 2, 5, 4}}};
  find_neighbours(surface);
  const unsigned int none = FacetSurface::no_facet;
  check("neighbours",
        surface.neighbours[0] == std::array<unsigned int, 4>{{none, 1, none, none}} &&
          surface.neighbours[1] == std::array<unsigned int, 4>{{none, none, none, 0}});

  for (const std::array<unsigned int, 4> wrong :
       {std::array<unsigned int, 4>{{1, 4, 5, 2}}, {{1, 4, 7, 6}}})
    {
      surface.facets[1] = wrong;
      surface.facets.resize(2);
      if (wrong[2] == 7)
        {
          surface.facets[1] = {{1, 2, 5, 4}};
          surface.facets.push_back(wrong);
        }
      print_refusal([&] { find_neighbours(surface); });
    }
}

int main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  check_table();
  check_csv_text();
  check_log();
  check_timers();
  check_neighbours();
  MPI_Finalize();
  return 0;
}
