// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/gear/gear_section.h>
#include <vfife/mesh/gear/grading.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace vfife
{
  Vector2 section_coordinates(const BlankOutline &blank, const Vector3 &x, const double near_angle)
  {
    const double angle = polar_angle(x);
    return {blank.coordinates_of(x)[1], near_angle + std::remainder(angle - near_angle, 2. * pi)};
  }

  unsigned int tip_rows(const BlankOutline &blank)
  {
    return blank.tip_chamfer > 0. ? 1 : 0;
  }

  Vector3
  point_of_side(const GearGeometry &gear, const FlankSide side, const double L, const double h)
  {
    const BlankOutline &blank = gear.blank();
    const double        start = blank.flank_tip(L);
    if (!(blank.tip_chamfer > 0. && h > start))
      return gear.flank_point(side, L, h).position;
    const double tip   = blank.addendum(L);
    const double angle = polar_angle(gear.flank_point(side, L, start).position);
    const double edge =
      section_coordinates(blank, gear.flank_point(side, L, tip).position, angle)[1];
    const double inward = blank.tip_chamfer / blank.meridian_point({L, tip})[0];
    const double end    = edge + (side == gear.lower_side() ? inward : -inward);
    return position_of(blank, L, h, angle + (h - start) / blank.tip_chamfer * (end - angle));
  }

  namespace
  {
    /** Throws InputError where the flank does not start where the fillet ends: the cutter's edge
     * has taken its foot away. */
    void check_start_of_flank(const GearGeometry &gear,
                              const FlankSide     side,
                              const double        L,
                              const double        height)
    {
      // far above the round-off of points that an iteration finds
      constexpr double tolerance = 1e-7;
      const Vector3    end       = gear.fillet_point(side, L, gear.fillet_end(side)).position;
      std::string      what;
      try
        {
          if ((gear.flank_point(side, L, height).position - end).norm() < tolerance * end.norm())
            return;
        }
      catch (const InputError &error)
        {
          what = std::string(" (") + error.what() + ")";
        }
      std::ostringstream message;
      message
        << gear.name() << ": the tooth is undercut at cone distance " << L
        << " mm: its flank and its fillet do not join" << what
        << ", and no body is made of it. More teeth of the pinion, a larger pressure angle or "
           "a larger spiral angle avoid undercut";
      throw InputError(message.str());
    }

    /** Profile of a flank from the fillet's bottom to the top land, points (h, angle). */
    std::vector<Vector2> compute_profile(const GearGeometry &gear,
                                         const FlankSide     side,
                                         const double        L,
                                         const unsigned int  flank_rows,
                                         const double        grading,
                                         const double        fillet_corner,
                                         const double        near_angle)
    {
      const BlankOutline &blank = gear.blank();
      const double        end   = gear.fillet_end(side);

      std::vector<Vector2> profile;
      for (const double lambda : {0., fillet_corner * end})
        profile.push_back(
          section_coordinates(blank, gear.fillet_point(side, L, lambda).position, near_angle));

      // rows of equal or graded height between the end of the fillet and the tip
      const double start_height =
        section_coordinates(blank, gear.fillet_point(side, L, end).position, near_angle)[0];
      const double tip_height = blank.flank_tip(L);
      if (!(start_height < tip_height))
        {
          std::ostringstream message;
          message << gear.name() << ": at cone distance " << L << " mm the flank starts at height "
                  << start_height << " mm, not below the tip at " << tip_height << " mm";
          throw InputError(message.str());
        }
      check_start_of_flank(gear, side, L, start_height);
      for (const double part : graded_places(flank_rows, grading))
        {
          const double  h = start_height + (tip_height - start_height) * part;
          const Vector3 x = gear.flank_point(side, L, h).position;
          profile.emplace_back(h, section_coordinates(blank, x, near_angle)[1]);
        }
      const unsigned int n_tip_rows = tip_rows(blank);
      for (unsigned int row = 1; row <= n_tip_rows; ++row)
        {
          const double  h = tip_height + (blank.addendum(L) - tip_height) * row / n_tip_rows;
          const Vector3 x = point_of_side(gear, side, L, h);
          profile.emplace_back(h, section_coordinates(blank, x, near_angle)[1]);
        }
      return profile;
    }

    /** Moves points of one section into the metal. */
    class InwardMove
    {
    public:
      InwardMove(const BlankOutline &blank, const double L, const double depth)
        : blank_(blank)
        , L_(L)
        , depth_(depth)
      {
      }

      /** A point with @p angle of the section. At a @p corner the tip moves by the depth too. */
      Vector2 operator()(const SurfacePoint &point, const double angle, const bool corner) const
      {
        const Vector3 &x     = point.position;
        const double   polar = polar_angle(x), h = blank_.coordinates_of(x)[1];
        // The section is at right angles to its direction of L.
        const auto direction = [&](const double L, const double height) {
          return Vector3(position_of(blank_, L_ + L, h + height, polar) -
                         position_of(blank_, L_, h, polar));
        };
        const Vector3 along = direction(1., 0.);
        Vector3       inward;
        if (corner)
          {
            Matrix3 rows;
            rows << along.transpose(), point.normal.transpose(), -direction(0., 1.).transpose();
            inward = rows.inverse() * Vector3(0., 1., 1.);
          }
        else
          {
            const double part = point.normal.dot(along);
            inward            = (point.normal - part * along) / (1. - part * part);
          }
        return section_coordinates(blank_, x + depth_ * inward, angle);
      }

    private:
      const BlankOutline &blank_;
      double              L_, depth_;
    };
  } // namespace

  GearSection compute_gear_section(const GearGeometry &gear,
                                   const double        cone_distance,
                                   const unsigned int  flank_rows,
                                   const double        grading,
                                   const double        fillet_corner)
  {
    const double L = cone_distance;
    // Polar angles repeat: all are taken next to that of the lower flank at mid-face.
    const Vector3 start =
      gear.flank_point(gear.lower_side(), gear.blank().mean_cone_distance, 0.).position;
    const double near_angle = polar_angle(start);

    GearSection section;
    section.cone_distance = L;
    section.pitch         = gear.pitch();
    const auto profile_of = [&](const FlankSide side) {
      return compute_profile(gear, side, L, flank_rows, grading, fillet_corner, near_angle);
    };
    section.lower = profile_of(gear.lower_side());
    section.upper = profile_of(gear.upper_side());

    // The root land joins the fillets of a slot at their mean height; its centre is half-way
    // between the upper fillet of the tooth below and the lower one of this tooth.
    const Vector2 below = section.lower.front(), above = section.upper.front();
    section.root_height = .5 * (below[0] + above[0]);
    section.left_angle  = .5 * (above[1] + below[1] - section.pitch);
    if (!(above[1] < below[1] + section.pitch))
      throw InputError(gear.name() +
                       ": the fillets of a slot overlap: reduce the blade edge radius");
    if (!(section.lower.back()[1] < section.upper.back()[1]))
      throw InputError(gear.name() + ": the tooth is pointed below its tip");
    return section;
  }

  GearSection move_inward(const GearGeometry &gear,
                          const GearSection  &section,
                          const double        fillet_corner,
                          const double        depth)
  {
    const double        L     = section.cone_distance;
    const BlankOutline &blank = gear.blank();
    // Points of the tip rows, with the end of the flank.
    const unsigned int n_tip = tip_rows(blank) > 0 ? tip_rows(blank) + 1 : 0;
    const InwardMove   move(blank, L, depth);
    GearSection        moved        = section;
    const auto         move_profile = [&](const FlankSide side, std::vector<Vector2> &profile) {
      const double end = gear.fillet_end(side);
      for (unsigned int k = 0; k < profile.size() - n_tip; ++k)
        {
          const bool in_fillet = k < 2;
          profile[k] = move(in_fillet ? gear.fillet_point(side, L, k * fillet_corner * end)
                                      : gear.flank_point(side, L, profile[k][0]),
                            profile[k][1],
                            k + 1 == profile.size());
        }
      if (n_tip == 0)
        return;
      // Its size must not shrink with the depth of the layer, which may be larger.
      const SurfacePoint edge  = gear.flank_point(side, L, blank.addendum(L));
      const double       angle = profile.back()[1];
      const Vector2      shift =
        move(edge, angle, true) - section_coordinates(blank, edge.position, angle);
      for (unsigned int k = profile.size() - n_tip; k < profile.size(); ++k)
        profile[k] += shift;
    };
    move_profile(gear.lower_side(), moved.lower);
    move_profile(gear.upper_side(), moved.upper);
    moved.root_height -= depth;
    return moved;
  }

  namespace
  {
    /** Angle of the tip between the two flanks or their chamfers [rad]. */
    double top_land(const GearSection &section)
    {
      return section.upper.back()[1] - section.lower.back()[1];
    }
  } // namespace

  double find_largest_surface_layer(const GearGeometry &gear, const double fillet_corner)
  {
    // The top land loses width in proportion to the depth, as a small layer shows.
    constexpr double    small = .05, part_of_top_land = .5;
    const BlankOutline &blank = gear.blank();
    double              most  = std::numeric_limits<double>::infinity();
    for (const double L : {blank.inner_cone_distance(), blank.outer_cone_distance})
      {
        const GearSection outline = compute_gear_section(gear, L, 1);
        const double      width   = top_land(outline),
                     depth        = small * width * blank.meridian_point({L, blank.addendum(L)})[0],
                     left         = top_land(move_inward(gear, outline, fillet_corner, depth));
        most = std::min(most, part_of_top_land * depth * width / (width - left));
      }
    return most;
  }

  void check_surface_layer(const std::string  &section,
                           const GearGeometry &gear,
                           const double        fillet_corner,
                           const double        depth)
  {
    if (!(depth > 0.))
      return;
    constexpr double    least_part_of_top_land = .2;
    const BlankOutline &blank                  = gear.blank();
    for (const double L : {blank.inner_cone_distance(), blank.outer_cone_distance})
      {
        const GearSection outline = compute_gear_section(gear, L, 1);
        const double      width   = top_land(outline),
                     left         = top_land(move_inward(gear, outline, fillet_corner, depth));
        if (left > least_part_of_top_land * width)
          continue;
        const double       radius = blank.meridian_point({L, blank.addendum(L)})[0];
        const double       most   = (1. - least_part_of_top_land) * depth * width / (width - left);
        std::ostringstream message;
        message << "expected at most " << std::floor(100. * most) / 100.
                << " mm, because the top land is " << radius * width << " mm wide at cone distance "
                << L << " mm, got " << depth << " mm";
        throw InputError(section + "/surface layer", message.str());
      }
  }

  std::vector<GearSection> compute_gear_sections(const GearGeometry &gear,
                                                 const unsigned int  n,
                                                 const unsigned int  flank_rows,
                                                 const double        grading,
                                                 const double        fillet_corner)
  {
    const BlankOutline      &blank = gear.blank();
    std::vector<GearSection> sections;
    for (unsigned int i = 0; i <= n; ++i)
      sections.push_back(
        compute_gear_section(gear,
                             blank.inner_cone_distance() + blank.face_width * i / n,
                             flank_rows,
                             grading,
                             fillet_corner));
    return sections;
  }

  double left_angle_at(const std::vector<GearSection> &sections, const double L)
  {
    const double n     = sections.size() - 1.;
    const double along = (L - sections.front().cone_distance) /
                         (sections.back().cone_distance - sections.front().cone_distance) * n;
    const auto i = static_cast<unsigned int>(std::min(n - 1., std::max(0., std::floor(along))));
    return sections[i].left_angle +
           (along - i) * (sections[i + 1].left_angle - sections[i].left_angle);
  }

  Vector3 position_of(const BlankOutline &blank, const double L, const double h, const double angle)
  {
    const Vector2 r_z = blank.meridian_point({L, h});
    return {r_z[0] * std::cos(angle), r_z[0] * std::sin(angle), r_z[1]};
  }
} // namespace vfife
