// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/table.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>

namespace vfife
{
  void write_csv(const OutputFolder &folder, const std::string &name, const Table &table)
  {
    if (folder.is_writer())
      folder.write_table(name, table);
  }

  void write_tables(const OutputFolder &folder, const std::string &name, const Table &table)
  {
    write_csv(folder, name + ".csv", table);
    // in memory it would say the same again
    if (folder.is_writer() && folder.is_on_disk())
      folder.write_file(name + ".json", [&table](std::ostream &out) { table.write_json(out); });
  }
} // namespace vfife
