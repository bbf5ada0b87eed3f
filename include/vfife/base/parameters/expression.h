// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_expression_h
#define vfife_base_parameters_expression_h

#include <vfife/base/types.h>

#include <memory>
#include <string>

namespace vfife
{
  /**
   * A formula that a user wrote, of the variables x, y, z [mm] and t [s] and the constant pi, in
   * the syntax of muParser ("sin(2*pi*50*t)", "x < 1 && z > 0 ? 1 : 0"). Copies share the parsed
   * formula.
   */
  class Expression
  {
  public:
    /** Throws InputError with what the parser says. */
    explicit Expression(const std::string &formula);
    ~Expression();
    Expression(const Expression &);
    Expression &operator=(const Expression &);

    const std::string &formula() const
    {
      return formula_;
    }

    double operator()(const Vector3 &x, double t) const;

  private:
    struct Parser;
    std::string             formula_;
    std::shared_ptr<Parser> parser_;
  };
} // namespace vfife

#endif
