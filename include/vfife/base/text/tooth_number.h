// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_tooth_number_h
#define vfife_base_text_tooth_number_h

#include <string>

namespace vfife
{
  /** The number of one of so many @p teeth, counted from 0. Throws InputError for another text. */
  unsigned int read_tooth_number(const std::string &text, unsigned int teeth);
} // namespace vfife

#endif
