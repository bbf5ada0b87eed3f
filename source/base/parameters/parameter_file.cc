// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/former_names.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/failure.h>
#include <vfife/base/text/nearest_name.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <filesystem>
#include <list>
#include <ostream>

// From text to values: read_statements() splits the file into statements with their places,
// find_declared() lists what a handler expects, each statement is looked up there and set by the
// handler. So a message can name file and line, what is allowed, and what was meant.
namespace vfife
{
  namespace
  {
    std::string quoted_section(const std::string &path)
    {
      return path.empty() ? "the top level" : "section \"" + path + "\"";
    }

    /** Throws for a section name that is not declared in @p parent, whose path is @p path. */
    [[noreturn]] void refuse_section(const std::string     &place,
                                     const std::string     &name,
                                     const DeclaredSection &parent,
                                     const std::string     &path,
                                     const DeclaredSection &top,
                                     const OtherSections   &others)
    {
      const std::vector<std::string> known   = parent.section_names();
      std::string                    message = place + ": \"" + name + "\" is not a section of " +
                            (path.empty() ? "the parameter file" : "\"" + path + "\"");
      message += known.empty() ? " (it has none)" : " (allowed: " + list_of(known) + ")";
      // Meant may be one that other kinds of study read, which may stand at the top level as well.
      std::vector<std::string> meant = known;
      if (path.empty())
        meant.insert(meant.end(), others.names.begin(), others.names.end());
      const std::vector<std::string> elsewhere = top.paths_of_section(name);
      if (parent.find_entry(name) != nullptr)
        message += "; it is an entry: set " + name + " = ...";
      else if (!elsewhere.empty())
        message += "; sections of that name: " + list_of(elsewhere);
      else
        message += did_you_mean(name, meant);
      throw InputError(message);
    }

    /** How many sections two paths begin with that are the same. */
    std::size_t count_common(const std::string &a, const std::string &b)
    {
      const std::string whole_a = a + "/", whole_b = b + "/";
      const auto        differ =
        std::mismatch(whole_a.begin(), whole_a.end(), whole_b.begin(), whole_b.end()).first;
      return std::count(whole_a.begin(), differ, '/');
    }

    /** Those of the sections that have most of the way to @p path in common with it. */
    std::vector<std::string> find_nearest(const std::vector<std::string> &sections,
                                          const std::string              &path)
    {
      std::size_t most = 0;
      for (const std::string &section : sections)
        most = std::max(most, count_common(section, path));
      std::vector<std::string> nearest;
      for (const std::string &section : sections)
        if (count_common(section, path) == most)
          nearest.push_back(section);
      return nearest;
    }

    /**
     * Throws for an entry that is not declared in @p section, with the most helpful hint there is.
     */
    [[noreturn]] void refuse_entry(const ParameterStatement &statement,
                                   const DeclaredSection    &section,
                                   const DeclaredSection    &top)
    {
      if (const std::string instead = find_instead_of(statement.name); !instead.empty())
        throw InputError(statement.place + ": \"" + statement.name +
                         "\" is an entry of earlier versions; " + instead);
      const std::vector<std::string> known = section.entry_names();
      const std::string              hint  = did_you_mean(statement.name, known);
      std::string message = statement.place + ": \"" + statement.name + "\" is not an entry of " +
                            quoted_section(statement.section_path()) + hint;
      // Beside a name spelt alike: a section of that name; without any hint so far the sections
      // elsewhere that have this entry, or else all entries of this section.
      const std::vector<std::string> others =
        find_nearest(top.sections_with_entry(statement.name), statement.section_path());
      constexpr std::size_t most_named = 4;
      if (section.find_section(statement.name) != nullptr)
        message += "; it is a section: subsection " + statement.name + " ... end";
      else if (hint.empty() && others.size() == 1)
        message += "; it belongs to " + quoted_section(others[0]);
      else if (hint.empty() && !others.empty() && others.size() <= most_named)
        message += "; it belongs to the sections " + list_of(others, true);
      else if (hint.empty())
        message +=
          known.empty() ? "; no entries are allowed there" : "; allowed: " + list_of(known);
      throw InputError(message);
    }

    /** Whether a statement sets or opens what has this path, or stands in it. */
    bool is_at(const ParameterStatement &statement, const std::string &path)
    {
      return (statement.path() + "/").compare(0, path.size() + 1, path + "/") == 0;
    }

