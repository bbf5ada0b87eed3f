// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Entries of errors of manufacture: pitch deviations from lists, tables and cosines, grids in both
// formats, and what is said of input that cannot be used.
#include "../parts.h"
#include "../read_entries.h"
#include "../refusal.h"
#include "../tests.h"
#include "paper_pair.h"

#include <fstream>

using namespace vfife;

constexpr double um = 1e-3;

FlankErrorOptions read(const std::string &text)
{
  static FlankErrorOptions options; // entries are bound to its address
  options = {};
  read_entries(options, text);
  return options;
}

void write(const std::string &file, const std::string &text)
{
  std::ofstream(file) << text;
}

/** Prints what is wrong and with which entry. */
template <typename Read>
void refuse(const std::string &name, const Read &reads)
{
  std::cout << name << ": ";
  print_refused_entry(reads);
}

void check_pitch(const std::string         &name,
                 const std::vector<double> &found,
                 const std::vector<double> &expected)
{
  double off = found.size() == expected.size() ? 0. : 1.;
  for (std::size_t k = 0; k < expected.size() && k < found.size(); ++k)
    raise_to(off, std::abs(found[k] / um - expected[k]));
  check_below(name, off, 1e-12);
}

void pitch()
{
  // singles 1, 2, -4, 1: tooth 0 is the datum
  check_pitch("list of single deviations",
              read("set single pitch deviations = 1, 2, -4, 1").read_pitch("E", 4),
              {0., 2., -2., -1.});
  check_pitch("rounding of singles is shared",
              read("set single pitch deviations = 1, 2, -4, 1.2").read_pitch("E", 4),
              {0., 1.95, -2.1, -.95});
  write("single.csv", "tooth,single pitch deviation [um]\n2,-4\n0,1\n1,2\n3,1\n");
  check_pitch("table of single deviations",
              read("set pitch table = single.csv").read_pitch("E", 4),
              {0., 2., -2., -1.});
  write("millimetres.csv", "tooth,single pitch deviation [mm]\n2,-4e-3\n0,1e-3\n1,2e-3\n3,1e-3\n");
  check_pitch("table in another unit",
              read("set pitch table = millimetres.csv").read_pitch("E", 4),
              {0., 2., -2., -1.});
  write("cumulative.csv", "tooth,cumulative pitch deviation [um]\n0,0\n1,2\n2,-2\n3,7.5\n");
  check_pitch("table of cumulative ones, and a cosine",
              read("set pitch table = cumulative.csv\nset pitch amplitude = 3 um\nset pitch order "
                   "= 1\nset pitch phase = 90 deg")
                .read_pitch("E", 4),
              {0., 5., -2., 4.5});
  check("no deviations", read("").read_pitch("E", 4).empty());

  refuse("too few", []() { read("set single pitch deviations = 1, 2, -3").read_pitch("E", 4); });
  refuse("no number",
         []() { read("set single pitch deviations = 1, 2, x, 0").read_pitch("E", 4); });
  refuse("not finite",
         []() { read("set single pitch deviations = 1, 2, nan, 0").read_pitch("E", 4); });
  refuse("not closed",
         []() { read("set single pitch deviations = 0, 0, 10, 0").read_pitch("E", 4); });
  refuse("two sources", []() {
    read("set single pitch deviations = 1, 2, -4, 1\nset pitch table = single.csv")
      .read_pitch("E", 4);
  });
  refuse("rows of the table", []() { read("set pitch table = single.csv").read_pitch("E", 5); });
  write("wrong.csv", "tooth,single pitch deviation [um]\n0,-4\n1,1\n2,2\n4,1\n");
  refuse("unknown tooth", []() { read("set pitch table = wrong.csv").read_pitch("E", 4); });
  write("wrong.csv", "tooth,single pitch deviation [um]\n0,-4\n1,1\n1,2\n3,1\n");
  refuse("tooth twice", []() { read("set pitch table = wrong.csv").read_pitch("E", 4); });
  write("wrong.csv", "tooth,pitch [um]\n0,-4\n1,1\n2,2\n3,1\n");
  refuse("other column", []() { read("set pitch table = wrong.csv").read_pitch("E", 4); });
  refuse("no file", []() { read("set pitch table = nowhere.csv").read_pitch("E", 4); });
}

