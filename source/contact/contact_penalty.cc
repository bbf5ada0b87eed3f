// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The stiffness of a Contact, point by point.
#include <vfife/base/errors.h>
#include <vfife/contact/contact.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  void Contact::set_penalty(const double penalty, const double mass_per_area)
  {
    if (!(penalty > 0. && std::isfinite(penalty)) || !(mass_per_area >= 0.))
      throw InputError("Contact/penalty",
                       "the contact's penalty and mass per area must be positive numbers");
    penalty_       = penalty;
    mass_per_area_ = mass_per_area;
  }


  double Contact::vary_penalty()
  {
    double least = std::numeric_limits<double>::infinity();
    for (const ContactPass &pass : passes_)
      for (unsigned int f = 0; f < pass.slave().n_facets(); ++f)
        least = std::min(least, pass.slave().facet_width(f));
    for (ContactPass &pass : passes_)
      pass.slave_points().vary_stiffness(least);
    return least;
  }


  void Contact::set_stiffness(const std::vector<double> &of_group_points)
  {
    if (passes_.size() != 1)
      throw InputError("Contact/discretization",
                       "expected one pass with a stiffness per contact point, got two passes");
    passes_.front().slave_points().set_stiffness(of_group_points);
  }


  std::array<std::vector<double>, 2> Contact::node_stiffness() const
  {
    std::array<std::vector<double>, 2> stiffness;
    stiffness[0].assign(passes_[0].slave().n_nodes(), 0.);
    stiffness[1].assign(passes_[0].master().n_nodes(), passes_.size() == 1 ? 1. : 0.);
    for (std::size_t i = 0; i < passes_.size(); ++i)
      for (unsigned int f = 0; f < passes_[i].slave().n_facets(); ++f)
        for (const unsigned int node : passes_[i].slave().corners(f))
          stiffness[i][node] =
            std::max(stiffness[i][node], passes_[i].slave_points().largest_stiffness(f));
    return stiffness;
  }


  void Contact::limit_tangential_penalty(const double limit)
  {
    tangential_limit_ = limit;
  }


  SurfaceInteraction Contact::interaction(const double dt) const
  {
    const double mass =
      mass_per_area_ > 0. ? mass_per_area_ : options_.penalty.mass_per_area_for(penalty_, dt);
    // A node of the area A is critically damped on its spring eps A by c A = 2 sqrt(eps A m).
    SurfaceInteraction interaction{*law_, penalty_};
    interaction.damping            = 2. * options_.gap_damping_ratio() * std::sqrt(penalty_ * mass);
    interaction.friction           = friction_.get();
    interaction.tangential_penalty = options_.friction.stiffness_ratio * penalty_;
    interaction.tangential_limit   = tangential_limit_;
    return interaction;
  }
} // namespace vfife