    /** Path of the first section on the way to a statement that is not declared, of the entry if it
     * is the only one; empty where all is declared. */
    std::string undeclared_part(const ParameterStatement &statement, const DeclaredSection &top)
    {
      std::vector<std::string> sections = statement.sections;
      if (statement.opens_section)
        sections.push_back(statement.name);
      const DeclaredSection *section = &top;
      std::string            path;
      for (const std::string &name : sections)
        {
          path += (path.empty() ? "" : "/") + name;
          section = section->find_section(name);
          if (section == nullptr)
            return path;
        }
      return statement.opens_section || section->find_entry(statement.name) != nullptr
               ? ""
               : statement.path();
    }

    /** The section that a statement stands in, or nullptr; with @p strict an error instead of
     * nullptr. */
    const DeclaredSection *find_section_of(const ParameterStatement &statement,
                                           const DeclaredSection    &top,
                                           const bool                strict,
                                           const OtherSections      &others = {})
    {
      const DeclaredSection *section = &top;
      std::string            path;
      for (const std::string &name : statement.sections)
        {
          const DeclaredSection *const inner = section->find_section(name);
          if (inner == nullptr && strict)
            refuse_section(statement.place, name, *section, path, top, others);
          if (inner == nullptr)
            return nullptr;
          section = inner;
          path += (path.empty() ? "" : "/") + name;
        }
      return section;
    }
  } // namespace

  ParameterFile::ParameterFile(const std::string &path, const std::vector<std::string> &overrides)
    : ParameterFile(path, read_statements(path), overrides)
  {
  }

  ParameterFile ParameterFile::of_text(const std::string              &text,
                                       const std::string              &path,
                                       const std::vector<std::string> &overrides)
  {
    return ParameterFile(path, read_statements_of_text(text, path), overrides);
  }

  ParameterFile::ParameterFile(const std::string              &path,
                               std::vector<ParameterStatement> statements,
                               const std::vector<std::string> &overrides)
    : path_(path)
    , overrides_(overrides)
    , statements_(std::move(statements))
  {
    // Behind those of the file, so that they win.
    for (const std::string &text : overrides)
      {
        statements_.push_back(read_override(text));
        statements_.back().folder = std::filesystem::path(path).parent_path().string();
      }
    former_names_ = replace_former_names(statements_);
  }

  // Both readers match statements with what is declared instead of handing the text to deal.II:
  // only so each keeps its place, and what is not declared yet can wait for a later pass.
  void ParameterFile::read_known(dealii::ParameterHandler &prm) const
  {
    const DeclaredSection top = find_declared(prm);
    for (const ParameterStatement &statement : statements_)
      {
        // What this handler does not declare may belong to a later pass: it is no mistake yet.
        const DeclaredSection *const        section = find_section_of(statement, top, false);
        const DeclaredSection::Entry *const entry   = section == nullptr || statement.opens_section
                                                        ? nullptr
                                                        : section->find_entry(statement.name);
        if (entry != nullptr)
          apply(statement, *entry, prm);
      }
  }

  void
  ParameterFile::read_known(const std::function<void(dealii::ParameterHandler &)> &declare) const
  {
    dealii::ParameterHandler prm;
    declare(prm);
    read_known(prm);
  }

  void ParameterFile::read(dealii::ParameterHandler &prm, const OtherSections &others) const
  {
    const DeclaredSection top = find_declared(prm);
    for (const ParameterStatement &statement : statements_)
      if (std::none_of(others.passed_over.begin(),
                       others.passed_over.end(),
                       [&statement](const std::string &path) { return is_at(statement, path); }))
        set_declared(statement, top, others, prm);
  }

  void ParameterFile::read_section(const std::string &section, dealii::ParameterHandler &prm) const
  {
    const DeclaredSection top = find_declared(prm);
    for (const ParameterStatement &statement : statements_)
      if (statement.top_section() == section)
        set_declared(statement, top, {}, prm);
  }

  std::vector<std::string> ParameterFile::find_undeclared(const dealii::ParameterHandler &prm) const
  {
    const DeclaredSection    top = find_declared(prm);
    std::vector<std::string> paths;
    for (const ParameterStatement &statement : statements_)
      if (const std::string path = undeclared_part(statement, top);
          !path.empty() && std::find(paths.begin(), paths.end(), path) == paths.end())
        paths.push_back(path);
    return paths;
  }

  void ParameterFile::set_declared(const ParameterStatement &statement,
                                   const DeclaredSection    &top,
                                   const OtherSections      &others,
                                   dealii::ParameterHandler &prm) const
  {
    const DeclaredSection &section = *find_section_of(statement, top, true, others);
    if (statement.opens_section)
      {
        // The last pass knows all there is: what is not declared now is misspelt or out of place.
        if (section.find_section(statement.name) == nullptr)
          refuse_section(
            statement.place, statement.name, section, statement.section_path(), top, others);
      }
    else if (const auto *const entry = section.find_entry(statement.name))
      apply(statement, *entry, prm);
    else
      refuse_entry(statement, section, top);
  }

