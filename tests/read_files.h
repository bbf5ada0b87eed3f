// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_read_files_h
#define vfife_tests_read_files_h

#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>
#include <string>

inline std::string read_text(const std::string &path)
{
  std::ifstream      file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline nlohmann::json read_json(const std::string &path)
{
  std::ifstream file(path);
  return nlohmann::json::parse(file);
}

/** The number of the figure of that name. */
inline double value_of(const nlohmann::json &figures, const std::string &name)
{
  return figures.at(name).at("value").get<double>();
}

#endif
