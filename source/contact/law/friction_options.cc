// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/number_text.h>
#include <vfife/contact/law/friction_options.h>

namespace vfife
{
  namespace
  {
    /** The laws that read a number, "A or B". */
    std::string list_laws_with(const FrictionNumber number)
    {
      std::string list;
      for (const auto &[name, law] : friction_laws())
        if (law.reads(number))
          list += (list.empty() ? "" : " or ") + name;
      return list;
    }
  } // namespace

  void FrictionOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_choice(prm,
                   "friction law",
                   law,
                   friction_laws(),
                   "Coulomb: constant friction coefficient; exponential decay: mu(v) = mu_k + "
                   "(mu_s - mu_k) exp(-v/v_c) with slip speed v");
    for (const FrictionEntry &entry : friction_entries())
      declare_quantity(
        prm, entry.name, this->*entry.number, entry.unit, entry.meaning, entry.range);
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

  std::unique_ptr<const FrictionLaw> FrictionOptions::make_law() const
  {
    for (const FrictionEntry &entry : friction_entries())
      if (const double number = this->*entry.number; number > 0. && !law.reads(entry.number))
        throw InputError(entry.name,
                         "expected " +
                           (entry.range.zero_word.empty() ? "0" : entry.range.zero_word) +
                           " with the friction law \"" + word_of(law, friction_laws()) +
                           "\", got " + number_text(number) + ". Set friction law to " +
                           list_laws_with(entry.number) + ".");
    return law.make(*this);
  }

  void FrictionOptions::check(const std::string &section) const
  {
    const std::string before = section.empty() ? "" : section + "/";
    if (!(coefficient >= 0.))
      throw InputError(before + "friction coefficient", "friction must not be negative");
    try
      {
        make_law();
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
