// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/file_names.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_reader.h>
#include <vfife/study/compare/compared_case.h>

namespace vfife
{
  bool ComparedCase::has(const std::string &file) const
  {
    return is_there(folder + "/" + file);
  }

  Table ComparedCase::table(const std::string &file) const
  {
    return read_result_table(folder + "/" + file);
  }

  double ComparedCase::number(const std::string &file, const std::string &pointer) const
  {
    return read_figure(folder + "/" + file, pointer);
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
