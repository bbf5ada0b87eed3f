// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_contact_interaction_h
#define vfife_contact_law_contact_interaction_h

#include <vfife/contact/law/contact_options.h>
#include <vfife/contact/law/surface_interaction.h>

#include <limits>
#include <memory>

namespace vfife
{
  /** The laws of a contact with their numbers, from which each time step has its
   * SurfaceInteraction. */
  class ContactInteraction
  {
  public:
    explicit ContactInteraction(const ContactOptions &options);

    /** See Contact::set_penalty. Throws InputError on numbers that are not positive. */
    void set_penalty(double penalty, double mass_per_area);

    /** Points that stick have at most this stiffness [N/mm^3]. */
    void limit_tangential_penalty(const double limit)
    {
      tangential_limit_ = limit;
    }

    /** [N/mm^3]; 0: not set. */
    double penalty() const
    {
      return penalty_;
    }
    const ContactLaw &law() const
    {
      return *law_;
    }

    /** In a time step @p dt [s]; refers to the laws here. */
    SurfaceInteraction at_step(double dt) const;

  private:
    ContactOptions                     options_;
    std::unique_ptr<const ContactLaw>  law_;
    std::unique_ptr<const FrictionLaw> friction_; ///< none: no friction
    double                             penalty_;
    double                             mass_per_area_    = 0.;
    double                             tangential_limit_ = std::numeric_limits<double>::infinity();
  };
} // namespace vfife

#endif
