// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_linear_law_h
#define vfife_contact_law_linear_law_h

#include <vfife/contact/law/contact_law.h>

namespace vfife
{
  /** Springs of the stiffness eps: p = eps h, energy eps h^2/2. */
  class LinearLaw : public ContactLaw
  {
  public:
    explicit LinearLaw(const PenaltyOptions &options);

    void evaluate(std::vector<PressedPoint> &points) const override;
  };
} // namespace vfife

#endif
