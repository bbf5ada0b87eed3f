// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>
#include <vfife/study/cases/contact_resolution.h>
#include <vfife/study/pressure/contact_width_watch.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Of the approach, from which on the user is told. */
    constexpr double largest_error = 0.03;
    /** Part of a surface from which on a contact fills it. */
    constexpr double filled = 0.9;
    /** Area of the other surface over it from which on it is a punch. */
    constexpr double beside = 1.5;
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

  void ContactWidthWatch::observe(const Model &, const State &state)
  {
    for (const ToothContact &tooth : state.measured.teeth)
      if (tooth.normal_force > largest_[tooth.contact].force)
        {
          largest_[tooth.contact] = {tooth.normal_force, tooth.area, tooth.width};
          facets_[tooth.contact]  = tooth.facet_width;
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
        const double slave  = area_of(pair.slave_body, pair.slave_surface),
                     master = area_of(pair.master_body, pair.master_surface),
                     whole  = std::min(slave, master);
        // A punch on a larger surface; surfaces that are alike make a column, not a contact.
        const bool fills = largest_[i].area > filled * whole;
        if (!(largest_[i].force > 0) || (fills && std::max(slave, master) < beside * whole))
          continue;
        const double      width = fills ? std::sqrt(whole) : largest_[i].width;
        ContactResolution seen(model, pair, width);
        if (facets_[i] > 0.)
          seen = ContactResolution(pair, width, facets_[i]);
        const std::string name = "contact " + pair.side;
        const double      error =
          fills ? seen.find_punch_error() : seen.find_approach_error(pair.options.surface);
        if (seen.has_single_points())
          log_.warning(seen.describe_points(name));
        else if (error > largest_error)
          log_.warning(seen.describe_error(
            name,
            error,
            fills ? "a seventh of that width"
                  : "a quarter of that width with flat facets, to a half with smooth patches"));
      }
  }
} // namespace vfife
