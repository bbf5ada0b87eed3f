// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/case_sections.h>
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/quantity.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_reader.h>
#include <vfife/study/compare/compared_case.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** A quantity of one case and of another where they differ by more than what is written of
     * them. */
    std::string describe_difference(const std::string &name, const Figure &one, const Figure &other)
    {
      if (std::abs(one.value - other.value) <=
          1e-6 * std::max(std::abs(one.value), std::abs(other.value)))
        return "";
      std::ostringstream text;
      text << name << " " << one.value << " and " << other.value << " " << one.unit;
      return text.str();
    }

    /** Whether the entry of that path makes another pair, which geometry.json does not show. */
    bool makes_another_pair(const std::string &path)
    {
      const std::string pair = spiral_bevel_section;
      const auto        ends = [&path](const std::string &name) {
        return path.size() > name.size() &&
               path.compare(path.size() - name.size(), name.size(), name) == 0;
      };
      if (path.rfind(pair + "/Mounting/", 0) == 0)
        return !ends("/shaft angle") && !ends("/backlash");
      return path.rfind(pair + "/Errors/", 0) == 0 ||
             (path.rfind(pair + "/", 0) == 0 && (ends("/tip chamfer") || ends("/temperature")));
    }

    /** As describe_difference(); of formulas and names the texts. */
    std::string
    describe_entries(const std::string &path, const KeptEntry &one, const KeptEntry &other)
    {
      // Files are what they say, wherever they are.
      if (one.digest.empty() ? one.value == other.value : one.digest == other.digest)
        return "";
      const auto figure = [&one](const std::string &text) {
        return Figure{read_quantity(text, one.unit).in(find_unit(one.unit)), one.unit};
      };
      try
        {
          return describe_difference(path, figure(one.value), figure(other.value));
        }
      catch (const InputError &)
        {
          return path + " \"" + one.value + "\" and \"" + other.value + "\"";
        }
    }
  } // namespace

  bool ComparedCase::has(const std::string &file) const
  {
    return is_there(folder + "/" + file);
  }

  Table ComparedCase::table(const std::string &file) const
  {
    is_read = true;
    return read_result_table(folder + "/" + file);
  }

  double ComparedCase::number(const std::string &file, const std::string &pointer) const
  {
    is_read = true;
    return read_figure(folder + "/" + file, pointer);
  }

  std::vector<std::string> list_other_pairs(const ComparedCases &cases)
  {
    constexpr std::size_t    most  = 4; // names in a sentence
    const ComparedCase      *first = nullptr;
    NamedFigures             known;
    std::vector<std::string> sentences;
    // Of the first case, as those known.
    std::map<std::string, KeptEntry> known_entries;
    for (const ComparedCase &one : cases)
      {
        const NamedFigures geometry = read_geometry(one.folder);
        if (first == nullptr && !geometry.empty())
          {
            first         = &one;
            known         = geometry;
            known_entries = read_kept_entries(one.folder);
          }
        std::vector<std::string> differing;
        for (const auto &[name, figure] : geometry)
          for (const auto &[other_name, other] : known)
            if (name == other_name)
              differing.push_back(describe_difference(name, figure, other));
        for (const auto &[path, entry] : read_kept_entries(one.folder))
          if (const auto other = known_entries.find(path);
              other != known_entries.end() && makes_another_pair(path))
            differing.push_back(describe_entries(path, entry, other->second));
        differing.erase(std::remove(differing.begin(), differing.end(), ""), differing.end());
        if (differing.empty())
          continue;
        const std::size_t more = std::max(differing.size(), most) - most;
        differing.resize(differing.size() - more);
        sentences.push_back(one.name + " is another pair than " + first->name + ": " +
                            list_of(differing) +
                            (more > 0 ? " and " + std::to_string(more) + " more" : ""));
      }
    return sentences;
  }

  const ComparedCase *
  find_case(const ComparedCases &cases, const std::string &kind, const std::string &file)
  {
    for (const ComparedCase &one : cases)
      // The first of its kind that has got so far.
      if (one.kind == kind && one.has(file))
        return &one;
    return nullptr;
  }
} // namespace vfife
