// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_probe_columns_h
#define vfife_study_compare_probe_columns_h

#include <vfife/base/text/table.h>

#include <string>
#include <vector>

namespace vfife
{
  /** Names of the columns of one probe in the history of a general model. */
  struct ProbeColumns
  {
    std::string              name;
    std::vector<std::string> displacements; ///< three
    std::vector<std::string> stresses;      ///< six
    std::string              von_mises;
  };

  /** In the order of the history. */
  std::vector<ProbeColumns> find_probe_columns(const Table &history);
} // namespace vfife

#endif
