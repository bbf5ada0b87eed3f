// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters.h>
#include <vfife/gear/contact_analysis.h>
#include <vfife/gear/local_contact.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    const Choices<DrivingMember>    driving_members = {{"pinion", DrivingMember::pinion},
                                                       {"gear", DrivingMember::gear}};
    const Choices<TurningDirection> directions      = {{"forward", TurningDirection::forward},
                                                       {"reverse", TurningDirection::reverse}};

    /** Direction @p d of the body frame as change of (L, h) at a position [mm/mm]. */
    Vector2 cone_direction(const Blank &blank, const Vector3 &position, const Vector3 &d)
    {
      const double r  = std::hypot(position[0], position[1]);
      const double dr = (position[0] * d[0] + position[1] * d[1]) / r;
      const double c = std::cos(blank.pitch_angle), s = std::sin(blank.pitch_angle);
      return {d[2] * c + dr * s, dr * c - d[2] * s};
    }

    /** Rotation of the body frame of the *generated* flanks into the fixed frame at a contact. */
    struct Placements
    {
      Matrix3 pinion, gear;

      Placements(const GearPair &pair, const MeshSide side, const UnloadedContactPoint &point)
      {
        const double turn = pair.pinion().turn(pair.pinion_side(side));
        pinion =
          pair.pinion_placement(point.rot1 + turn + point.pair * pair.pinion().pitch()).rotation;
        gear = pair.gear_placement(point.rot2 - point.pair * pair.gear().pitch()).rotation;
      }
    };

    PathPoint make_path_point(const GearPair        &pair,
                              const UnloadedContact &contact,
                              const MeshSide         side,
                              const double           pitches,
                              const double           separation)
    {
      PathPoint result;
      result.pitches = pitches;
      result.contact = contact.contact(contact.reference() + pitches * contact.pitch(), 0);
      result.ellipse = contact.ellipse(result.contact, separation);

      const UnloadedContactPoint &point = result.contact;
      const Placements            placements(pair, side, point);
      const Vector3 major = result.ellipse.semi_axes[0] * result.ellipse.major_direction;
      const Vector3 minor =
        result.ellipse.semi_axes[1] * point.normal.cross(result.ellipse.major_direction);
      const auto on_gear = [&](const Vector3 &d) {
        return cone_direction(pair.gear().blank(),
                              point.gear.position,
                              placements.gear.transpose() * d);
      };
      const auto on_pinion = [&](const Vector3 &d) {
        return cone_direction(pair.pinion().blank(),
                              point.pinion.position,
                              placements.pinion.transpose() * d);
      };
      result.gear_major   = on_gear(major);
      result.gear_minor   = on_gear(minor);
      result.pinion_major = on_pinion(major);
      result.pinion_minor = on_pinion(minor);
      result.major_angle =
        LengthAndHeight(pair.gear().blank(), point.gear.position, point.gear.normal)
          .angle(placements.gear.transpose() * result.ellipse.major_direction);
      return result;
    }

    /** Least squares over the path; without mounting errors lag and slope vanish at the mean. */
    void fit_lag(ContactAnalysis &analysis)
    {
      const auto      n = static_cast<Eigen::Index>(analysis.path.size());
      Eigen::MatrixXd powers(n, 5);
      Eigen::VectorXd lag(n);
      for (Eigen::Index i = 0; i < n; ++i)
        {
          const PathPoint &point = analysis.path[i];
          for (unsigned int j = 0; j < 5; ++j)
            powers(i, j) = std::pow(point.pitches, j);
          lag[i] = point.contact.lag;
        }
      // what the mean contact's design makes zero is not fitted: round-off would appear as figures
      const bool            exact = std::abs(analysis.mean.contact.lag) < 1e-12;
      const Eigen::Index    first = exact ? 2 : 0;
      const Eigen::VectorXd c     = powers.rightCols(5 - first).colPivHouseholderQr().solve(lag);
      if (!exact)
        analysis.lag_offset = c.head<2>();
      for (unsigned int j = 0; j < 3; ++j)
        analysis.lag_polynomial[j] = c[2 - first + j];
      analysis.fit_error = (powers.rightCols(5 - first) * c - lag).lpNorm<Eigen::Infinity>();
    }

    /** Where the next pair takes over, and how much the lag changes until then. */
    void find_hand_over(const UnloadedContact &contact, ContactAnalysis &analysis)
    {
      const auto lag = [&](const double pitches, const int pair) {
        return contact.contact(contact.reference() + pitches * contact.pitch(), pair).lag;
      };
      const auto ahead = [&](const double pitches) { return lag(pitches, 0) - lag(pitches, -1); };
      // both pairs are inside between these
      double low = analysis.ends[0] + 1., high = analysis.ends[1];
      analysis.hands_over = low < high && ahead(low) < 0. && ahead(high) > 0.;
      if (!analysis.hands_over)
        return;
      for (unsigned int i = 0; i < 50; ++i)
        (ahead((low + high) / 2) < 0. ? low : high) = (low + high) / 2;
      analysis.hand_over     = (low + high) / 2;
      analysis.hand_over_lag = lag(analysis.hand_over, 0);

      constexpr unsigned int n     = 40;
      double                 least = analysis.hand_over_lag;
      for (unsigned int i = 0; i <= n; ++i)
        least = std::min(least, lag(analysis.hand_over - 1. + i / static_cast<double>(n), 0));
      analysis.peak_to_peak = analysis.hand_over_lag - least;
    }

    void find_path(const GearPair               &pair,
                   const UnloadedContact        &contact,
                   const ContactAnalysisOptions &options,
                   ContactAnalysis              &analysis)
    {
      const auto range       = contact.path_range();
      analysis.ends          = Vector2(range.first, range.second) / contact.pitch();
      analysis.contact_ratio = analysis.ends[1] - analysis.ends[0];
      const auto n           = std::max(8u,
                              static_cast<unsigned int>(
                                std::ceil(analysis.contact_ratio * options.points_per_pitch)));
      for (unsigned int i = 0; i <= n; ++i)
        analysis.path.push_back(make_path_point(pair,
                                                contact,
                                                analysis.side,
                                                analysis.ends[0] + i * analysis.contact_ratio / n,
                                                options.marking_thickness));
      for (const unsigned int i : {0, 1})
        analysis.borders[i] =
          contact.nearest_border((i == 0 ? analysis.path.front() : analysis.path.back()).contact);
    }

    /** Direction of the path on the gear flank at the mean contact. */
    double path_angle(const GearPair &pair, const UnloadedContact &contact)
    {
      constexpr double           step  = 0.01; // pitches
      const double               rot1  = contact.reference();
      const UnloadedContactPoint point = contact.contact(rot1, 0);
      const Vector3 along = contact.contact(rot1 + step * contact.pitch(), 0).gear.position -
                            contact.contact(rot1 - step * contact.pitch(), 0).gear.position;
      return LengthAndHeight(pair.gear().blank(), point.gear.position, point.gear.normal)
        .angle(along);
    }
  } // namespace

  void ContactAnalysisOptions::declare(dealii::ParameterHandler &prm)
  {
    Subsection section(prm, "Tooth contact analysis");
    declare_quantity(prm,
                     "marking compound thickness",
                     marking_thickness,
                     "um",
                     "Gap between the flanks at the border of the contact ellipses",
                     Range::positive());
    declare_integer(prm, "points per pitch", points_per_pitch, "Points of path and curves", 4);
    declare_choice(prm, "driving member", driving, driving_members, "Which member drives");
    declare_choice(prm,
                   "direction of rotation",
                   direction,
                   directions,
                   "Forward: the pinion turns counter-clockwise seen from its back");
  }

  MeshSide ContactAnalysisOptions::working_side() const
  {
    // a driving gear pushes with the flanks that a driving pinion uses the other way round
    const bool forward = direction == TurningDirection::forward;
    return (driving == DrivingMember::pinion) == forward ? MeshSide::drive : MeshSide::coast;
  }

  std::string side_name(const MeshSide side)
  {
    return side == MeshSide::drive ? "drive" : "coast";
  }

  ContactAnalysis
  analyse_contact(const GearPair &pair, const MeshSide side, const ContactAnalysisOptions &options)
  {
    const UnloadedContact contact(pair, side);
    ContactAnalysis       analysis;
    analysis.side = side;
    find_path(pair, contact, options, analysis);
    analysis.mean       = make_path_point(pair, contact, side, 0., options.marking_thickness);
    analysis.path_angle = path_angle(pair, contact);
    fit_lag(analysis);
    find_hand_over(contact, analysis);
    analysis.pinion_curvatures = pair.pinion()
                                   .generated_flank(pair.pinion_side(side))
                                   .principal_curvatures(analysis.mean.contact.pinion);
    analysis.gear_curvatures = pair.gear()
                                 .generated_flank(pair.gear_side(side))
                                 .principal_curvatures(analysis.mean.contact.gear);
    return analysis;
  }

  Table lag_table(const GearPair                     &pair,
                  const std::vector<ContactAnalysis> &sides,
                  const ContactAnalysisOptions       &options)
  {
    Table table;
    table.add_text_column("side");
    table.add_column("pitches", "-");
    table.add_column("pinion angle", "deg");
    table.add_column("pair", "-");
    table.add_column("lag", "arcsec");
    table.add_column("inside", "-");
    const int n = static_cast<int>(options.points_per_pitch);
    for (const ContactAnalysis &analysis : sides)
      {
        const UnloadedContact contact(pair, analysis.side);
        for (const int k : {1, 0, -1})
          for (int i = -n; i <= n; ++i)
            {
              // the equations have solutions beyond the flanks; a little of that shows the curve
              const double pitches = i / static_cast<double>(n), own = pitches + k;
              if (own < analysis.ends[0] - 0.1 || own > analysis.ends[1] + 0.1)
                continue;
              const double angle = pitches * contact.pitch();
              const auto   point = contact.contact(contact.reference() + angle, k);
              table.add_row({side_name(analysis.side),
                             pitches,
                             angle * 180. / pi,
                             k,
                             point.lag / arcsecond,
                             point.inside ? 1 : 0});
            }
      }
    return table;
  }

  Table path_table(const GearPair &pair, const std::vector<ContactAnalysis> &sides)
  {
    Table table;
    table.add_text_column("side");
    table.add_column("pitches", "-");
    table.add_column("lag", "arcsec");
    for (const std::string member : {"pinion", "gear"})
      {
        for (const char *coordinate : {" L", " h", " x", " y", " z"})
          table.add_column(member + coordinate, "mm");
        for (const char *axis : {" major L", " major h", " minor L", " minor h"})
          table.add_column(member + axis, "mm");
      }
    table.add_column("smaller relative curvature", "1/mm");
    table.add_column("larger relative curvature", "1/mm");
    table.add_column("semi-axis a", "mm");
    table.add_column("semi-axis b", "mm");
    table.add_column("major axis angle", "deg");
    for (const ContactAnalysis &analysis : sides)
      {
        const double turn1 = pair.pinion().turn(pair.pinion_side(analysis.side));
        const double turn2 = pair.gear().turn(pair.gear_side(analysis.side));
        for (const PathPoint &p : analysis.path)
          {
            const UnloadedContactPoint &point = p.contact;
            const Vector3 one = rotation_about(Vector3::UnitZ(), turn1) * point.pinion.position;
            const Vector3 two = rotation_about(Vector3::UnitZ(), turn2) * point.gear.position;
            const ContactEllipse &e = p.ellipse;
            table.add_row({side_name(analysis.side),
                           p.pitches,
                           point.lag / arcsecond,
                           point.pinion_L_h[0],
                           point.pinion_L_h[1],
                           one[0],
                           one[1],
                           one[2],
                           p.pinion_major[0],
                           p.pinion_major[1],
                           p.pinion_minor[0],
                           p.pinion_minor[1],
                           point.gear_L_h[0],
                           point.gear_L_h[1],
                           two[0],
                           two[1],
                           two[2],
                           p.gear_major[0],
                           p.gear_major[1],
                           p.gear_minor[0],
                           p.gear_minor[1],
                           e.relative_curvatures[0],
                           e.relative_curvatures[1],
                           e.semi_axes[0],
                           e.semi_axes[1],
                           p.major_angle * 180. / pi});
          }
      }
    return table;
  }
} // namespace vfife
