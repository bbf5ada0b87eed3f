// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_parameter_statement_h
#define vfife_base_parameters_parameter_statement_h

#include <string>
#include <vector>

namespace vfife
{
  /** One "set" or "subsection" of a parameter file, or one "--set" of the command line. */
  struct ParameterStatement
  {
    std::vector<std::string> sections; ///< the sections it stands in, outermost first
    std::string              name;     ///< of the entry or of the section that it opens
    std::string              value;    ///< text of the entry
    bool                     opens_section = false;
    std::string              place;  ///< "file.prm:12" or "--set "Section/name=value""
    std::string              folder; ///< of that file: what names of files are relative to
    bool                     from_command_line = false;

    /** "Section/Sub": the sections it stands in. */
    std::string section_path() const;

    /** The outermost section it stands in or opens; empty at the top level. */
    std::string top_section() const;

    /** "Section/Sub/name" */
    std::string path() const;
  };

  /**
   * The statements of a file in deal.II's parameter syntax: `subsection NAME`, `end`,
   * `set NAME = VALUE`, `include FILE` (relative to the including file; its statements stand in the
   * section of the include), `#` begins a comment, `\` at the end continues the line. A place is
   * that of the first line of a statement.
   * @throws InputError with file and line: unreadable file, missing '=', unknown word, sections
   * that are not closed or closed once too often, an entry set twice in one file (deal.II would
   * silently take the last).
   */
  std::vector<ParameterStatement> read_statements(const std::string &file_name);

  /** Those of a text in memory, which stands for a file of the name @p file_name: places name it,
   * and names of files are relative to its folder. */
  std::vector<ParameterStatement> read_statements_of_text(const std::string &text,
                                                          const std::string &file_name);

  /**
   * The statement of a text "Section/Sub/name=value".
   * @throws InputError naming the option if '=' or the name is missing.
   */
  ParameterStatement read_override(const std::string &text);
} // namespace vfife

#endif
