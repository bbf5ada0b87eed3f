// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/gear/spiral_bevel/local_contact.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>

#include <Eigen/QR>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

namespace vfife
{
  namespace
  {
    /** Direction @p d of the body frame as change of (L, h) at a position [mm/mm]. */
    Vector2 cone_direction(const Blank &blank, const Vector3 &position, const Vector3 &d)
    {
      const double r  = std::hypot(position[0], position[1]);
      const double dr = (position[0] * d[0] + position[1] * d[1]) / r;
      return blank.cone_direction({dr, d[2]});
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

    /** Contact of pair 0 with its ellipse, in the fixed frame and on both members. */
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

      // Semi-axes from the fixed frame into each body's, and there into changes of (L, h).
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
      // lag = sum c_j p^j, p in pitches
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
    void find_hand_over(const PairContact &contact, ContactAnalysis &analysis)
    {
      // Pair 0 carries until its lag exceeds that of the next pair, which stands a pitch behind.
      const auto ahead = [&](const double pitches) {
        return contact.lag(pitches) - contact.lag(pitches - 1.);
      };
      double     low = 0., high = 0.;
      const auto hands_over = [&](const Vector2 &range) {
        constexpr double inside = 1e-9; // the last points themselves are on the borders
        low                     = range[0] + 1. + inside;
        high                    = range[1] - inside;
        return low < high && ahead(low) < 0. && ahead(high) > 0.;
      };
      // between these both pairs are on their flanks, or at least on edges
      analysis.hands_over = hands_over(contact.path()) || hands_over(contact.whole());
      if (!analysis.hands_over)
        return;
      const boost::math::tools::eps_tolerance<double> tolerance(50); // bits
      boost::uintmax_t                                iterations = 50;
      const auto                                      bracket =
        boost::math::tools::toms748_solve(ahead, low, high, tolerance, iterations);
      analysis.hand_over     = (bracket.first + bracket.second) / 2;
      analysis.hand_over_lag = contact.lag(analysis.hand_over);
      analysis.over_an_edge =
        analysis.hand_over > contact.path()[1] || analysis.hand_over - 1. < contact.path()[0];

      // The touching pair's lag over the pitch that ends there.
      constexpr unsigned int n     = 40;
      double                 least = analysis.hand_over_lag, most = least;
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double lag = contact.lag(analysis.hand_over - i / static_cast<double>(n));
          least            = std::min(least, lag);
          most             = std::max(most, lag);
        }
      analysis.peak_to_peak = most - least;
    }

    /** What ends the path, and how far the teeth are from carrying there. */
    void find_ends(const PairContact &contact, ContactAnalysis &analysis)
    {
      for (const unsigned int i : {0u, 1u})
        {
          PathEnd           &end  = analysis.ends[i];
          const EdgeContact &edge = contact.edge(i);
          end.border              = edge.border();
          end.is_edge             = !edge.points().empty();
          end.place               = contact.path()[i];
          end.lag                 = contact.lag(end.place);
          end.reach               = std::abs(contact.whole()[i] - end.place);
          // what carries there: the pair that lags least
          double others = std::numeric_limits<double>::infinity();
          for (const int k : {-2, -1, 1, 2})
            others = std::min(others, contact.lag(end.place + k));
          end.approach = end.lag - others;
        }
    }

    /** Points of the path from border to border, even in the pinion's rotation. */
    void find_path(const GearPair               &pair,
                   const PairContact            &whole,
                   const ContactAnalysisOptions &options,
                   ContactAnalysis              &analysis)
    {
      const UnloadedContact &contact = whole.flanks();
      const double           start   = whole.path()[0];
      analysis.contact_ratio         = whole.path()[1] - start;
      const auto n                   = std::max(8u,
                              static_cast<unsigned int>(
                                std::ceil(analysis.contact_ratio * options.points_per_pitch)));
      for (unsigned int i = 0; i <= n; ++i)
        analysis.path.push_back(make_path_point(pair,
                                                contact,
                                                analysis.side,
                                                start + i * analysis.contact_ratio / n,
                                                options.marking_thickness));
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
    {
      Subsection section(prm, "Tooth contact analysis");
      declare_quantity(prm,
                       "marking compound thickness",
                       marking_thickness,
                       "um",
                       "Gap between the flanks at the border of the contact ellipses",
                       Range::positive());
      declare_integer(prm,
                      "points per pitch",
                      points_per_pitch,
                      "Points per pitch on path of contact and curves",
                      4,
                      10000);
      declare_integer(
        prm,
        "mesh cycles",
        meshes,
        "Number of mesh cycles, where tooth deviations make the teeth unequal; 0: one "
        "revolution of the gear",
        0,
        100000);
    }
    Subsection section(prm, "Operation");
    declare_driving(prm, driving, direction);
  }

