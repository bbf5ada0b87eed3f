// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/expression.h>
#include <vfife/base/text/number_text.h>

#include <deal.II/base/function_parser.h>

#include <cctype>
#include <cfenv>
#include <cmath>
#include <iostream>
#include <sstream>
#include <vector>

namespace vfife
{
  namespace
  {
    bool is_in_word(const char letter)
    {
      return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
    }

    /** Whether a name, that of a function, ends in front of the bracket at @p bracket. */
    bool follows_name(const std::string &formula, const std::size_t bracket)
    {
      if (bracket == 0)
        return false;
      const std::size_t last = formula.find_last_not_of(' ', bracket - 1);
      if (last == std::string::npos || !is_in_word(formula[last]))
        return false;
      std::size_t first = last;
      while (first > 0 && is_in_word(formula[first - 1]))
        --first;
      return std::isdigit(static_cast<unsigned char>(formula[first])) == 0;
    }

    /** The comparison that begins at @p i: "<", "<=", ">", ">=", "==", "!="; else empty. */
    std::string comparison_at(const std::string &formula, const std::size_t i)
    {
      const char letter = formula[i], next = i + 1 < formula.size() ? formula[i + 1] : ' ';
      if (next == '=' && std::string("<>=!").find(letter) != std::string::npos)
        return formula.substr(i, 2);
      return letter == '<' || letter == '>' ? std::string(1, letter) : "";
    }

    /** Throws InputError for what muParser reads otherwise than it is written. */
    void check_punctuation(const std::string &formula)
    {
      struct Bracket
      {
        bool of_function, has_comparison;
      };
      std::vector<Bracket> open = {{false, false}};
      for (std::size_t i = 0; i < formula.size(); ++i)
        {
          const std::string comparison = comparison_at(formula, i);
          const char        letter     = formula[i];
          if (!comparison.empty())
            {
              if (open.back().has_comparison)
                throw InputError("\"" + comparison +
                                 "\" compares the result of a comparison; join two comparisons by "
                                 "&&, as in 0 < x && x < 5");
              open.back().has_comparison = true;
              i += comparison.size() - 1;
            }
          else if (letter == '=')
            throw InputError("\"=\" sets and does not compare; write == to compare");
          else if (letter == '(')
            open.push_back({follows_name(formula, i), false});
          else if (letter == ')' && open.size() > 1)
            open.pop_back();
          else if (letter == ',' && !open.back().of_function)
            throw InputError("a comma is allowed only between the arguments of a function; the "
                             "decimal sign is a point");
          else if (std::string("&|?:,").find(letter) != std::string::npos)
            open.back().has_comparison = false;
        }
    }

    /** Whether a comma stands between two digits. */
    bool has_comma_in_number(const std::string &formula)
    {
      const auto is_digit = [&formula](const std::size_t i) {
        return i < formula.size() && std::isdigit(static_cast<unsigned char>(formula[i])) != 0;
      };
      for (std::size_t i = 1; i < formula.size(); ++i)
        if (formula[i] == ',' && is_digit(i - 1) && is_digit(i + 1))
          return true;
      return false;
    }
  } // namespace

  struct Expression::Parser
  {
    dealii::FunctionParser<3> function{1};
    std::string               entry; ///< of the user's file
    /** Whether something in the formula leaves places out. */
    bool has_condition = false;
  };

  Expression::Expression(const std::string &formula, const std::string &entry)
    : formula_(formula)
    , parser_(std::make_shared<Parser>())
  {
    parser_->entry = entry;
    parser_->has_condition =
      formula.find_first_of("&|?") != std::string::npos || has_word(formula, "if");
    const auto refuse_formula = [&formula](const std::string &reason) {
      throw InputError("formula \"" + formula + "\" of x, y, z, t: " + reason);
    };
    try
      {
        check_punctuation(formula);
      }
    catch (const InputError &error)
      {
        refuse_formula(error.what());
      }

    // deal.II writes the parser's message to std::cerr before it throws; it belongs into ours.
    std::ostringstream    said;
    std::streambuf *const screen     = std::cerr.rdbuf(said.rdbuf());
    bool                  understood = true;
    try
      {
        parser_->function.initialize("x,y,z,t", formula, {{"pi", pi}}, true);
        // muParser understands a formula only when it is evaluated for the first time.
        evaluate(Vector3::Zero(), 0.);
      }
    catch (const dealii::ExceptionBase &)
      {
        understood = false;
      }
    // Given back at once, before anything else may throw: the screen must not stay silent.
    std::cerr.rdbuf(screen);
    if (understood)
      return;

    // What stands behind "Message:" in deal.II's text is the parser's own sentence.
    std::string       reason = "it cannot be understood";
    const std::string mark   = "Message:";
    const std::size_t begin  = said.str().find(mark);
    if (begin != std::string::npos)
      {
        reason = said.str().substr(begin + mark.size());
        reason = reason.substr(reason.find_first_not_of(' '));
        reason = reason.substr(0, reason.find('\n'));
      }
    refuse_formula(reason + (has_comma_in_number(formula) ? "; the decimal sign is a point" : ""));
  }

  Expression::~Expression()                             = default;
  Expression::Expression(const Expression &)            = default;
  Expression &Expression::operator=(const Expression &) = default;

  double Expression::evaluate(const Vector3 &x, const double t) const
  {
    // The fourth variable of the formula is deal.II's time, not a coordinate.
    parser_->function.set_time(t);
    return parser_->function.value(dealii::Point<3>(x[0], x[1], x[2]));
  }

  double Expression::checked_value(const Vector3 &x, const double t, const int no_value) const
  {
    // A comparison or a minimum hides that one of its operands has no value, the flags of the
    // processor do not. They do not know what a condition has left out: muParser evaluates both
    // sides of && and all arguments of if.
    std::feclearexcept(no_value);
    const double value = evaluate(x, t);
    if (!std::isfinite(value) || (!parser_->has_condition && std::fetestexcept(no_value) != 0))
      refuse(x, t);
    return value;
  }

  double Expression::operator()(const Vector3 &x, const double t) const
  {
    // A division by zero may have a limit, as in exp(-1/t).
    return checked_value(x, t, FE_INVALID);
  }

  bool Expression::holds(const Vector3 &x) const
  {
    // 1/x > 2 would depend on the sign of a coordinate that is zero.
    return checked_value(x, 0., FE_INVALID | FE_DIVBYZERO) != 0.;
  }

  void Expression::refuse(const Vector3 &x, const double t) const
  {
    std::string place;
    const auto  add = [&](const char *const name, const double value, const char *const unit) {
      if (has_word(formula_, name))
        place += (place.empty() ? " at " : ", ") + std::string(name) + " = " + number_text(value) +
                 " " + unit;
    };
    add("x", x[0], "mm");
    add("y", x[1], "mm");
    add("z", x[2], "mm");
    add("t", t, "s");
    throw InputError(parser_->entry,
                     "formula \"" + formula_ + "\" has no value" + place +
                       ": it divides by zero, or takes a root, power or logarithm of an invalid "
                       "number. Exclude this place by a condition, as in x > 0 ? sqrt(x) : 0");
  }

  bool has_word(const std::string &formula, const std::string_view name)
  {
    for (std::size_t i = formula.find(name); i != std::string::npos; i = formula.find(name, i + 1))
      if (!(i > 0 && is_in_word(formula[i - 1])) &&
          !(i + name.size() < formula.size() && is_in_word(formula[i + name.size()])))
        return true;
    return false;
  }
} // namespace vfife
