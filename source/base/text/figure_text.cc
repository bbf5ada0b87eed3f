// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/figure_text.h>

#include <cmath>
#include <locale>

namespace vfife
{
  namespace
  {
    /** Numbers that have more digits before the point than are asked for are written to the unit
     * instead of with an exponent. */
    class FigureNumbers : public std::num_put<char>
    {
    protected:
      iter_type do_put(iter_type      out,
                       std::ios_base &format,
                       const char     fill,
                       const double   value) const override
      {
        const double          size   = std::abs(value);
        const std::streamsize digits = format.precision();
        const auto            kind   = format.flags();
        const bool is_general = (kind & std::ios_base::floatfield) == std::ios_base::fmtflags();
        if (!is_general || size < std::pow(10., digits) - .5 || !(size < 1e7))
          return std::num_put<char>::do_put(out, format, fill, value);
        format.setf(std::ios_base::fixed, std::ios_base::floatfield);
        format.precision(0);
        out = std::num_put<char>::do_put(out, format, fill, value);
        format.flags(kind);
        format.precision(digits);
        return out;
      }
    };
  } // namespace

  std::string figure_text(const double value)
  {
    std::ostringstream text;
    set_figure_digits(text, 3);
    text << value;
    return text.str();
  }

  void set_figure_digits(std::ostream &text, const int digits)
  {
    text.imbue(std::locale(std::locale::classic(), new FigureNumbers));
    text.precision(digits);
  }
} // namespace vfife
