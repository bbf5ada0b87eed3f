// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/former_result_names.h>
#include <vfife/former_result_names_text.h>

#include <nlohmann/json.hpp>

#include <optional>

namespace vfife
{
  namespace
  {
    /** The name with @p from replaced by @p to; nothing where it is another name. */
    std::optional<std::string>
    replace(const std::string &name, const std::string &from, const std::string &to)
    {
      const std::size_t star = from.find('*');
      if (star == std::string::npos)
        return name == from ? std::optional<std::string>(to) : std::nullopt;
      // What stands for the star is between its two sides, one of which is empty.
      const std::string before = from.substr(0, star), after = from.substr(star + 1);
      if (name.size() < before.size() + after.size() ||
          name.compare(0, before.size(), before) != 0 ||
          name.compare(name.size() - after.size(), after.size(), after) != 0)
        return std::nullopt;
      std::string replaced = to;
      return replaced.replace(
        to.find('*'), 1, name.substr(before.size(), name.size() - before.size() - after.size()));
    }
  } // namespace

  const std::vector<FormerResultName> &list_former_result_names()
  {
    static const std::vector<FormerResultName> names = [] {
      std::vector<FormerResultName> all;
      for (const nlohmann::json &one : nlohmann::json::parse(former_result_names_text))
        all.push_back({one[0], one[1], one[2]});
      return all;
    }();
    return names;
  }

  std::string present_result_name(const std::string &file, const std::string &name)
  {
    for (const FormerResultName &one : list_former_result_names())
      if (one.file == file)
        if (const auto present = replace(name, one.former, one.present))
          return *present;
    return name;
  }

  std::string former_result_name(const std::string &name)
  {
    for (const FormerResultName &one : list_former_result_names())
      if (const auto former = replace(name, one.present, one.former))
        return *former;
    return "";
  }
} // namespace vfife
