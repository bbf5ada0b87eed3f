// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_contact_law_h
#define vfife_contact_law_contact_law_h

#include <memory>
#include <vector>

namespace vfife
{
  struct PenaltyOptions;

  /** What goes into a contact law at a point, and what comes out; with the penalty times the
   * point's area also force [N], energy [mJ] and stiffness [N/mm]. */
  struct PressedPoint
  {
    double penetration = 0.; ///< h, positive [mm]
    double penalty     = 0.; ///< eps [N/mm^3]
    double pressure    = 0.; ///< p(h) [MPa]
    double energy      = 0.; ///< integral of p from 0 to h [mJ/mm^2]
    double tangent     = 0.; ///< dp/dh [N/mm^3]
  };

  /**
   * The elastic pressure between two surfaces, or a body and a rigid wall, by their penetration h.
   *
   * p(0) = 0, p grows with h, and p is proportional to the penalty eps, which scales the law. The
   * tangent is at most eps: the stable step is that of springs of the stiffness eps
   * (PenaltyOptions). A law that stiffens with h goes on with the slope eps from where it has
   * reached it.
   */
  class ContactLaw
  {
  public:
    virtual ~ContactLaw() = default;

    /** From penetration and penalty of all points that a pair of groups (teeth) or a wall presses:
     * pressure, energy and tangent. One call for all of them, as it is part of every step. */
    virtual void evaluate(std::vector<PressedPoint> &points) const = 0;
  };

  using MakeContactLaw = std::unique_ptr<const ContactLaw> (*)(const PenaltyOptions &options);

  template <typename Law>
  std::unique_ptr<const ContactLaw> make_contact_law(const PenaltyOptions &options)
  {
    return std::make_unique<const Law>(options);
  }
} // namespace vfife

#endif
