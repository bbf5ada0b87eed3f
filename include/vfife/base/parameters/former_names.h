// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_former_names_h
#define vfife_base_parameters_former_names_h

#include <vfife/base/parameters/parameter_statement.h>

#include <string>
#include <vector>

namespace vfife
{
  /**
   * Replaces names of entries and words of values that the previous version had by those of today.
   * Returns for each replaced statement its place with both names, "file.prm:12: X is now Y".
   * @throws InputError where one file sets an entry by both names.
   */
  std::vector<std::string> replace_former_names(std::vector<ParameterStatement> &statements);

  /** Advice for an entry of earlier versions that has no successor, "remove it: ..."; empty for
   * other names. */
  std::string find_instead_of(const std::string &name);
} // namespace vfife

#endif
