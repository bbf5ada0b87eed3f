// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_number_text_h
#define vfife_base_text_number_text_h

#include <optional>
#include <string>

namespace vfife
{
  /** @p text without blanks, tabs and carriage returns at both ends. */
  std::string trimmed(const std::string &text);

  /**
   * The shortest decimal text that reads back as exactly the same double ("0.1", "7.85e-09", "nan",
   * "inf"). The decimal sign is a point whatever the locale.
   */
  std::string number_text(double value);

  /**
   * Reads the finite number at the beginning of @p text ("5", "-1.5e-3", "+2", "1.5D-3"), and puts
   * what
   * follows, without blanks around it, into @p rest. Independent of the locale.
   * @throws InputError if there is no number, or one that is too large.
   */
  double read_number(const std::string &text, std::string &rest);

  /** The finite number that @p text is, with blanks around it and nothing else; nothing where it is
   * none. */
  std::optional<double> plain_number(const std::string &text);

  /** The number of one of so many @p teeth, counted from 0. Throws InputError for another text. */
  unsigned int read_tooth_number(const std::string &text, unsigned int teeth);
} // namespace vfife

#endif
