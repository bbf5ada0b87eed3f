// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/number_text.h>

#include <charconv>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** "1.5D-3" of Fortran as "1.5e-3". */
    std::string with_usual_exponent(std::string number)
    {
      const std::size_t letter = number.find_first_not_of("+-.0123456789");
      if (letter == 0 || letter >= number.size() ||
          (number[letter] != 'd' && number[letter] != 'D'))
        return number;
      const bool        has_sign = number.find_first_of("+-", letter) == letter + 1;
      const std::size_t digit    = letter + (has_sign ? 2 : 1);
      if (digit < number.size() && number[digit] >= '0' && number[digit] <= '9')
        number[letter] = 'e';
      return number;
    }
  } // namespace

  std::string trimmed(const std::string &text)
  {
    const char *const blanks = " \t\r\n\v\f";
    const std::size_t begin  = text.find_first_not_of(blanks);
    if (begin == std::string::npos)
      return "";
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
  }

  std::string number_text(const double value)
  {
    // to_chars() writes the shortest text that reads back exactly, whatever the locale.
    char       text[32];
    const auto result = std::to_chars(text, text + sizeof(text), value);
    return std::string(text, result.ptr);
  }

  double read_number(const std::string &text, std::string &rest)
  {
    // Text behind the number, such as a unit, is left to the caller.
    const std::string number   = trimmed(text);
    const std::string readable = with_usual_exponent(number);
    const char       *begin    = readable.data();
    const char *const end      = begin + readable.size();

    // from_chars knows no plus sign
    if (number.size() > 1 && number[0] == '+' && number[1] != '-')
      ++begin;

    double     value  = 0.;
    const auto result = std::from_chars(begin, end, value);
    if (result.ec == std::errc::result_out_of_range)
      throw InputError("the number \"" + number +
                       "\" is too large or too small for double precision");
    if (result.ec != std::errc() || !std::isfinite(value))
      throw InputError(number.empty() ? "a number is missing"
                                      : "expected a number, got \"" + number + "\"");

    rest = trimmed(std::string(result.ptr, end));
    return value;
  }

  std::optional<double> plain_number(const std::string &text)
  {
    try
      {
        std::string  rest;
        const double number = read_number(text, rest);
        return rest.empty() ? std::optional<double>(number) : std::nullopt;
      }
    catch (const InputError &)
      {
        return std::nullopt;
      }
  }

  unsigned int read_tooth_number(const std::string &text, const unsigned int teeth)
  {
    std::string  rest;
    const double number = read_number(text, rest);
    if (!rest.empty() || number < 0. || number >= teeth || number != std::floor(number))
      throw InputError("expected a tooth from 0 to " + std::to_string(teeth - 1) + ", got " + text);
    return static_cast<unsigned int>(number);
  }
} // namespace vfife
