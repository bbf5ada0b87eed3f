// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/law/contact_laws.h>
#include <vfife/contact/law/linear_law.h>

namespace vfife
{
  const Choices<MakeContactLaw> &contact_laws()
  {
    static const Choices<MakeContactLaw> choices = {{"linear", &make_contact_law<LinearLaw>}};
    return choices;
  }
} // namespace vfife
