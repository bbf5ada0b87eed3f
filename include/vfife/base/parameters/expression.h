// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_expression_h
#define vfife_base_parameters_expression_h

#include <vfife/base/types.h>

#include <memory>
#include <string>
#include <string_view>

namespace vfife
{
  /**
   * A formula that a user wrote, of the variables x, y, z [mm] and t [s] and the constant pi, in
   * the syntax of muParser ("sin(2*pi*50*t)", "x < 1 && z > 0 ? 1 : 0"). Copies share the parsed
   * formula.
   *
   * muParser takes a comma for an operator whose value is that of its right side, "=" for an
   * assignment, and compares the outcome of a comparison with the next number. Each would misread a
   * formula in silence ("0,5*t", "x = 5", "0 < x < 5"), so that they are refused.
   */
  class Expression
  {
  public:
    /**
     * @p entry is the path of the entry that has the formula; errors of its values name it.
     * @throws InputError with what the parser says, without an entry.
     */
    explicit Expression(const std::string &formula, const std::string &entry = "");
    ~Expression();
    Expression(const Expression &);
    Expression &operator=(const Expression &);

    const std::string &formula() const
    {
      return formula_;
    }

    /** The value. Throws InputError with formula and place where it has none: where the value is
     * not finite, or an operation in it has no value and no condition (&&, ||, ?, if) leaves that
     * place out. */
    double operator()(const Vector3 &x, double t) const;

    /** Whether the value is not zero. Throws as operator(), and where a division by zero decides.
     */
    bool holds(const Vector3 &x) const;

  private:
    struct Parser;

    double                  evaluate(const Vector3 &x, double t) const;
    double                  checked_value(const Vector3 &x, double t, int no_value) const;
    [[noreturn]] void       refuse(const Vector3 &x, double t) const;
    std::string             formula_;
    std::shared_ptr<Parser> parser_;
  };

  /** Whether @p name stands in @p formula as a word. */
  bool has_word(const std::string &formula, std::string_view name);
} // namespace vfife

#endif
