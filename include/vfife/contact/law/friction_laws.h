// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_friction_laws_h
#define vfife_contact_law_friction_laws_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/contact/law/friction_law.h>

namespace vfife
{
  /** All laws, the default first: a new one is a class and a row. It throws InputError by entry.
   * - Coulomb: limit mu p.
   * - exponential decay: limit mu(v) p with mu(v) = mu_k + (mu_s - mu_k) exp(-v/v_c), v the slip
   *   speed (Abaqus, *FRICTION; Oden and Martins 1985). */
  const Choices<MakeFrictionLaw> &friction_laws();
} // namespace vfife

#endif