void topography()
{
  write("grid.csv", "# tip above, heel right\n1, 2, 3\n4; 5; 6\n");
  const Eigen::MatrixXd grid = read("set topography = grid.csv").read_topography("E") / um;
  check("root first", grid.rows() == 2 && grid.cols() == 3 && grid(0, 2) == 6. && grid(1, 0) == 1.);
  write("table.csv",
        "row,column,x [mm],deviation [um]\n2,1,9,4\n1,1,9,1\n1,2,9,2\n2,3,9,6\n2,2,9,5\n1,3,9,3\n");
  check("a table in any order",
        read("set topography = table.csv").read_topography("E") / um == grid);
  check("no grid", read("").read_topography("E").size() == 0);
  check("teeth",
        (read("set topography = grid.csv\nset topography teeth = 2, 0").read_teeth("E", 4) ==
         std::vector<bool>{true, false, true, false}));

  const auto refuse_grid = [](const std::string &name, const std::string &text) {
    write("wrong.csv", text);
    refuse(name, []() { read("set topography = wrong.csv").read_topography("E"); });
  };
  refuse_grid("empty file", "");
  refuse_grid("only comments", "# nothing\n\n");
  refuse_grid("one row", "1,2,3\n");
  refuse_grid("hole", "1,2,3\n4,,6\n7,8,9\n");
  refuse_grid("short row", "1,2,3\n4,5\n");
  refuse_grid("long row", "1,2,3\n4,5,6,7\n");
  refuse_grid("not a number", "1,2,3\n4,nan,6\n");
  refuse_grid("text", "1,2,3\n4,5 a,6\n");
  refuse_grid("hole of a table", "row,column,deviation [um]\n1,1,0\n1,2,0\n2,2,0\n");
  refuse_grid("twice in a table", "row,column,deviation [um]\n1,1,0\n1,2,0\n2,2,0\n2,2,0\n");
  refuse_grid("row 0 of a table", "row,column,deviation [um]\n0,1,0\n1,2,0\n2,2,0\n2,1,0\n");
  write("places.csv",
        "row,column,L [mm],h [mm],deviation [um]\n1,1,100,2,1\n1,2,120,3,2\n2,1,100,-2,4\n"
        "2,2,120,-3,5\n");
  check("places that go from tip to root and from toe to heel",
        read("set topography = places.csv").read_topography("E").rows() == 2);
  refuse_grid("heel before the toe",
              "row,column,L [mm],h [mm],deviation [um]\n1,1,120,2,1\n1,2,100,3,2\n"
              "2,1,120,-2,4\n2,2,100,-3,5\n");
  refuse_grid("columns on one place",
              "row,column,L [mm],deviation [um]\n1,1,100,1\n1,2,120,2\n2,1,110,4\n2,2,110,5\n");
  refuse_grid("root before the tip",
              "row,column,L [mm],h [mm],deviation [um]\n1,1,100,-2,1\n1,2,120,-3,2\n"
              "2,1,100,2,4\n2,2,120,3,5\n");
  refuse("no grid file", []() { read("set topography = nowhere.csv").read_topography("E"); });
  refuse("unknown tooth", []() {
    read("set topography = grid.csv\nset topography teeth = 1, 4").read_teeth("E", 4);
  });
  refuse("teeth without a grid", []() { read("set topography teeth = 1").read_teeth("E", 4); });
  refuse("margin", []() { read("set profile margin = 0.5"); });
}

/** Of a pair, with the paths of its entries; more than one at once. */
void pair()
{
  GearPairOptions options                      = paper::options();
  options.pinion_errors.convex.pitch_list      = "1, -1";
  options.gear_errors.concave.topography       = "nowhere.csv";
  options.gear_errors.concave.topography_teeth = {"79"};
  try
    {
      options.check("Gear pair");
    }
  catch (const InputError &error)
    {
      std::cout << error.entry() << std::endl;
    }
  options.pinion_errors = {};
  try
    {
      GearPair pair(options);
    }
  catch (const InputErrors &errors)
    {
      for (const InputError &error : errors.errors())
        std::cout << error.entry() << ": " << error.what() << std::endl;
    }
}

int main()
{
  return run_parts({pitch, topography, pair});
}
