// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/law/facet_penalty.h>

namespace vfife
{
  void derive_from_facets(PenaltyOptions &options)
  {
    options.value      = 0.;
    options.derivation = "5 E*/h, 1/E* the sum of (1 - nu^2)/E of the bodies, h the width of the "
                         "facet";
  }
} // namespace vfife
