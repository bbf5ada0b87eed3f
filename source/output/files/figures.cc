// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/output/files/figures.h>
#include <vfife/output/files/output_folder.h>

#include <nlohmann/json.hpp>

#include <ostream>

namespace vfife
{
  Json figure_json(const double value, const std::string &unit)
  {
    return Json{{"value", value}, {"unit", unit}};
  }

  Json figures_json(const NamedFigures &figures)
  {
    Json json = Json::object();
    for (const auto &entry : figures)
      json[entry.first] = figure_json(entry.second.value, entry.second.unit);
    return json;
  }

  std::string json_text(const Json &json)
  {
    // Names of files may hold bytes that are no UTF-8: they are replaced instead of thrown for.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }

  void write_json(const OutputFolder &folder, const std::string &name, const Json &json)
  {
    if (!folder.is_writer())
      return;
    // First all of the text: what cannot be written as JSON leaves no file behind.
    const std::string text = json_text(json);
    folder.write_file(name, [&text](std::ostream &out) { out << text; });
  }
} // namespace vfife
