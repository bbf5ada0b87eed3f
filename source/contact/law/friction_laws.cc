// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/law/friction_laws.h>

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
