// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_former_result_names_h
#define vfife_base_text_former_result_names_h

#include <string>
#include <vector>

namespace vfife
{
  /** A column, a member of a .json file or a word in a cell, by the name of the previous version.
   * "*" at the begin or at the end stands for anything else: the name of a probe, a number. */
  struct FormerResultName
  {
    std::string file, former, present;
  };

  /** All of them: source/report/vfife_report/data/former_names.json, which the Python package
   * reads.
   */
  const std::vector<FormerResultName> &list_former_result_names();

  /** The present name of @p name in results of the file ("history.csv"), which is mostly the same.
   */
  std::string present_result_name(const std::string &file, const std::string &name);

  /** The former name of the present @p name in whatever file; empty where it has none. */
  std::string former_result_name(const std::string &name);
} // namespace vfife

#endif
