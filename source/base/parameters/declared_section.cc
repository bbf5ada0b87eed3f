// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/declared_section.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <sstream>

namespace vfife
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    /** An entry has a value (or is another name for one, "alias") that is a text and no tree. */
    bool is_entry(const Tree &node)
    {
      for (const char *text : {"value", "alias"})
        if (const auto found = node.find(text); found != node.not_found() && found->second.empty())
          return true;
      return false;
    }

    /** A name of which deal.II has written each character that is no letter or digit as _ and two
     * hexadecimal digits. */
    std::string read_name(const std::string &written)
    {
      std::string name;
      for (std::size_t i = 0; i < written.size(); ++i)
        if (written[i] == '_' && i + 2 < written.size())
          {
            name += static_cast<char>(std::stoi(written.substr(i + 1, 2), nullptr, 16));
            i += 2;
          }
        else
          name += written[i];
      return name;
    }

    /** The tree of one section; @p node holds entries and inner sections side by side: an entry has
     * a value, a section none. */
    DeclaredSection read_section(const std::string &name, const Tree &node)
    {
      DeclaredSection section;
      section.name = name;
      for (const auto &[written, child] : node)
        if (is_entry(child))
          section.entries.push_back({read_name(written),
                                     child.get<std::string>("value", ""),
                                     child.get<std::string>("default_value", ""),
                                     child.get<std::string>("documentation", ""),
                                     child.get<std::string>("pattern_description", "")});
        else
          section.sections.push_back(read_section(read_name(written), child));
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
    // ParameterHandler lists its declarations in no other way than by printing them; as XML, since
    // it prints JSON from several copies of its tree, which takes three times as long.
    std::stringstream text;
    prm.print_parameters(text,
                         dealii::ParameterHandler::XML |
                           dealii::ParameterHandler::KeepDeclarationOrder);
    Tree tree;
    boost::property_tree::read_xml(text, tree);
    return read_section("", tree.get_child("ParameterHandler"));
  }
} // namespace vfife
