// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_friction_options_h
#define vfife_contact_law_friction_options_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/contact/law/friction_laws.h>

#include <memory>
#include <string>

namespace vfife
{
  /** Friction with elastic stick, between two bodies or at a rigid wall. */
  struct FrictionOptions : FrictionNumbers
  {
    FrictionLawKind law = friction_laws().front().second;
    /** Tangential penalty over the normal one [-]. Up to 1 it costs nothing of the step: the
     * point's stiffness in any direction is at most the normal one. */
    double stiffness_ratio = 1.;
    /** Of the critical gap-rate damping of a surface node, where friction acts [-]: friction
     * excites the vibrations of elastic bodies (doc/theory/contact.md). */
    double damping_ratio = 0.;

    /** The law with these numbers. Throws InputError for a number that it does not read. */
    std::unique_ptr<const FrictionLaw> make_law() const;

    /** Whether the law does anything with these numbers. It makes the law: not for hot loops. */
    bool acts() const
    {
      return make_law()->acts();
    }

    /** Declares the entries in the subsection entered. */
    void declare(dealii::ParameterHandler &prm);

    /** Throws InputError naming the entry relative to @p section where a value is out of its range.
     */
    void check(const std::string &section) const;
  };
} // namespace vfife

#endif
