// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_figure_text_h
#define vfife_base_text_figure_text_h

#include <sstream>
#include <string>

namespace vfife
{
  /**
   * @p value with three significant digits, as one reads a figure in a sentence: "54.2", "1829",
   * "0.000354"; exponents below 1e-4 and from 1e7 on only ("1.2e-05").
   */
  std::string figure_text(double value);

  /** From now on numbers written to @p text have so many significant digits, and exponents where
   * figure_text() has them. */
  void set_figure_digits(std::ostream &text, int digits);

  /** Texts and numbers as a sentence, these with so many significant @p digits. */
  template <typename... Parts>
  std::string sentence_of(const int digits, const Parts &...parts)
  {
    std::ostringstream text;
    set_figure_digits(text, digits);
    (text << ... << parts);
    return text.str();
  }
} // namespace vfife

#endif
