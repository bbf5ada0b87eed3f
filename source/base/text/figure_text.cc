// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/figure_text.h>

#include <cmath>
#include <locale>
#include <sstream>

namespace vfife
{
  std::string figure_text(const double value)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    const double size = std::abs(value);
    // From 1000 on three digits alone would be written with an exponent.
    if (size >= 999.5 && size < 1e7)
      text << std::fixed, text.precision(0);
    else
      text.precision(3);
    text << value;
    return text.str();
  }
} // namespace vfife
