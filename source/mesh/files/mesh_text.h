// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_files_mesh_text_h
#define vfife_mesh_files_mesh_text_h

#include <vfife/base/text/text_lines.h>
#include <vfife/base/types.h>

#include <fstream>
#include <sstream>
#include <string>

namespace vfife
{
  /**
   * Words and numbers of a mesh file in turn. What is missing or is no number is refused by an
   * InputError that begins with file and line. Counts that a file states are never trusted with
   * memory: what they count is read one by one, and the file ends.
   */
  class MeshText
  {
  public:
    /** Lines that begin with the letter @p comment are passed over. */
    explicit MeshText(const std::string &path, char comment = '\0');

    /** The next word; empty at the end of the file. */
    std::string next();

    /** Makes @p word, which next() has given, the next one again. */
    void put_back(const std::string &word);

    /** The next word, which must be @p expected in any case of letters. */
    void expect(const std::string &expected);

    /** The next word as a finite number; @p what it is ("a coordinate") is for the message. */
    double number(const std::string &what);

    /** Three coordinates [mm]. */
    Vector3 point();

    /** The next word as a whole number, @p least or larger. */
    long integer(const std::string &what, long least = 0);

    /** What is left of the present line, or the next line where nothing is; empty at the end of
     * the file. */
    std::string rest_of_line();

    /** What is left of the present line, which may be nothing. */
    std::string rest_of_this_line();

    /** The next line, which may be empty; what is left of the present one is passed over. False at
     * the end of the file. */
    bool next_line(std::string &line);

    /** Throws InputError "FILE:LINE: message". */
    [[noreturn]] void refuse(const std::string &message) const;

    /** Of the word last read. */
    unsigned int line() const;

  private:
    /** The next word; refuses the end of the file. */
    std::string word(const std::string &what);

    std::string        path_;
    std::ifstream      file_;
    TextLines          lines_;
    std::istringstream words_;    ///< of the present line
    std::string        returned_; ///< by put_back()
    char               comment_;
  };
} // namespace vfife

#endif
