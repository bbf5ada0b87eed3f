// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/law/contact_interaction.h>

#include <cmath>

namespace vfife
{
  ContactInteraction::ContactInteraction(const ContactOptions &options)
    : options_(options)
    , law_(options.penalty.law(options.penalty))
    , friction_(options.friction.acts() ? options.friction.make_law() : nullptr)
    , penalty_(options.penalty.value)
  {
  }

  void ContactInteraction::set_penalty(const double penalty, const double mass_per_area)
  {
    if (!(penalty > 0. && std::isfinite(penalty)) || !(mass_per_area >= 0.))
      throw InputError("Contact/penalty",
                       "the contact's penalty and mass per area must be positive numbers");
    penalty_       = penalty;
    mass_per_area_ = mass_per_area;
  }

  SurfaceInteraction ContactInteraction::at_step(const double dt) const
  {
    const double mass =
      mass_per_area_ > 0. ? mass_per_area_ : options_.penalty.mass_per_area_for(penalty_, dt);
    // A node of the area A is critically damped on its spring eps A by c A = 2 sqrt(eps A m).
    SurfaceInteraction interaction{*law_, penalty_};
    interaction.damping            = 2. * options_.gap_damping_ratio() * std::sqrt(penalty_ * mass);
    interaction.friction           = friction_.get();
    interaction.tangential_penalty = options_.friction.stiffness_ratio * penalty_;
    interaction.tangential_limit   = tangential_limit_;
    return interaction;
  }
} // namespace vfife
