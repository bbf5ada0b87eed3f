// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of tables of the pages, read from there, beside those of cases that are computed now:
// they have to agree within one unit of their last digit.
#ifndef vfife_tests_study_program_documented_page_h
#define vfife_tests_study_program_documented_page_h

#include "../../parts.h"
#include "../../read_files.h"
#include "../quick_pair.h"

#include <regex>
#include <string>
#include <vector>

const std::string element_page  = "verification/element.md",
                  dynamics_page = "verification/dynamics.md",
                  pair_page     = "verification/gear-pair.md",
                  paper         = "verification/case-study-27-79.md",
                  default_page  = "how-to/choose-the-mesh.md";

/** The page of gear pairs states the coarse pair with them. */
const std::string three_points = "Contact/points per facet=3";

/** A number of a page and what its last digit counts. */
struct Stated
{
  double value = std::nan(""), last_digit = 0.;
};

/** The numbers of a cell of a table in turn: "**1.7**, 3.8e-3 %" are 1.7 and 3.8e-3. */
inline std::vector<Stated> numbers_in(const std::string &cell)
{
  static const std::regex number("[+-]?([0-9]+)(\\.([0-9]+))?(e([+-]?[0-9]+))?");
  std::vector<Stated>     numbers;
  for (std::sregex_iterator found(cell.begin(), cell.end(), number), none; found != none; ++found)
    numbers.push_back({std::stod(found->str()),
                       std::pow(10.,
                                ((*found)[5].matched ? std::stod((*found)[5]) : 0.) -
                                  static_cast<double>((*found)[3].length()))});
  return numbers;
}

/** Cells of the first row of a page that begins with @p beginning, behind the heading. */
inline std::vector<std::string>
row_of(const std::string &page, const std::string &heading, const std::string &beginning)
{
  std::ifstream            file(tree_folder() + "/doc/" + page);
  std::vector<std::string> cells;
  bool                     here = false;
  for (std::string line; cells.empty() && std::getline(file, line);)
    {
      here = here || has_text(line, heading);
      if (!here || line.rfind("| " + beginning, 0) != 0)
        continue;
      std::istringstream row(line.substr(1));
      for (std::string cell; std::getline(row, cell, '|');)
        cells.push_back(cell);
    }
  check(page + ", " + beginning, !cells.empty());
  cells.resize(20);
  return cells;
}

/** The @p i-th number of a cell against what is found now. */
inline void
compare(const std::string &name, const std::string &cell, const std::size_t i, const double found)
{
  std::vector<Stated> stated = numbers_in(cell);
  stated.resize(std::max(stated.size(), i + 1));
  check_close("  " + name, found, stated[i].value, 1.001 * stated[i].last_digit);
}

/** Does a case of prm/, or of this folder, with other entries. */
inline std::string do_case(const std::string              &file,
                           const std::vector<std::string> &overrides,
                           vfife::Communicator            &world)
{
  const std::string folder = "documented";
  run_pair(file.rfind("prm/", 0) == 0 ? tree_folder() + "/" + file : file,
           folder,
           world,
           overrides);
  return folder + "/";
}

#endif
