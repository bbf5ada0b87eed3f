// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_shown_text_h
#define vfife_base_text_shown_text_h

#include <cstddef>
#include <string>

namespace vfife
{
  /** What may stand in a message of a piece of a broken file: at most @p longest bytes, control
   * characters and bytes that are no UTF-8 as question marks. */
  std::string shown(const std::string &text, std::size_t longest = 60);

  /** Why @p text cannot be a line of a file in UTF-8: control characters, bytes that begin no
   * character. Empty where it can. Columns are counted in bytes from 1. */
  std::string find_bad_bytes(const std::string &text);
} // namespace vfife

#endif
