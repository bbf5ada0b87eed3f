// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/law/penalty_options.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Of 4/n, from which on no step is stable. At this part of it the step is 0.22 of what
     * everything else allows. */
    constexpr double largest_part_of_limit = 0.95;

    /** Of (m/A)/dt^2: impacts of two bars on springs of 2 and of 40 (tests/dynamics/impact). */
    constexpr double rattling_fraction = 5.;

    Range fractions(const unsigned int n_moving)
    {
      return {0., largest_part_of_limit * 4. / n_moving, true};
    }
  } // namespace


  PenaltyOptions::PenaltyOptions(const unsigned int n_moving)
    : n_moving(n_moving)
  {
  }


  void PenaltyOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_switch(prm,
                   "penalty from step",
                   from_step,
                   "Take the penalty from the stability limit of the time step");
    declare_number(prm,
                   "penalty fraction",
                   fraction,
                   std::string("Penalty times dt^2 over the least nodal mass per area of ") +
                     (n_moving == 2 ? "both surfaces" : "the body's surface"),
                   fractions(n_moving));
    const std::string meaning = "Pressure per penetration, used when it is not taken from the step";
    if (derivation.empty())
      declare_quantity(prm, "penalty", value, "N/mm^3", meaning, Range::positive());
    else
      declare_quantity_or_word(
        prm, "penalty", value, "N/mm^3", "auto", meaning + "; auto: " + derivation);
    if (contact_laws().size() > 1)
      declare_choice(
        prm, "contact law", law, contact_laws(), "How the pressure grows with the penetration");
  }


  void PenaltyOptions::check(const std::string &section) const
  {
    const std::string before = section.empty() ? "" : section + "/";
    const double      most   = fractions(n_moving).highest;
    if (from_step && !(fraction > 0. && fraction <= most))
      {
        std::ostringstream text;
        text << "the fraction must be positive and at most " << most << "; from " << 4. / n_moving
             << " on no step is stable";
        throw InputError(before + "penalty fraction", text.str());
      }
    const bool is_derived = value == 0. && !derivation.empty();
    if (!from_step && !is_derived && !(value > 0. && std::isfinite(value)))
      throw InputError(before + "penalty", "the penalty must be a positive number of N/mm^3");
  }


  double PenaltyOptions::value_for_step(const double mass_per_area, const double dt) const
  {
    return from_step ? fraction * mass_per_area / (dt * dt) : value;
  }


  double PenaltyOptions::rattling_value(const double mass_per_area, const double dt)
  {
    return rattling_fraction * mass_per_area / (dt * dt);
  }


  double PenaltyOptions::mass_per_area_for(const double penalty, const double dt) const
  {
    return penalty * dt * dt / fraction;
  }


  double PenaltyOptions::vote_on_step(const double step, const double mass_per_area) const
  {
    // 4/dt^2 = 4/step^2 + n eps A/m; with eps = f (m/A)/dt^2 that is 1/dt^2 (1 - n f/4) = 1/step^2.
    const double share          = 0.25 * n_moving;
    const double inverse_square = from_step ? 1. / (step * step * (1. - share * fraction))
                                            : 1. / (step * step) + share * value / mass_per_area;
    return std::min(step, 1. / std::sqrt(inverse_square));
  }


  double PenaltyOptions::relaxation_mass(const double stiffness, const double fraction) const
  {
    // omega^2 = n k/m <= (2 fraction)^2.
    return n_moving * stiffness / (4. * fraction * fraction);
  }
} // namespace vfife
