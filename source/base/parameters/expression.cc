// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/expression.h>

#include <deal.II/base/function_parser.h>

#include <iostream>
#include <sstream>

namespace vfife
{
  struct Expression::Parser
  {
    dealii::FunctionParser<3> function{1};
  };

  Expression::Expression(const std::string &formula)
    : formula_(formula)
    , parser_(std::make_shared<Parser>())
  {
    // deal.II writes the parser's message to std::cerr before it throws; it belongs into ours.
    std::ostringstream    said;
    std::streambuf *const screen     = std::cerr.rdbuf(said.rdbuf());
    bool                  understood = true;
    try
      {
        parser_->function.initialize("x,y,z,t", formula, {{"pi", pi}}, true);
        // muParser understands a formula only when it is evaluated for the first time.
        (*this)(Vector3::Zero(), 0.);
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
    throw InputError("formula \"" + formula + "\" of x, y, z, t: " + reason);
  }

  Expression::~Expression()                             = default;
  Expression::Expression(const Expression &)            = default;
  Expression &Expression::operator=(const Expression &) = default;

  double Expression::operator()(const Vector3 &x, const double t) const
  {
    // The fourth variable of the formula is deal.II's time, not a coordinate.
    parser_->function.set_time(t);
    return parser_->function.value(dealii::Point<3>(x[0], x[1], x[2]));
  }
} // namespace vfife
