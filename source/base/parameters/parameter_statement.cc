// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_statement.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/shown_text.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>

namespace vfife
{
  namespace
  {
    /** Reads one file, and the files it includes by readers of their own. */
    class StatementReader
    {
    public:
      StatementReader(const std::string              &file_name,
                      const std::vector<std::string> &sections,
                      const std::vector<std::string> &including_files)
        : file_name_(file_name)
        , sections_(sections)
        , open_files_(including_files)
      {
        open_files_.push_back(file_name);
      }

      /** @p included_from begins the message where the file cannot be read. */
      std::vector<ParameterStatement> read_file(const std::string &included_from);
      /** What the stream has stands for the file's content. */
      std::vector<ParameterStatement> read(std::istream &file);

    private:
      void        read_line(const std::string &line);
      void        read_set(const std::string &rest);
      void        read_include(const std::string &rest);
      void        open_section(const std::string &name);
      std::string place() const;

      std::string                     file_name_;
      std::vector<std::string>        sections_;   ///< open ones, those of including files first
      std::vector<std::string>        open_files_; ///< this file and those that include it
      std::vector<std::string>        section_places_; ///< where this file has opened sections
      std::map<std::string, unsigned> line_of_entry_;  ///< by path: what this file has set so far
      std::vector<ParameterStatement> statements_;
      unsigned int                    line_number_ = 0; ///< first line of the present statement
    };

    std::string StatementReader::place() const
    {
      return file_name_ + ":" + std::to_string(line_number_);
    }

    std::vector<ParameterStatement> StatementReader::read_file(const std::string &included_from)
    {
      const std::string prefix = included_from.empty() ? "" : included_from + ": ";
      std::error_code   none; // a name that no file can have, too long a one, is not there
      if (std::filesystem::is_directory(file_name_, none))
        throw InputError(prefix + "\"" + file_name_ + "\" is a folder, not a parameter file");
      std::ifstream file(file_name_);
      if (!file)
        throw InputError(prefix + "the parameter file \"" + file_name_ + "\" cannot be read" +
                         (std::filesystem::exists(file_name_, none) ? "" : ": it does not exist"));
      return read(file);
    }

    // Lines are joined to statements, statements are put to read_line().
    std::vector<ParameterStatement> StatementReader::read(std::istream &file)
    {
      std::string  line, statement;
      unsigned int n_lines   = 0;
      bool         continued = false;
      while (std::getline(file, line))
        {
          if (++n_lines == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0)
            line.erase(0, 3); // byte order mark of some editors
          line = trimmed(line);
          if (!continued)
            {
              line_number_ = n_lines;
              statement.clear();
            }
          // Values go into JSON, names of files and messages: only text can.
          const std::string bad = find_bad_bytes(line);
          if (!bad.empty())
            throw InputError(file_name_ + ":" + std::to_string(n_lines) + ": " + bad);
          // A statement over several lines has the number of its first one, and
          // ends with the file at the latest.
          continued = !line.empty() && line.back() == '\\';
          statement += continued ? line.substr(0, line.size() - 1) : line;
          if (!continued)
            read_line(statement);
        }
      if (continued)
        read_line(statement);

      if (!section_places_.empty())
        throw InputError(section_places_.back() + ": subsection \"" + sections_.back() +
                         "\" is not closed by \"end\"");
      return statements_;
    }

    void StatementReader::read_line(const std::string &full_line)
    {
      //   set NAME = VALUE      subsection NAME ... end      include FILE      # comment
      const std::string line = trimmed(full_line.substr(0, full_line.find('#')));
      if (line.empty())
        return;
      const std::size_t end_of_word = std::min(line.find_first_of(" \t="), line.size());
      const std::string rest        = trimmed(line.substr(end_of_word));
      std::string       word        = line.substr(0, end_of_word);
      std::transform(word.begin(), word.end(), word.begin(), [](const unsigned char c) {
        return std::tolower(c);
      });

      if (word == "set")
        read_set(rest);
      else if (word == "subsection")
        open_section(rest);
      else if (word == "include")
        read_include(rest);
      else if (word == "end" && !rest.empty())
        throw InputError(place() + ": expected nothing after \"end\", got \"" + rest + "\"");
      else if (word == "end")
        {
          if (section_places_.empty())
            throw InputError(place() + ": \"end\" has no open subsection to close");
          // A file closes what it has opened: sections of the including files stay open.
          sections_.pop_back();
          section_places_.pop_back();
        }
      else
        throw InputError(place() + ": expected set, subsection, end or include, got \"" + line +
                         "\"" + did_you_mean(word, {"set", "subsection", "end", "include"}));
    }