  void ParameterFile::apply(const ParameterStatement     &statement,
                            const DeclaredSection::Entry &entry,
                            dealii::ParameterHandler     &prm) const
  {
    // A list, since a Subsection can be neither copied nor moved.
    std::list<Subsection> sections;
    for (const std::string &name : statement.sections)
      sections.emplace_back(prm, name);

    // the option of the command line shows name and value itself
    const std::string place =
      statement.from_command_line
        ? statement.place + ": "
        : statement.place + ": " + statement.name + " = " + statement.value + ": ";
    try
      {
        const std::string text = names_a_file(entry.pattern, statement.value)
                                   ? find_beside(statement.folder, statement.value)
                                   : statement.value;
        prm.set(statement.name, text); // refuses what is not valid
        if (const std::string word = text_in_force(entry.pattern, text); word != text)
          prm.set(statement.name, word);
      }
    catch (const InputError &error)
      {
        throw InputError(place + error.what());
      }
    catch (const dealii::ExceptionBase &exception)
      {
        throw InputError(place + short_message(exception));
      }
  }

  std::vector<std::string>
  ParameterFile::list_zeros_for_words(const dealii::ParameterHandler &prm) const
  {
    const DeclaredSection    top = find_declared(prm);
    std::vector<std::string> zeros;
    for (const ParameterStatement &statement : statements_)
      if (const DeclaredSection *const section = find_section_of(statement, top, false);
          section != nullptr && !statement.opens_section)
        if (const auto *const entry = section->find_entry(statement.name))
          if (const std::string text = text_in_force(entry->pattern, statement.value);
              text != statement.value)
            zeros.push_back(statement.place + ": " + statement.name + " = " + statement.value +
                            " is read as \"" + text + "\"");
    return zeros;
  }

  const ParameterStatement *ParameterFile::find(const std::string &entry_path) const
  {
    // later statements win, and the command line comes last; of a section the first place is of
    // interest
    const ParameterStatement *found = nullptr;
    for (const ParameterStatement &statement : statements_)
      if (statement.path() == entry_path && !(statement.opens_section && found != nullptr))
        found = &statement;
    return found;
  }

  bool ParameterFile::contains(const std::string &entry_or_section) const
  {
    const std::string inside = entry_or_section + "/";
    for (const ParameterStatement &statement : statements_)
      if (statement.path() == entry_or_section ||
          statement.path().compare(0, inside.size(), inside) == 0)
        return true;
    return false;
  }

  std::string ParameterFile::locate(const std::string &entry_path) const
  {
    const ParameterStatement *const statement = find(entry_path);
    return statement == nullptr ? "" : statement->place;
  }

  std::string ParameterFile::explain(const InputError &error) const
  {
    // Several at once, each with its own place: a user mends them in one go.
    if (const auto *const several = dynamic_cast<const InputErrors *>(&error))
      {
        std::string text =
          std::to_string(several->errors().size()) + " conflicts in the input; the program stops";
        for (const InputError &one : several->errors())
          text += "\n  " + explain(one);
        return text;
      }
    if (error.entry().empty())
      return error.what();

    // The entry as code names it, by its whole path or the end of it.
    const ParameterStatement *found = find(error.entry());
    // By the end of the path: code that reads one section does not
    // know where in the file it stands.
    if (found == nullptr)
      {
        const std::string end = "/" + error.entry();
        std::string       path;
        bool              unambiguous = true;
        for (const ParameterStatement &statement : statements_)
          {
            const std::string candidate = statement.path();
            if (candidate.size() > end.size() &&
                candidate.compare(candidate.size() - end.size(), end.size(), end) == 0)
              {
                unambiguous = unambiguous && (path.empty() || path == candidate);
                path        = candidate;
              }
          }
        if (unambiguous && !path.empty())
          found = find(path);
      }
    if (found == nullptr)
      return path_ + " (" + error.entry() + ", not set there): " + error.what();
    return found->place + " (" + found->path() + "): " + error.what();
  }

  void print_parameters(std::ostream &out, const dealii::ParameterHandler &prm)
  {
    prm.print_parameters(out,
                         dealii::ParameterHandler::PRM |
                           dealii::ParameterHandler::KeepDeclarationOrder);
  }
} // namespace vfife
