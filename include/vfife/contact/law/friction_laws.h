// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_friction_laws_h
#define vfife_contact_law_friction_laws_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/contact/law/friction_law.h>

#include <string>
#include <vector>

namespace vfife
{
  using FrictionNumber = double FrictionNumbers::*;

  /** The entry of a number in the parameter file, as declare_quantity() takes it. */
  struct FrictionEntry
  {
    FrictionNumber number;
    std::string    name, unit, meaning;
    Range          range;
  };

  /** Those of all numbers, in their order in the file. */
  const std::vector<FrictionEntry> &friction_entries();

  /** A law and the numbers that it reads; it throws InputError by entry. */
  struct FrictionLawKind
  {
    MakeFrictionLaw             make;
    std::vector<FrictionNumber> numbers;

    bool reads(FrictionNumber number) const;
    bool operator==(const FrictionLawKind &other) const
    {
      return make == other.make;
    }
  };

  /** All laws (doc/theory/contact.md, Friction; the decay is that of Abaqus, *FRICTION, and Oden
   * and Martins 1985), the default first: a new one is a class and a row, a new number a member of
   * FrictionNumbers and an entry. */
  const Choices<FrictionLawKind> &friction_laws();
} // namespace vfife

#endif