    // The statement says that the section exists and where: a section without entries can
    // be refused too.
    void StatementReader::open_section(const std::string &name)
    {
      if (name.empty())
        throw InputError(place() + ": the name of the subsection is missing");
      ParameterStatement statement;
      statement.sections      = sections_;
      statement.name          = name;
      statement.opens_section = true;
      statement.place         = place();
      statements_.push_back(statement);
      sections_.push_back(name);
      section_places_.push_back(place());
    }

    void StatementReader::read_set(const std::string &rest)
    {
      const std::size_t equal_sign = rest.find('=');
      if (equal_sign == std::string::npos)
        throw InputError(place() + ": '=' is missing in \"set " + rest + "\"");
      ParameterStatement statement;
      statement.sections = sections_;
      statement.name     = trimmed(rest.substr(0, equal_sign));
      statement.value    = trimmed(rest.substr(equal_sign + 1));
      statement.place    = place();
      statement.folder   = std::filesystem::path(file_name_).parent_path().string();
      if (statement.name.empty())
        throw InputError(place() + ": the name before '=' is missing in \"set " + rest + "\"");

      // Twice in one file is a slip; the command line and an including file may set it again.
      const auto [earlier, is_new] = line_of_entry_.insert({statement.path(), line_number_});
      if (!is_new)
        throw InputError(place() + ": \"" + statement.path() + "\" is already set in line " +
                         std::to_string(earlier->second));
      statements_.push_back(statement);
    }

    void StatementReader::read_include(const std::string &rest)
    {
      if (rest.empty())
        throw InputError(place() + ": the name of the file to include is missing");
      // operator / takes an absolute name as it is
      const std::string name =
        (std::filesystem::path(file_name_).parent_path() / rest).lexically_normal().string();
      for (const std::string &open : open_files_)
        if (std::filesystem::path(open).lexically_normal() == name)
          throw InputError(place() + ": the file \"" + name + "\" includes itself");

      // Its statements stand here, in the sections that are open here.
      StatementReader reader(name, sections_, open_files_);
      for (const ParameterStatement &statement : reader.read_file(place()))
        statements_.push_back(statement);
    }
  } // namespace

  std::string ParameterStatement::section_path() const
  {
    std::string path;
    for (const std::string &section : sections)
      path += (path.empty() ? "" : "/") + section;
    return path;
  }

  std::string ParameterStatement::top_section() const
  {
    if (!sections.empty())
      return sections.front();
    return opens_section ? name : "";
  }

  std::string ParameterStatement::path() const
  {
    return sections.empty() ? name : section_path() + "/" + name;
  }

  std::vector<ParameterStatement> read_statements(const std::string &file_name)
  {
    return StatementReader(file_name, {}, {}).read_file("");
  }

  std::vector<ParameterStatement> read_statements_of_text(const std::string &text,
                                                          const std::string &file_name)
  {
    std::istringstream lines(text);
    return StatementReader(file_name, {}, {}).read(lines);
  }

  ParameterStatement read_override(const std::string &text)
  {
    ParameterStatement statement;
    statement.place             = "--set \"" + shown(text, text.size()) + "\"";
    statement.from_command_line = true;
    const std::string bad       = find_bad_bytes(text);
    if (!bad.empty())
      throw InputError(statement.place + ": " + bad);

    // The first '=' ends the name: values may have more of them, names have none.
    const std::size_t equal_sign = text.find('=');
    if (equal_sign == std::string::npos)
      throw InputError(statement.place +
                       ": expected \"Section/Sub/name=value\", but '=' is missing");
    statement.value  = trimmed(text.substr(equal_sign + 1));
    std::string path = text.substr(0, equal_sign);
    for (std::size_t slash = path.find('/'); slash != std::string::npos; slash = path.find('/'))
      {
        statement.sections.push_back(trimmed(path.substr(0, slash)));
        path.erase(0, slash + 1);
      }
    statement.name = trimmed(path);
    if (statement.name.empty() ||
        std::find(statement.sections.begin(), statement.sections.end(), "") !=
          statement.sections.end())
      throw InputError(statement.place +
                       ": expected \"Section/Sub/name=value\", but a name is missing");
    return statement;
  }
} // namespace vfife
