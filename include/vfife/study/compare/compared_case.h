// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_compared_case_h
#define vfife_study_compare_compared_case_h

#include <vfife/base/text/table.h>

#include <string>
#include <vector>

namespace vfife
{
  /** A case that has been run, and its results. */
  struct ComparedCase
  {
    std::string name, folder;
    std::string kind;            ///< word of Study/kind
    bool        is_pair = false; ///< of a gear pair, not a general model

    /** Whether anything of its results has been read. */
    mutable bool is_read = false;
    /** Why what has been read makes no row, a sentence; empty where it does. */
    mutable std::string lack = "";

    bool has(const std::string &file) const;
    /** A .csv file; throws InputError where it cannot be read. */
    Table table(const std::string &file) const;
    /** A number of a JSON file at a JSON pointer; NaN where there is none. */
    double number(const std::string &file, const std::string &pointer) const;
  };

  using ComparedCases = std::vector<ComparedCase>;

  /** A sentence for each case whose geometry, errors, chamfers or temperatures are not those of the
   * first case that states a geometry. */
  std::vector<std::string> list_other_pairs(const ComparedCases &cases);

  /** The first case of a kind that has a file, or nullptr. */
  const ComparedCase *
  find_case(const ComparedCases &cases, const std::string &kind, const std::string &file);
} // namespace vfife

#endif
