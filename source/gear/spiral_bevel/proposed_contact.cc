// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/spiral_bevel/proposed_contact.h>

#include <sstream>

namespace vfife
{
  void check_proposed_contact(const PairProposal &proposal,
                              const double        shaft_angle,
                              const Blank        &gear,
                              const MeshSide      side,
                              const MeanContact  &mean,
                              const FlankContact &contact)
  {
    const double ratio = static_cast<double>(proposal.pinion_teeth) / proposal.gear_teeth;
    const double step  = 0.1 * 2. * pi / proposal.pinion_teeth;

    // lag = lag'' phi^2 / 2 by second differences over a tenth of a pitch
    const auto follow = [&](const double turn) {
      FlankContact::Unknowns x = mean.unknowns();
      if (!contact.follow(mean.rot1 + turn, x))
        refuse_proposal(proposal,
                        shaft_angle,
                        "the flanks of the " + side_name(side) +
                          " side do not touch next to the mean contact");
      return x;
    };
    const auto lag_at = [&](const double turn) {
      const FlankContact::Unknowns x = follow(turn);
      return mean.lag(side, ratio, x[FlankContact::rot1], x[FlankContact::rot2]);
    };
    const double second     = lag_at(step) + lag_at(-step) - 2. * lag_at(0.);
    const double lag        = second / 2. * 25.; // half a pitch is five steps
    const double axis       = contact.ellipse(follow(0.), marking_thickness).semi_axes[0];
    const double asked_axis = proposal.ellipse_length * gear.face_width / 2.;

    // A wrong solution misses by factors or by the sign.
    constexpr double largest_factor = 2.;
    const auto       is_like        = [&](const double value, const double target) {
      return value > target / largest_factor && value < target * largest_factor;
    };
    if (is_like(lag, proposal.lag) && is_like(axis, asked_axis))
      return;
    std::ostringstream message;
    message << "the " << side_name(side) << " side does not touch as designed: lag at half a pitch "
            << lag / arcsecond << " arcsec instead of " << proposal.lag / arcsecond
            << ", major semi-axis of the ellipse " << axis << " mm instead of " << asked_axis;
    refuse_proposal(proposal, shaft_angle, message.str());
  }
} // namespace vfife
