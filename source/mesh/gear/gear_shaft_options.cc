// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/number_text.h>
#include <vfife/mesh/gear/gear_shaft_options.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    bool same(const double a, const double b)
    {
      return std::abs(a - b) <= GearShaftOptions::tolerance;
    }

    /** Whether two rings share more than an edge. */
    bool touch(const ShaftSection &a, const ShaftSection &b)
    {
      const double along  = std::min(a.to, b.to) - std::max(a.from, b.from),
                   across = std::min(a.outer, b.outer) - std::max(a.inner, b.inner),
                   least  = GearShaftOptions::tolerance;
      return (along > least && (same(a.outer, b.inner) || same(b.outer, a.inner))) ||
             (across > least && (same(a.to, b.from) || same(b.to, a.from)));
    }

    /** A section that none of those that hang together with the first one touches, or their number.
     */
    std::size_t find_loose(const std::vector<ShaftSection> &sections)
    {
      std::vector<std::size_t> joined = {0}, loose;
      for (std::size_t k = 1; k < sections.size(); ++k)
        loose.push_back(k);
      for (std::size_t i = 0; i < joined.size(); ++i)
        for (auto k = loose.begin(); k != loose.end();)
          if (touch(sections[joined[i]], sections[*k]))
            {
              joined.push_back(*k);
              k = loose.erase(k);
            }
          else
            ++k;
      return loose.empty() ? sections.size() : loose.front();
    }
  } // namespace

  void GearShaftOptions::declare(dealii::ParameterHandler &prm)
  {
    const Subsection section(prm, "Shaft");
    declare_text(prm,
                 "sections",
                 text,
                 "Shaft in one piece with the body: sections FROM TO OUTER INNER along the "
                 "axis from the apex, separated by commas; places and diameters in mm. One "
                 "section passes through the hub and fills its bore; empty: no shaft");
    declare_cell_sizes(prm, axial_cell_size, radial_cell_size, ", beyond the hub");
  }

  bool GearShaftOptions::present() const
  {
    return !trimmed(text).empty();
  }

  std::vector<ShaftSection> GearShaftOptions::sections(const std::string &section) const
  {
    return parse_shaft_sections(text, section + "/sections");
  }

  void GearShaftOptions::check(const std::string &section) const
  {
    if (!present())
      return;
    const std::vector<ShaftSection> all    = sections(section);
    const auto                      refuse = [&](const std::size_t k, const std::string &message) {
      throw InputError(section + "/sections", name_of_section(text, k) + message);
    };
    for (std::size_t k = 0; k < all.size(); ++k)
      if (all[k].inner == 0.)
        refuse(
          k,
          " is solid: the core of a solid shaft does not divide into the sectors of a gear; "
          "its inner diameter must lie above 0 and below " +
            number_text(all[k].outer) +
            " mm. A tenth of the outer diameter changes bending and torsional stiffness by 0.01 "
            "%");
    const std::size_t loose = find_loose(all);
    if (loose < all.size())
      refuse(loose,
             " is not connected to section 1. Each section must start where another ends, or lie "
             "around another, with common metal between the diameters");
  }

  double GearShaftOptions::n_cells(const double       bore_radius,
                                   const unsigned int columns,
                                   const unsigned int lines) const
  {
    if (!present())
      return 0.;
    const std::vector<ShaftSection> all = sections("Shaft");
    double                          n   = 0.;
    for (const ShaftSection &s : all)
      {
        // Ends and diameters of others divide the cells of a section, too.
        double layers = 1. + (s.to - s.from) / axial_cell_size,
               rows   = 1. + .5 * (s.outer - s.inner) / radial_cell_size;
        for (const ShaftSection &other : all)
          {
            for (const double place : {other.from, other.to})
              layers += s.from < place && place < s.to ? 1. : 0.;
            for (const double diameter : {other.outer, other.inner})
              rows += s.inner < diameter && diameter < s.outer ? 1. : 0.;
          }
        for (const double level : levels)
          layers += s.from < level && level < s.to ? 1. : 0.;
        // Within the bore three columns become one, in a row of four cells of its own.
        const bool fills_bore = same(s.outer, 2. * bore_radius);
        layers += fills_bore ? lines : 0.;
        const bool coarsens = columns % 3 == 0 && s.outer < 2. * bore_radius + tolerance;
        n += layers * (coarsens ? columns / 3 * (rows + (fills_bore ? 4. : 0.)) : columns * rows);
      }
    return n;
  }
} // namespace vfife
