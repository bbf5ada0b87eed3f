// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/law/linear_law.h>
#include <vfife/contact/law/penalty_options.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Of (m/A)/dt^2: impacts of two bars on springs of 2 and of 40 (tests/dynamics/impact). */
    constexpr double rattling_fraction = 5.;
  } // namespace

  const Choices<MakeContactLaw> &contact_laws()
  {
    static const Choices<MakeContactLaw> choices = {{"linear", &make_contact_law<LinearLaw>}};
    return choices;
  }

  PenaltyOptions::PenaltyOptions(const unsigned int n_moving)
    : n_moving(n_moving)
  {
  }

  void PenaltyOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_quantity(prm,
                     "penalty",
                     value,
                     "N/mm^3",
                     "Pressure per penetration; auto: " + derivation,
                     Range::positive().or_word("auto"));
    if (contact_laws().size() > 1)
      declare_choice(
        prm, "contact law", law, contact_laws(), "How the pressure grows with the penetration");
  }

  void PenaltyOptions::check(const std::string &section) const
  {
    const std::string before = section.empty() ? "" : section + "/";
    if (!(value >= 0. && std::isfinite(value)))
      throw InputError(before + "penalty",
                       "the penalty must be auto or a positive number of N/mm^3");
  }

  double PenaltyOptions::stick_value(const double mass_per_area, const double dt)
  {
    return stick_fraction * mass_per_area / (dt * dt);
  }

  double PenaltyOptions::rattling_value(const double mass_per_area, const double dt)
  {
    return rattling_fraction * mass_per_area / (dt * dt);
  }

  double PenaltyOptions::mass_per_area_for(const double penalty, const double dt)
  {
    return penalty * dt * dt / stick_fraction;
  }

  double PenaltyOptions::vote_on_step(const double step, const double mass_per_area) const
  {
    // 4/dt^2 = 4/step^2 + n eps A/m.
    return std::min(step,
                    1. / std::sqrt(1. / (step * step) + 0.25 * n_moving * value / mass_per_area));
  }

  double PenaltyOptions::vote_of_stick(const double step) const
  {
    // The same with eps = f (m/A)/dt^2: 1/dt^2 (1 - n f/4) = 1/step^2.
    const double inverse_square = 1. / (step * step * (1. - 0.25 * n_moving * stick_fraction));
    return std::min(step, 1. / std::sqrt(inverse_square));
  }

  double PenaltyOptions::relaxation_mass(const double stiffness, const double fraction) const
  {
    // omega^2 = n k/m <= (2 fraction)^2.
    return n_moving * stiffness / (4. * fraction * fraction);
  }
} // namespace vfife
