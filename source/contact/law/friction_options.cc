// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/law/friction_options.h>

namespace vfife
{
  void FrictionOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_choice(prm,
                   "friction law",
                   law,
                   friction_laws(),
                   "Coulomb: constant friction coefficient; exponential decay: mu(v) = mu_k + "
                   "(mu_s - mu_k) exp(-v/v_c) with slip speed v");
    declare_number(prm,
                   "friction coefficient",
                   coefficient,
                   "Friction coefficient; mu_k of the exponential decay",
                   Range::between(0., 2.));
    declare_quantity(prm,
                     "static friction coefficient",
                     static_coefficient,
                     "-",
                     "mu_s of the exponential decay; auto: the friction coefficient",
                     Range::positive().or_word("auto"));
    declare_quantity(prm,
                     "friction decay speed",
                     decay_speed,
                     "mm/s",
                     "v_c of the exponential decay",
                     Range::not_negative());
    declare_number(prm,
                   "tangential stiffness ratio",
                   stiffness_ratio,
                   "Tangential stiffness of sticking contact: ratio to the penalty",
                   Range{0., 1., true});
    declare_number(prm,
                   "friction damping ratio",
                   damping_ratio,
                   "Smallest damping ratio of a contact with friction, because friction excites "
                   "vibrations",
                   Range::between(0., 1.));
  }


  void FrictionOptions::check(const std::string &section) const
  {
    const std::string before = section.empty() ? "" : section + "/";
    if (!(coefficient >= 0.))
      throw InputError(before + "friction coefficient", "friction must not be negative");
    try
      {
        law(*this);
      }
    catch (const InputError &error)
      {
        throw InputError(before + error.entry(), error.what());
      }
    if (!(stiffness_ratio > 0. && stiffness_ratio <= 1.))
      throw InputError(before + "tangential stiffness ratio",
                       "the ratio must be positive and at most 1");
    if (!(damping_ratio >= 0. && damping_ratio <= 1.))
      throw InputError(before + "friction damping ratio",
                       "the damping ratio must lie between 0 and 1");
  }
} // namespace vfife
