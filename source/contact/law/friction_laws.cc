// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/number_text.h>
#include <vfife/contact/law/friction_laws.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    class CoulombFriction : public FrictionLaw
    {
    public:
      explicit CoulombFriction(const FrictionNumbers &numbers)
        : coefficient_(numbers.coefficient)
      {
      }

      double limit(const double pressure, const double /*speed*/) const override
      {
        return coefficient_ * pressure;
      }

      bool depends_on_speed() const override
      {
        return false;
      }

    private:
      double coefficient_;
    };

    class ExponentialDecay : public FrictionLaw
    {
    public:
      explicit ExponentialDecay(const FrictionNumbers &numbers)
        : kinetic_(numbers.coefficient)
        , excess_(numbers.static_coefficient > 0. ? numbers.static_coefficient - kinetic_ : 0.)
        , decay_speed_(numbers.decay_speed)
      {
        if (excess_ < 0.)
          throw InputError("static friction coefficient",
                           "expected at least the friction coefficient " + number_text(kinetic_) +
                             ", got " + number_text(numbers.static_coefficient));
        if (!(decay_speed_ > 0.))
          throw InputError("friction decay speed",
                           "expected a positive speed with the friction law \"exponential "
                           "decay\", got 0. Set the slip over which friction falls to mu_k");
      }

      double limit(const double pressure, const double speed) const override
      {
        return (kinetic_ + excess_ * std::exp(-speed / decay_speed_)) * pressure;
      }

      bool depends_on_speed() const override
      {
        return true;
      }

    private:
      double kinetic_, excess_; ///< mu_k, mu_s - mu_k [-]
      double decay_speed_;      ///< [mm/s]
    };
  } // namespace

  const std::vector<FrictionEntry> &friction_entries()
  {
    static const std::vector<FrictionEntry> entries = {
      {&FrictionNumbers::coefficient,
       "friction coefficient",
       "-",
       "Friction coefficient; mu_k of the exponential decay",
       Range::between(0., 2.)},
      {&FrictionNumbers::static_coefficient,
       "static friction coefficient",
       "-",
       "mu_s of the exponential decay; auto: the friction coefficient",
       Range::positive().or_word("auto")},
      {&FrictionNumbers::decay_speed,
       "friction decay speed",
       "mm/s",
       "v_c of the exponential decay",
       Range::not_negative()}};
    return entries;
  }

  bool FrictionLawKind::reads(const FrictionNumber number) const
  {
    return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
  }

  const Choices<FrictionLawKind> &friction_laws()
  {
    static const Choices<FrictionLawKind> choices = {
      {"Coulomb", {&make_friction_law<CoulombFriction>, {&FrictionNumbers::coefficient}}},
      {"exponential decay",
       {&make_friction_law<ExponentialDecay>,
        {&FrictionNumbers::coefficient,
         &FrictionNumbers::static_coefficient,
         &FrictionNumbers::decay_speed}}}};
    return choices;
  }
} // namespace vfife