  ContactAnalysis
  analyse_contact(const GearPair &pair, const MeshSide side, const ContactAnalysisOptions &options)
  {
    const PairContact      whole(pair, side);
    const UnloadedContact &contact = whole.flanks();
    ContactAnalysis        analysis;
    analysis.side = side;
    find_path(pair, whole, options, analysis);
    find_ends(whole, analysis);
    analysis.mean       = make_path_point(pair, contact, side, 0., options.marking_thickness);
    analysis.path_angle = path_angle(pair, contact);
    fit_lag(analysis);
    find_hand_over(whole, analysis);
    const FlankContact &equations = contact.equations();
    analysis.pinion_curvatures =
      equations.pinion().principal_curvatures(analysis.mean.contact.pinion);
    analysis.gear_curvatures = equations.gear().principal_curvatures(analysis.mean.contact.gear);
    return analysis;
  }

  Table lag_table(const GearPair                     &pair,
                  const std::vector<ContactAnalysis> &sides,
                  const ContactAnalysisOptions       &options)
  {
    Table table{{"side"}, {"pitches", "-"}};
    // pairs 1, 0, -1 over p from -1 to 1: pair k stands where pair 0 will stand k pitches later
    table.add_column("pinion angle", "deg");
    table.add_column("pair", "-");
    table.add_column("lag", "arcsec");
    table.add_column("inside", "-");
    table.add_text_column("contact");
    const int n = static_cast<int>(options.points_per_pitch);
    for (const ContactAnalysis &analysis : sides)
      {
        const PairContact      whole(pair, analysis.side);
        const UnloadedContact &contact = whole.flanks();
        for (const int k : {1, 0, -1})
          {
            for (int i = -n; i <= n; ++i)
              {
                // the equations have solutions beyond the flanks; a little of that shows the curve
                const double pitches = i / static_cast<double>(n), own = pitches + k;
                if (own < whole.path()[0] - 0.1 || own > whole.path()[1] + 0.1)
                  continue;
                const double angle = pitches * contact.pitch();
                const auto   point = contact.contact(contact.reference() + angle, k);
                table.add_row({side_name(analysis.side),
                               pitches,
                               angle * 180. / pi,
                               k,
                               point.lag / arcsecond,
                               point.inside ? 1 : 0,
                               "flanks"});
              }
            // edges beyond both ends
            for (const unsigned int end : {0u, 1u})
              for (const EdgeContactPoint &point : whole.edge(end).points())
                {
                  const double angle   = point.rot1 - contact.reference() - k * contact.pitch();
                  const double pitches = angle / contact.pitch();
                  if (std::abs(pitches) <= 1.)
                    table.add_row({side_name(analysis.side),
                                   pitches,
                                   angle * 180. / pi,
                                   k,
                                   point.lag / arcsecond,
                                   1,
                                   whole.edge(end).border()});
                }
          }
      }
    return table;
  }

  Table transmission_table(const GearPair &pair, const ContactAnalysisOptions &options)
  {
    Table table{{"driver angle", "deg"}, {"transmission error", "arcsec"}};
    // the touching pair's lag over two pitches, seen from the driven member
    const PairContact contact(pair, options.working_side());
    const int         n     = static_cast<int>(options.points_per_pitch);
    const double      sense = options.direction == TurningDirection::forward ? 1. : -1.;
    const double      ratio = pair.speed_ratio();
    for (int i = -n; i <= n; ++i)
      {
        const double pitches = i / static_cast<double>(n);
        const double lag     = contact.least_lag(sense * pitches);
        const double turned  = pitches * contact.flanks().pitch(); // of the pinion
        if (!std::isfinite(lag))
          continue; // nothing touches: a gap in the curve
        // a driving gear is ahead of the exact ratio by the lag that the pinion has
        if (options.driving == DrivingMember::pinion)
          table.add_row({turned * 180. / pi, -lag / arcsecond});
        else
          table.add_row({(ratio * turned + lag) * 180. / pi, -lag / ratio / arcsecond});
      }
    return table;
  }

  Table path_table(const GearPair &pair, const std::vector<ContactAnalysis> &sides)
  {
    Table table{{"side"}, {"pitches", "-"}, {"lag", "arcsec"}};
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
