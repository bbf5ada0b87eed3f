// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/declared_section.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <sstream>

namespace vfife
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /** An entry has a value (or stands for another one, "alias") that is a text and no tree. */
    bool is_entry(const Json &node)
    {
      return node.is_object() && ((node.contains("value") && node["value"].is_string()) ||
                                  (node.contains("alias") && node["alias"].is_string()));
    }

    /** The tree of one section; @p node holds entries and inner sections side by side. */
    DeclaredSection read_section(const std::string &name, const Json &node)
    {
      DeclaredSection section;
      section.name = name;
      // a section without entries is written as an empty text
      if (!node.is_object())
        return section;
      // Entries and sections stand side by side in deal.II's tree: one has a value, the other none.
      for (const auto &[child_name, child] : node.items())
        if (is_entry(child))
          section.entries.push_back({child_name,
                                     child.value("value", ""),
                                     child.value("default_value", ""),
                                     child.value("documentation", ""),
                                     child.value("pattern_description", "")});
        else
          section.sections.push_back(read_section(child_name, child));
      return section;
    }

    template <typename Named>
    const Named *find_named(const std::vector<Named> &all, const std::string &name)
    {
      for (const Named &one : all)
        if (one.name == name)
          return &one;
      return nullptr;
    }

    template <typename Named>
    std::vector<std::string> names_of(const std::vector<Named> &all)
    {
      std::vector<std::string> names;
      for (const Named &one : all)
        names.push_back(one.name);
      return names;
    }
  } // namespace

  std::string DeclaredSection::Entry::unit() const
  {
    const std::size_t start = description.rfind('[');
    if (start == std::string::npos || description.back() != ']')
      return "";
    return description.substr(start + 1, description.size() - start - 2);
  }

  std::vector<std::string> DeclaredSection::list_differences(const DeclaredSection &other) const
  {
    std::vector<std::string> found;
    for (std::size_t i = 0; i < entries.size(); ++i)
      if (entries[i].value != other.entries[i].value)
        {
          const std::string unit = entries[i].unit();
          found.push_back(entries[i].name + " = " + entries[i].value +
                          (unit.empty() || unit == "-" ? "" : " " + unit));
        }
    for (std::size_t i = 0; i < sections.size(); ++i)
      for (const std::string &below : sections[i].list_differences(other.sections[i]))
        found.push_back(sections[i].name + "/" + below);
    return found;
  }

  const DeclaredSection::Entry *DeclaredSection::find_entry(const std::string &entry) const
  {
    return find_named(entries, entry);
  }

  const DeclaredSection *DeclaredSection::find_section(const std::string &section) const
  {
    return find_named(sections, section);
  }

  std::vector<std::string> DeclaredSection::entry_names() const
  {
    return names_of(entries);
  }

  std::vector<std::pair<std::string, std::string>>
  DeclaredSection::list_values(const std::string &path) const
  {
    return list_texts(&Entry::value, path);
  }

  std::vector<std::pair<std::string, std::string>>
  DeclaredSection::list_defaults(const std::string &path) const
  {
    return list_texts(&Entry::default_value, path);
  }

  std::vector<std::pair<std::string, std::string>>
  DeclaredSection::list_texts(std::string Entry::*const text, const std::string &path) const
  {
    // Depth first, the entries of a section before those of the sections inside it.
    const std::string                                inside = path.empty() ? "" : path + "/";
    std::vector<std::pair<std::string, std::string>> texts;
    for (const Entry &entry : entries)
      texts.emplace_back(inside + entry.name, entry.*text);
    for (const DeclaredSection &section : sections)
      for (auto &below : section.list_texts(text, inside + section.name))
        texts.push_back(std::move(below));
    return texts;
  }

  std::vector<std::string> DeclaredSection::section_names() const
  {
    return names_of(sections);
  }

  std::vector<std::string> DeclaredSection::sections_with_entry(const std::string &entry) const
  {
    return list_paths([&entry](const DeclaredSection &one) { return one.find_entry(entry); }, "");
  }

  std::vector<std::string> DeclaredSection::paths_of_section(const std::string &section) const
  {
    return list_paths([&section](const DeclaredSection &one) { return one.name == section; }, "");
  }

  std::vector<std::string>
  DeclaredSection::list_paths(const std::function<bool(const DeclaredSection &)> &is_meant,
                              const std::string                                  &path) const
  {
    std::vector<std::string> found;
    if (is_meant(*this))
      found.push_back(path);
    for (const DeclaredSection &section : sections)
      for (const std::string &below :
           section.list_paths(is_meant, path + (path.empty() ? "" : "/") + section.name))
        found.push_back(below);
    return found;
  }

  DeclaredSection find_declared(const dealii::ParameterHandler &prm)
  {
    // ParameterHandler lists its declarations in no other way than by printing them
    std::stringstream text;
    prm.print_parameters(text,
                         dealii::ParameterHandler::JSON |
                           dealii::ParameterHandler::KeepDeclarationOrder);
    return read_section("", Json::parse(text));
  }
} // namespace vfife
