// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/study/compare/probe_columns.h>

namespace vfife
{
  std::vector<ProbeColumns> find_probe_columns(const Table &history)
  {
    const std::string         displacement = std::string(" ") + column::displacement + " ";
    std::vector<ProbeColumns> probes;
    // The columns of a probe stand together: displacements open it, its stresses and von Mises
    // follow.
    for (const Table::Column &column : history.columns())
      {
        //   NAME displacement x, ... y, ... z, NAME stress x, ... , NAME von mises
        const std::size_t at = column.name.find(displacement);
        if (at != std::string::npos)
          {
            const std::string name = column.name.substr(0, at);
            if (probes.empty() || probes.back().name != name)
              probes.push_back({name, {}, {}, ""});
            probes.back().displacements.push_back(column.name);
          }
        else if (!probes.empty() &&
                 column.name.rfind(probes.back().name + " " + column::stress + " ", 0) == 0)
          probes.back().stresses.push_back(column.name);
        else if (!probes.empty() && column.name == probes.back().name + " " + column::von_mises)
          probes.back().von_mises = column.name;
      }
    return probes;
  }
} // namespace vfife
