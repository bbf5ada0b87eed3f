// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_friction_laws_h
#define vfife_contact_law_friction_laws_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/contact/law/friction_law.h>

namespace vfife
{
  /** All laws (doc/theory/contact.md, Friction; the decay is that of Abaqus, *FRICTION, and Oden
   * and Martins 1985), the default first: a new one is a class and a row. It throws InputError by
   * entry. */
  const Choices<MakeFrictionLaw> &friction_laws();
} // namespace vfife

#endif
