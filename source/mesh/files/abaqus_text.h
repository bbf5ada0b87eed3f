// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_files_abaqus_text_h
#define vfife_mesh_files_abaqus_text_h

#include <vfife/base/text/text_lines.h>

#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace vfife
{
  /** A keyword line: *KEYWORD, OPTION=VALUE, ... over as many lines as commas at their ends say. */
  struct AbaqusKeyword
  {
    std::string                        name;    ///< in capitals without blanks: "ENDPART"
    std::string                        shown;   ///< "*END PART", for messages
    std::map<std::string, std::string> options; ///< names in capitals; values as they are written
    unsigned int                       line = 0;

    bool has(const std::string &option) const;
    /** Empty where the option is not there. */
    std::string value(const std::string &option) const;
  };

  /** Capitals: names of the format are the same in any case of letters. */
  std::string abaqus_key(const std::string &name);

  /** Keywords of a file of Abaqus or CalculiX with their data lines; comments (**) are passed over.
   */
  class AbaqusText
  {
  public:
    explicit AbaqusText(const std::string &path);

    /** The next keyword; data lines that were not read are passed over. False at the end of the
     * file. */
    bool next_keyword(AbaqusKeyword &keyword);

    /** The cells of the next data line of the present keyword; false behind the last one. */
    bool next_row(std::vector<std::string> &cells);

    /** Whether the data line read last ends by a comma. */
    bool goes_on() const;

    /** Throws InputError "FILE:LINE: message". */
    [[noreturn]] void refuse(const std::string &message) const;
    [[noreturn]] void refuse(const std::string &message, unsigned int line) const;

    /** Refuses options of a keyword that are not in @p known. */
    void check_options(const AbaqusKeyword &keyword, const std::vector<std::string> &known) const;

    unsigned int line() const;
    /** Numbers of nodes and elements. */
    unsigned long label(const std::string &word) const;
    /** Zero where the word is empty, as the format says. */
    double number(const std::string &word) const;

  private:
    bool next_line();

    const std::string &path_;
    std::ifstream      file_;
    TextLines          lines_;
    std::string        text_;               ///< the present line
    bool               is_waiting_ = false; ///< it is a keyword that has not been handed out
    bool               goes_on_    = false;
    unsigned int       line_       = 0; ///< of the last line handed out
  };

  /**
   * Why a keyword that is none of a mesh (in capitals without blanks) cannot be left out: it
   * changes places, elements or what joins them, or it is not known. Empty where it can. @p inside:
   * of a material or a step, all of whose keywords can be but for those that are likely misspelt.
   */
  std::string find_abaqus_refusal(const std::string &keyword, bool inside);

  /** Whether a keyword that is left out ends a material. */
  bool is_abaqus_model_keyword(const std::string &keyword);

  /** Titles and requests of output, of which nobody needs to hear. */
  bool is_abaqus_output(const std::string &keyword);
} // namespace vfife

#endif
