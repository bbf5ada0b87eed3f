// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/law/contact_options.h>

#include <algorithm>
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
      {"surface points", ContactDiscretization::surface_points},
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
                   "Where pressure is sampled: Gauss points of the slave's facets, the mean of "
                   "both directions, or the corners of the slave's facets");
    declare_choice(
      prm,
      "surface",
      surface,
      contact_surface_kinds(),
      "What the facets stand for: the true surface by offsets and true normals, "
      "quadratic patches with the nodal normals, or themselves; auto: the true flank of a gear, "
      "patches of other bodies, flat facets of surfaces with edges");
    declare_number_or_word(
      prm,
      "points per facet",
      points_per_facet,
      "auto",
      "Gauss points of a facet per direction; auto: four across the width of Hertz's contact of a "
      "gear pair (3 to 12), 3 in other models",
      1,
      most_points);
    declare_choice(prm,
                   "integration",
                   time,
                   contact_times(),
                   "Pressure of a step: its mean over the step by the gaps at both ends, which "
                   "bears any penalty, or that of the gap before it");
    penalty.declare(prm);
    declare_number(prm,
                   "damping ratio",
                   damping_ratio,
                   "Gap-rate damping over the critical damping of a surface node on the penalty",
                   Range::between(0., 1.));
    friction.declare(prm);
    declare_quantity(prm,
                     "regularization velocity",
                     regularization_velocity,
                     "mm/s",
                     "No longer used: friction sticks elastically (tangential stiffness ratio); "
                     "allowed for older files",
                     Range::not_negative());
    declare_number(prm,
                   "edge fading",
                   edge_fading,
                   "Part of a border facet of the master over which the pressure fades to zero",
                   Range::between(0., 1.));
    declare_quantity(
      prm,
      "edge relief width",
      edge_relief_width,
      "mm",
      "Strip along the tip and end edges of both flanks over which they are relieved",
      Range::not_negative());
    declare_quantity(prm,
                     "edge relief depth",
                     edge_relief_depth,
                     "mm",
                     "Relief at the edge, falling to 0 as a parabola over the width; 0: none",
                     Range::not_negative());
    declare_quantity(prm,
                     "search skin",
                     search_skin,
                     "mm",
                     "Motion after which the wide search is repeated; 0: a fifth of a facet",
                     Range::not_negative());
    declare_quantity(prm,
                     "depth limit",
                     depth_limit,
                     "mm",
                     "Deepest penetration that is taken for contact; 0: half a facet",
                     Range::not_negative());
    declare_number(prm,
                   "penetration limit",
                   penetration_limit,
                   "Penetration over the depth limit at which a run stops as failed; 1: never",
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
      throw InputError(entry("search skin"), "the skin must not be negative");
    if (!(depth_limit >= 0.))
      throw InputError(entry("depth limit"), "the depth limit must not be negative");
    if (!(penetration_limit > 0. && penetration_limit <= 1.))
      throw InputError(entry("penetration limit"),
                       "the penetration limit must be positive and at most 1");
  }


  unsigned int points_across(const double facet, const double contact)
  {
    constexpr double least = 3, most = 12, across = 4;
    return static_cast<unsigned int>(std::clamp(std::ceil(across * facet / contact), least, most));
  }
} // namespace vfife
