// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/number_text.h>
#include <vfife/mesh/shaft_sections.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>

namespace vfife
{
  namespace
  {
    bool overlap(const ShaftSection &a, const ShaftSection &b)
    {
      return std::max(a.from, b.from) < std::min(a.to, b.to) &&
             std::max(a.inner, b.inner) < std::min(a.outer, b.outer);
    }

    std::string quoted(const std::size_t k, const std::string &part)
    {
      return "section " + std::to_string(k + 1) + " (\"" + part + "\")";
    }
  } // namespace

  std::vector<ShaftSection> parse_shaft_sections(const std::string &text, const std::string &entry)
  {
    std::vector<ShaftSection> sections;
    std::istringstream        all(text);
    for (std::string part; std::getline(all, part, ',');)
      {
        const std::string   name = quoted(sections.size(), part);
        std::istringstream  words(part);
        std::vector<double> numbers;
        for (std::string word; words >> word;)
          {
            const std::optional<double> number = plain_number(word);
            if (!number)
              throw InputError(entry,
                               name + ": expected numbers FROM TO OUTER [INNER], got \"" + word +
                                 "\"");
            numbers.push_back(*number);
          }
        if (numbers.size() != 3 && numbers.size() != 4)
          throw InputError(entry,
                           name + ": expected FROM TO OUTER [INNER], got " +
                             std::to_string(numbers.size()) + " numbers");
        sections.push_back(
          {numbers[0], numbers[1], numbers[2], numbers.size() == 4 ? numbers[3] : 0.});
        const ShaftSection &now = sections.back();
        if (!(now.to > now.from))
          throw InputError(entry, name + " must have TO above FROM");
        if (!(now.outer > now.inner) || now.inner < 0)
          throw InputError(entry,
                           name + ": OUTER must be larger than INNER, and neither may be negative");
        for (std::size_t k = 0; k + 1 < sections.size(); ++k)
          if (overlap(sections[k], now))
            throw InputError(entry, name + " crosses section " + std::to_string(k + 1));
      }
    if (sections.empty())
      throw InputError(entry, "expected sections FROM TO OUTER [INNER], got none");
    return sections;
  }

  void declare_cell_sizes(dealii::ParameterHandler &prm,
                          double                   &axial,
                          double                   &radial,
                          const std::string        &where)
  {
    declare_quantity(prm,
                     "axial element size",
                     axial,
                     "mm",
                     "Maximum length of an element along the axis" + where,
                     Range::positive());
    declare_quantity(prm,
                     "radial element size",
                     radial,
                     "mm",
                     "Maximum length of an element across the axis",
                     Range::positive());
  }

  std::string name_of_section(const std::string &text, const std::size_t k)
  {
    std::istringstream all(text);
    std::string        part;
    for (std::size_t i = 0; i <= k; ++i)
      std::getline(all, part, ',');
    return quoted(k, trimmed(part));
  }

  unsigned int count_cells(const double length, const double largest)
  {
    return std::max(1u, static_cast<unsigned int>(std::ceil(length / largest - 1e-9)));
  }

  std::vector<double> divide_between(const std::set<double> &places, const double largest)
  {
    std::vector<double> ends = {*places.begin()};
    for (auto place = std::next(places.begin()); place != places.end(); ++place)
      {
        const double       from  = ends.back();
        const unsigned int cells = count_cells(*place - from, largest);
        for (unsigned int cell = 1; cell < cells; ++cell)
          ends.push_back(from + (*place - from) * cell / cells);
        // To the last digit: others are compared with these places.
        ends.push_back(*place);
      }
    return ends;
  }
} // namespace vfife
