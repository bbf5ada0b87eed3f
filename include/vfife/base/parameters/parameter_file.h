// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_parameter_file_h
#define vfife_base_parameters_parameter_file_h

#include <vfife/base/errors.h>
#include <vfife/base/parameter_handler.h>
#include <vfife/base/parameters/declared_section.h>
#include <vfife/base/parameters/parameter_statement.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace vfife
{
  /** Sections and entries of a file that its reader has no use for, but others have. */
  struct OtherSections
  {
    std::vector<std::string> passed_over; ///< paths of those in the file; others have read them
    std::vector<std::string> names; ///< of all sections that others know, for hints in messages
  };

  /**
   * A parameter file with the settings of the command line, which win over it. It can be read
   * several times, into handlers that declare more each time: first the names of bodies, loads and
   * so on, then their subsections. Every InputError thrown has the one full message for the user as
   * its what(): place, entry, reason.
   */
  class ParameterFile
  {
  public:
    /**
     * Reads the file @p path and the settings @p overrides ("Section/Sub/name=value").
     * @throws InputError for wrong syntax, see read_statements().
     */
    explicit ParameterFile(const std::string &path, const std::vector<std::string> &overrides = {});

    /** The same of a text in memory, which stands for a file @p path that need not be there:
     * messages name it, and names of files in it are relative to its folder. */
    static ParameterFile of_text(const std::string              &text,
                                 const std::string              &path,
                                 const std::vector<std::string> &overrides = {});

    /** Sets what @p prm (at its top level) declares; entries and sections that it does not declare
     * are ignored. */
    void read_known(dealii::ParameterHandler &prm) const;

    /** The same for what @p declare declares in a handler of its own: a first pass, for names and
     * words that decide what else is declared. */
    void read_known(const std::function<void(dealii::ParameterHandler &)> &declare) const;

    /** Sets all entries; one that @p prm (at its top level) does not declare is an error, unless
     * it is passed over or stands in a section that is. */
    void read(dealii::ParameterHandler &prm, const OtherSections &others = {}) const;

    /** Sets the entries of one section at the top level; one that is not declared is an error. */
    void read_section(const std::string &section, dealii::ParameterHandler &prm) const;

    /** Paths of the sections and entries that @p prm (at its top level) does not declare, each
     * once, in order; of a section the path alone, not what stands in it. */
    std::vector<std::string> find_undeclared(const dealii::ParameterHandler &prm) const;

    /** Whether an entry or a section ("Gear pair", "Gear pair/Gear/Blank") stands in the file or
     * the overrides. */
    bool contains(const std::string &entry_or_section) const;

    /** Where an entry in force or a section comes from: "file.prm:12", `--set "..."`, or "" if it
     * is set nowhere. */
    std::string locate(const std::string &entry_path) const;

    /**
     * The message with its place: "file.prm:31 (Gear pair/Gear/Blank/Face angle): ..." if
     * error.entry() is known; the message alone if it is empty. An entry may be given by the end of
     * its path if that is unambiguous.
     * InputErrors: one line for each.
     */
    std::string explain(const InputError &error) const;

    /** The name of the file as given. */
    const std::string &path() const
    {
      return path_;
    }
    /** Statements with names of the previous version: "file.prm:12: X is now Y". */
    const std::vector<std::string> &former_names() const
    {
      return former_names_;
    }
    /** Statements whose 0, of the previous version, is read as a word (text_in_force()):
     * "file.prm:12: X = 0 is read as \"auto\"". */
    std::vector<std::string> list_zeros_for_words(const dealii::ParameterHandler &prm) const;

    /** The settings of the command line as given. */
    const std::vector<std::string> &overrides() const
    {
      return overrides_;
    }

  private:
    ParameterFile(const std::string              &path,
                  std::vector<ParameterStatement> statements,
                  const std::vector<std::string> &overrides);

    void                      set_declared(const ParameterStatement &statement,
                                           const DeclaredSection    &top,
                                           const OtherSections      &others,
                                           dealii::ParameterHandler &prm) const;
    void                      apply(const ParameterStatement     &statement,
                                    const DeclaredSection::Entry &entry,
                                    dealii::ParameterHandler     &prm) const;
    const ParameterStatement *find(const std::string &entry_path) const;

    std::string                     path_;
    std::vector<std::string>        overrides_;
    std::vector<ParameterStatement> statements_;
    std::vector<std::string>        former_names_;
  };

  /**
   * Writes all parameters in force with their descriptions as a parameter file that can be read
   * back.
   */
  void print_parameters(std::ostream &out, const dealii::ParameterHandler &prm);
} // namespace vfife

#endif
