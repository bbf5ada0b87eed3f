// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/law/contact_options.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Depth over width. Points sleep until the motion of the surfaces could close their gap; two
     * reliefs of this slope (at the edge twice the ratio) lengthen that motion by 8 %, of 25 % that
     * the search allows. */
    constexpr double steepest_edge_relief = 0.1;

    constexpr unsigned int most_points = 20; ///< of a facet per direction
  }                                          // namespace

  const Choices<ContactDiscretization> &contact_discretizations()
  {
    static const Choices<ContactDiscretization> choices = {
      {"Gauss points", ContactDiscretization::surface_points},
      {"two pass", ContactDiscretization::two_pass},
      {"nodes", ContactDiscretization::nodes}};
    return choices;
  }

  const Choices<ContactSurfaceKind> &contact_surface_kinds()
  {
    static const Choices<ContactSurfaceKind> choices = {
      {"auto", ContactSurfaceKind::automatic},
      {"true flank", ContactSurfaceKind::true_flank},
      {"smooth patches", ContactSurfaceKind::smooth_patches},
      {"flat facets", ContactSurfaceKind::flat_facets}};
    return choices;
  }

  const Choices<ContactTime> &contact_times()
  {
    static const Choices<ContactTime> choices = {{"implicit", ContactTime::implicit},
                                                 {"explicit", ContactTime::explicit_}};
    return choices;
  }

  void ContactOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_choice(prm,
                   "discretization",
                   discretization,
                   contact_discretizations(),
                   "Where contact pressure is evaluated: Gauss points of the slave facets; two "
                   "pass: Gauss points of both surfaces, results averaged; nodes: corners of the "
                   "slave facets");
    declare_choice(prm,
                   "surface",
                   surface,
                   contact_surface_kinds(),
                   "Geometry of the contact surfaces. true flank: facets with offsets and "
                   "normals of the exact flank; smooth patches: quadratic by nodal normals; flat "
                   "facets; auto: true flank for gears, smooth patches for other bodies, flat "
                   "facets where a surface has edges");
    declare_number_or_word(
      prm,
      "points per facet",
      points_per_facet,
      "auto",
      "Gauss points per facet and direction; auto: four across the Hertzian contact "
      "width of a gear pair (3 to 12 points), 3 in other models",
      1,
      most_points);
    declare_choice(prm,
                   "integration",
                   time,
                   contact_times(),
                   "Time integration of the contact pressure. implicit: mean over the step, "
                   "stable for any penalty; explicit: pressure at the beginning of the step");
    penalty.declare(prm);
    declare_number(prm,
                   "damping ratio",
                   damping_ratio,
                   "Damping of the gap rate: ratio to the critical damping of a surface node on "
                   "the penalty stiffness",
                   Range::between(0., 1.));
    friction.declare(prm);
    declare_number(prm,
                   "edge fading",
                   edge_fading,
                   "Strip along the edge of the master surface over which the pressure falls to "
                   "zero: part of a facet's width",
                   Range::between(0., 1.));
    declare_quantity(prm,
                     "edge relief width",
                     edge_relief_width,
                     "mm",
                     "Width of the relieved strip along the tip edge and the end edges of both "
                     "flanks",
                     Range::not_negative());
    declare_quantity(prm,
                     "edge relief depth",
                     edge_relief_depth,
                     "mm",
                     "Relief at the edge; it falls to 0 as a parabola over the edge relief width; "
                     "0: no relief",
                     Range::not_negative());
    declare_quantity(prm,
                     "search tolerance",
                     search_skin,
                     "mm",
                     "Relative motion after which the global contact search is repeated; auto: a "
                     "fifth of a facet's width",
                     Range::positive().or_word("auto"));
    declare_quantity(prm,
                     "contact depth limit",
                     depth_limit,
                     "mm",
                     "Largest penetration at which two facets count as in contact; auto: half a "
                     "facet's width",
                     Range::positive().or_word("auto"));
    declare_number(prm,
                   "abort penetration ratio",
                   penetration_limit,
                   "The run stops with an error at this ratio of penetration to contact depth "
                   "limit; 1: never",
                   Range::between(1e-6, 1.));
  }

  void ContactOptions::check(const std::string &section) const
  {
    const auto entry = [&section](const std::string &name) {
      return section.empty() ? name : section + "/" + name;
    };
    if (points_per_facet.number < 1 || points_per_facet.number > most_points)
      throw InputError(entry("points per facet"),
                       "expected 1 to " + std::to_string(most_points) +
                         " points per direction, got " + std::to_string(points_per_facet.number));
    penalty.check(section);
    if (!(damping_ratio >= 0. && damping_ratio <= 1.))
      throw InputError(entry("damping ratio"), "the damping ratio must lie between 0 and 1");
    friction.check(section);
    if (!(edge_fading >= 0. && edge_fading <= 1.))
      throw InputError(entry("edge fading"), "the fading part must lie between 0 and 1");
    if (!(edge_relief_depth >= 0. && edge_relief_width >= 0.))
      throw InputError(entry("edge relief depth"),
                       "depth and width of the edge relief must not be negative");
    if (edge_relief_depth > steepest_edge_relief * edge_relief_width)
      throw InputError(entry("edge relief depth"), "must be at most a tenth of edge relief width");
    if (!(search_skin >= 0.))
      throw InputError(entry("search tolerance"), "the skin must not be negative");
    if (!(depth_limit >= 0.))
      throw InputError(entry("contact depth limit"), "must not be negative");
    if (!(penetration_limit > 0. && penetration_limit <= 1.))
      throw InputError(entry("abort penetration ratio"), "must be positive and at most 1");
  }

  unsigned int points_across(const double facet, const double contact)
  {
    constexpr double least = 3, most = 12, across = 4;
    return static_cast<unsigned int>(std::clamp(std::ceil(across * facet / contact), least, most));
  }
} // namespace vfife
