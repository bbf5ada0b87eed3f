// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_declared_section_h
#define vfife_base_parameters_declared_section_h

#include <vfife/base/parameter_handler.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  /** A name and a tree below it: what a ParameterHandler has been told to expect, in the order of
   * declaration. */
  struct DeclaredSection
  {
    /** A declared entry and its present text. */
    struct Entry
    {
      std::string name;
      std::string value;
      std::string default_value;
      std::string description;
      std::string pattern; ///< words for what is allowed

      /** The unit that ends the description, "meaning [unit]"; empty where it states none. */
      std::string unit() const;
    };

    std::string                  name;
    std::vector<Entry>           entries;
    std::vector<DeclaredSection> sections;

    const Entry *find_entry(const std::string &entry) const;

    const DeclaredSection *find_section(const std::string &section) const;

    std::vector<std::string> entry_names() const;

    std::vector<std::string> section_names() const;

    /** Path ("A/B/name") and @p text, as &Entry::value, of all entries at or below this section;
     * @p path leads here. */
    std::vector<std::pair<std::string, std::string>> list_texts(std::string Entry::*text,
                                                                const std::string &path = "") const;

    /** "A/B/name = value unit" of all entries at or below this section that have another text than
     * in @p other, where the same is declared. */
    std::vector<std::string> list_differences(const DeclaredSection &other) const;

    /** Paths ("A/B") of all sections at or below this one, the top level, that have an entry of
     * that name; a message names the section where it is the only one. */
    std::vector<std::string> sections_with_entry(const std::string &entry) const;

    /** Paths ("A/B/name") of all sections of that name below this one, the top level. */
    std::vector<std::string> paths_of_section(const std::string &section) const;

  private:
    /** Paths of the sections that are meant, at or below this one, to which @p path leads. */
    std::vector<std::string>
    list_paths(const std::function<bool(const DeclaredSection &)> &is_meant,
               const std::string                                  &path) const;
  };

  /** Everything declared in @p prm, from its top level on. */
  DeclaredSection find_declared(const dealii::ParameterHandler &prm);
} // namespace vfife

#endif
