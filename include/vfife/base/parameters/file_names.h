// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_file_names_h
#define vfife_base_parameters_file_names_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/parameters/declared_section.h>

#include <functional>
#include <string>

namespace vfife
{
  /**
   * Declares the name of a file that is read. A relative name means a file beside the parameter
   * file that the entry stands in (of the command line: beside the parameter file it is given
   * with) or, where there is none, in the working folder: @p value is the name to open it by.
   */
  void declare_file_name(dealii::ParameterHandler &prm,
                         const std::string        &name,
                         std::string              &value,
                         const std::string        &meaning);

  /** Whether the text of an entry that may be a formula is the name of a table: it ends in ".csv"
   * or ".txt", as no formula does. */
  bool names_a_table(const std::string &text);

  /** Declares a formula or the name of a table (names_a_table()), for which all that
   * declare_file_name() says holds. */
  void declare_formula_or_table(dealii::ParameterHandler &prm,
                                const std::string        &name,
                                std::string              &value,
                                const std::string        &meaning);

  /** Declares an entry whose text is a quantity, a formula or the name of a table: @p check throws
   * an InputError on a bad text, @p store is called with the default and whenever it is set. */
  void declare_quantity_or_table(dealii::ParameterHandler                       &prm,
                                 const std::string                              &name,
                                 const std::string                              &default_text,
                                 const std::function<void(const std::string &)> &check,
                                 const std::function<void(const std::string &)> &store,
                                 const std::string                              &meaning);

  /** Whether an entry of this @p pattern (DeclaredSection::Entry) with this text names a file. */
  bool names_a_file(const std::string &pattern, const std::string &text);

  /** The name to open the file @p name by that a parameter file in @p folder names: see
   * declare_file_name(). */
  std::string find_beside(const std::string &folder, const std::string &name);

  /** Whether there is a file or folder. One with a name that no file can have, as it is too long,
   * is not there. */
  bool is_there(const std::string &path);

  /** Throws InputError (InputErrors of several) for each entry in force in @p prm that names a file
   * which is not there. */
  void check_files(const dealii::ParameterHandler &prm);

  /** As long as it lives all names of files in force in a handler are absolute, so that its text
   * means the same files from any folder; then they are again what the user wrote, as messages
   * show them. */
  class AbsoluteFileNames
  {
  public:
    explicit AbsoluteFileNames(dealii::ParameterHandler &prm);
    ~AbsoluteFileNames();
    AbsoluteFileNames(const AbsoluteFileNames &)            = delete;
    AbsoluteFileNames &operator=(const AbsoluteFileNames &) = delete;

  private:
    dealii::ParameterHandler &prm_;
    DeclaredSection           before_;
  };
} // namespace vfife

#endif
