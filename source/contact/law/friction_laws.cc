// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/number_text.h>
#include <vfife/contact/law/friction_laws.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Refuses a number that Coulomb's law does not use. */
    void require_unused(const std::string &entry, const std::string &expected, const double number)
    {
      if (number > 0.)
        throw InputError(entry,
                         "expected " + expected + " with the friction law \"Coulomb\", got " +
                           number_text(number) + ". Set friction law to exponential decay.");
    }

    class CoulombFriction : public FrictionLaw
    {
    public:
      explicit CoulombFriction(const FrictionNumbers &numbers)
        : coefficient_(numbers.coefficient)
      {
        require_unused("static friction coefficient", "auto", numbers.static_coefficient);
        require_unused("friction decay speed", "0", numbers.decay_speed);
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


  const Choices<MakeFrictionLaw> &friction_laws()
  {
    static const Choices<MakeFrictionLaw> choices = {
      {"Coulomb", &make_friction_law<CoulombFriction>},
      {"exponential decay", &make_friction_law<ExponentialDecay>}};
    return choices;
  }
} // namespace vfife
