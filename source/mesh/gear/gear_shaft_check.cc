// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/gear/gear_meridian.h>
#include <vfife/mesh/gear/gear_shaft_check.h>

#include <boost/geometry/algorithms/append.hpp>
#include <boost/geometry/algorithms/correct.hpp>
#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace vfife
{
  namespace
  {
    namespace geometry = boost::geometry;
    using Point        = geometry::model::d2::point_xy<double>; ///< (r, z)
    using Box          = geometry::model::box<Point>;
    using Polygon      = geometry::model::polygon<Point>;

    constexpr double tolerance = GearShaftOptions::tolerance;

    /** Digits enough to be typed in: an end of a section is then that of the hub. */
    std::string digits(const double value)
    {
      std::ostringstream text;
      text.precision(10);
      text << value;
      return text.str();
    }

    /** An interval of z [mm]. */
    struct Stretch
    {
      double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();

      void include(const double z)
      {
        low  = std::min(low, z);
        high = std::max(high, z);
      }
      std::string text() const
      {
        return "z = " + digits(low) + " to " + digits(high) + " mm";
      }
    };

    /** Whether a section is where no shaft may be: inside a part of the body, or on it where the
     * section is thicker than the bore. */
    bool collide(const ShaftSection &section, const double bore_radius, const MeridianPart &part)
    {
      Polygon polygon;
      for (const Vector2 &corner : part.corners)
        geometry::append(polygon, Point(corner[0], corner[1]));
      geometry::correct(polygon);
      const bool   thicker = .5 * section.outer > bore_radius + tolerance;
      const double gap     = thicker ? tolerance : -tolerance;
      const Box    ring(Point(.5 * section.inner - gap, section.from - gap),
                     Point(.5 * section.outer + gap, section.to + gap));
      return geometry::intersects(ring, polygon);
    }

    /** Where the body stands at the diameters of a section: on the border of its parts between both
     * radii. */
    Stretch stretch_at(const ShaftSection &section, const std::vector<MeridianPart> &parts)
    {
      Stretch      found;
      const double inner = .5 * section.inner - tolerance, outer = .5 * section.outer + tolerance;
      for (const MeridianPart &part : parts)
        for (std::size_t i = 0; i < part.corners.size(); ++i)
          {
            const Vector2 &a = part.corners[i], &b = part.corners[(i + 1) % part.corners.size()];
            if (std::max(a[0], b[0]) < inner || std::min(a[0], b[0]) > outer)
              continue;
            for (const Vector2 &end : {a, b})
              {
                const double r = std::min(outer, std::max(inner, end[0]));
                found.include(r == end[0] ? end[1]
                                          : a[1] + (b[1] - a[1]) * (r - a[0]) / (b[0] - a[0]));
              }
          }
      return found;
    }

    /** The one section that goes through the hub. */
    std::size_t find_through(const std::vector<ShaftSection> &sections,
                             const Stretch                   &hub,
                             const double                     bore_radius,
                             const std::string               &text,
                             const std::string               &entry)
    {
      std::vector<std::size_t> within;
      for (std::size_t k = 0; k < sections.size(); ++k)
        if (sections[k].from < hub.high - tolerance && sections[k].to > hub.low + tolerance)
          within.push_back(k);
      const std::string diameter = digits(2. * bore_radius) + " mm";
      if (within.empty())
        throw InputError(entry,
                         "no section passes through the hub. One section must span " + hub.text() +
                           " with an outer diameter of " + diameter);
      const std::size_t through = within.front();
      if (within.size() > 1)
        throw InputError(entry,
                         name_of_section(text, within[1]) + " and section " +
                           std::to_string(through + 1) +
                           " both reach into the length of the hub, " + hub.text() +
                           ". Only the section that passes through may lie there");
      const ShaftSection &section = sections[through];
      if (section.from > hub.low + tolerance || section.to < hub.high - tolerance)
        throw InputError(entry,
                         name_of_section(text, through) +
                           " does not go through the hub: FROM must be at most " + digits(hub.low) +
                           " mm and TO at least " + digits(hub.high) + " mm");
      if (std::abs(section.outer - 2. * bore_radius) > tolerance)
        throw InputError(entry,
                         name_of_section(text, through) +
                           " goes through the hub: OUTER must be the diameter of its bore, " +
                           diameter);
      return through;
    }
  } // namespace

  void check_gear_shaft(const std::string     &section,
                        const GearGeometry    &gear,
                        const GearBodyOptions &options)
  {
    const GearShaftOptions &shaft = options.shaft;
    if (!shaft.present())
      return;
    const std::string               entry    = section + "/sections";
    const std::vector<ShaftSection> sections = shaft.sections(section);

    // 1. The hub's length: what of the body lies on the bore.
    GearBodyOptions body                  = options;
    body.shaft                            = {};
    const std::vector<MeridianPart> parts = compute_meridian(gear, body);
    Stretch                         hub;
    for (const MeridianPart &part : parts)
      for (const Vector2 &corner : part.corners)
        if (std::abs(corner[0] - options.bore_radius) < tolerance)
          hub.include(corner[1]);

    // 2. One section in it, the others apart from the body.
    find_through(sections, hub, options.bore_radius, shaft.text, entry);
    for (std::size_t k = 0; k < sections.size(); ++k)
      for (const MeridianPart &part : parts)
        if (collide(sections[k], options.bore_radius, part))
          throw InputError(entry,
                           name_of_section(shaft.text, k) + " intersects or touches the " +
                             part.name +
                             ". Leave a gap to the body, which at these diameters lies at " +
                             stretch_at(sections[k], parts).text());

    // 3. Levels that the mesh can have.
    Stretch whole;
    for (const ShaftSection &s : sections)
      {
        whole.include(s.from);
        whole.include(s.to);
      }
    for (const double level : shaft.levels)
      if (level < whole.low - tolerance || level > whole.high + tolerance ||
          (level > hub.low + tolerance && level < hub.high - tolerance))
        throw InputError(entry,
                         "no cells can end at z = " + digits(level) +
                           " mm. The level must lie on the shaft, " + whole.text() +
                           ", and outside the hub, " + hub.text());
  }
} // namespace vfife
