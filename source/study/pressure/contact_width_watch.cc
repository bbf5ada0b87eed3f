// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>
#include <vfife/study/cases/contact_resolution.h>
#include <vfife/study/pressure/contact_width_watch.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** Of the approach, from which on the user is told. */
    constexpr double largest_error = 0.03;
    /** Part of a surface from which on a contact fills it. */
    constexpr double filled = 0.9;
  } // namespace

  ContactWidthWatch::ContactWidthWatch(const OutputFolder &,
                                       const Model        &model,
                                       const std::uint64_t steps_between,
                                       Log                &log)
    : steps_between_(steps_between)
    , log_(log)
    , largest_(model.contacts.size())
    , facets_(model.contacts.size(), 0.)
  {
  }

  bool ContactWidthWatch::due(const State &state) const
  {
    return state.step % steps_between_ == 0;
  }

  void ContactWidthWatch::observe(const Model &model, const State &state)
  {
    for (std::size_t i = 0; i < largest_.size(); ++i)
      for (const ToothContact &contact : state.measured.teeth)
        if (contact.side == model.contacts[i].side && contact.normal_force > largest_[i].force)
          {
            largest_[i] = {contact.normal_force, contact.area, contact.width};
            facets_[i]  = contact.facet_width;
          }
  }

  std::string ContactWidthWatch::part_name() const
  {
    return "contact widths";
  }

  void ContactWidthWatch::serialize(ByteStream &stream)
  {
    stream.pass(largest_);
  }

  void ContactWidthWatch::finish(const Model &model, const State &)
  {
    for (std::size_t i = 0; i < largest_.size(); ++i)
      {
        const ContactPair &pair    = model.contacts[i];
        const auto         area_of = [&](const unsigned int body, const std::string &surface) {
          return compute_area(model.bodies[body].mesh().surfaces.at(surface));
        };
        const double whole = std::min(area_of(pair.slave_body, pair.slave_surface),
                                      area_of(pair.master_body, pair.master_surface));
        if (!(largest_[i].force > 0) || largest_[i].area > filled * whole)
          continue;
        ContactResolution seen(model, pair, largest_[i].width);
        if (facets_[i] > 0.)
          seen = ContactResolution(pair, largest_[i].width, facets_[i]);
        const std::string name  = "contact " + pair.side;
        const double      error = seen.find_approach_error(pair.options.surface);
        if (seen.has_single_points())
          log_.warning(seen.describe_points(name));
        else if (error > largest_error)
          log_.warning(seen.describe_error(name, error));
      }
  }
} // namespace vfife
