// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_nearest_name_h
#define vfife_base_text_nearest_name_h

#include <string>
#include <vector>

namespace vfife
{
  /**
   * Number of single-letter insertions, deletions, replacements and swaps of neighbours that turn
   * one word into the other, upper and lower case being the same (optimal string alignment
   * distance).
   */
  unsigned int edit_distance(const std::string &first, const std::string &second);

  /**
   * The candidate most like @p word, or an empty string if none is alike: at most a third of its
   * letters may differ (one letter in short words); failing that, a candidate that contains the
   * word or is contained in it.
   */
  std::string nearest_name(const std::string &word, const std::vector<std::string> &candidates);

  /** The end of a message: "; did you mean "X"?", or nothing if no candidate is alike. */
  std::string did_you_mean(const std::string &word, const std::vector<std::string> &candidates);

  /** "a, b, c". With @p quoted each name stands in quotation marks. */
  std::string list_of(const std::vector<std::string> &names, bool quoted = false);
} // namespace vfife

#endif
