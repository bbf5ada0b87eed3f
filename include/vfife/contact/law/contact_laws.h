// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_contact_laws_h
#define vfife_contact_law_contact_laws_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/contact/law/contact_law.h>

namespace vfife
{
  /** All laws that a user may choose, the default first: a new one is a row here. */
  const Choices<MakeContactLaw> &contact_laws();
} // namespace vfife

#endif
