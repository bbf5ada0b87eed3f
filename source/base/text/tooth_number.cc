// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/tooth_number.h>

#include <cmath>

namespace vfife
{
  unsigned int read_tooth_number(const std::string &text, const unsigned int teeth)
  {
    std::string  rest;
    const double number = read_number(text, rest);
    if (!rest.empty() || number < 0. || number >= teeth || number != std::floor(number))
      throw InputError("expected a tooth from 0 to " + std::to_string(teeth - 1) + ", got " + text);
    return static_cast<unsigned int>(number);
  }
} // namespace vfife
