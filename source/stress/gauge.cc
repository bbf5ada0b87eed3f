// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/model/body.h>
#include <vfife/stress/gauge.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  void GaugeOptions::declare(dealii::ParameterHandler &prm)
  {
    const Choices<std::string> bodies = {{"pinion", "pinion"}, {"gear", "gear"}},
                               sides  = {{surface_name::concave, surface_name::concave},
                                         {surface_name::convex, surface_name::convex}};
    declare_choice(prm, "body", body, bodies, "Member with the gauge");
    declare_choice(prm, "side", side, sides, "Side of the tooth whose fillet has the gauge");
    declare_integer(prm, "tooth", tooth, "Number of the tooth, from 0");
    declare_number(prm,
                   "height",
                   height,
                   "Profile position of the gauge's centre along the fillet: 0 at the root land, "
                   "1 at the start of the flank",
                   Range::between(0., 1.));
    declare_number(prm,
                   "place",
                   place,
                   "Lengthwise position of the gauge's centre: 0 at the toe, 1 at the heel",
                   Range::between(0., 1.));
    declare_quantity(prm,
                     "direction",
                     direction,
                     "deg",
                     "Measuring direction: angle from the profile direction (normal to the tooth "
                     "trace) towards the heel",
                     Range::between(-180., 180.));
    declare_quantity(
      prm, "length", length, "mm", "Length of the gauge's measuring grid", Range::positive());
  }

  Gauge::Gauge(const Body         &body,
               const Fillet       &fillet,
               const GaugeOptions &options,
               const std::string  &section)
    : body_(body)
    , fillet_(fillet)
  {
    if (options.tooth >= fillet.n_teeth())
      throw InputError(section + "/tooth",
                       "expected a tooth of the " + options.body + " from 0 to " +
                         std::to_string(fillet.n_teeth() - 1));
    const Vector2 middle = find_middle(options);
    points_              = walk(middle, options.direction + pi, .5 * options.length, section);
    std::reverse(points_.begin(), points_.end());
    points_.push_back(make_point(middle));
    const Points up = walk(middle, options.direction, .5 * options.length, section);
    points_.insert(points_.end(), up.begin(), up.end());
  }

  Gauge::Point Gauge::make_point(const Vector2 &place) const
  {
    const auto cell = [](const double x, const unsigned int n) {
      return std::min(n - 1, static_cast<unsigned int>(std::max(0., x)));
    };
    Point point;
    point.column   = cell(place[0], fillet_.n_columns());
    point.row      = cell(place[1], fillet_.n_rows());
    const double a = place[0] - point.column, b = place[1] - point.row;
    point.weights = {{(1. - a) * (1. - b), a * (1. - b), (1. - a) * b, a * b}};
    return point;
  }

  Vector3 Gauge::value(const NodeVectors &field, const Point &point, const unsigned int tooth) const
  {
    Vector3 sum = Vector3::Zero();
    for (unsigned int k = 0; k < 4; ++k)
      sum += point.weights[k] * field(fillet_.node(point.column + k % 2, point.row + k / 2, tooth));
    return sum;
  }

  Vector3 Gauge::undeformed(const Point &point, const unsigned int tooth) const
  {
    return value([this](const unsigned int node) { return body_.node_positions()[node]; },
                 point,
                 tooth);
  }

  Vector2 Gauge::find_middle(const GaugeOptions &options) const
  {
    // The column along the line at the start of the flank, then the row up the profile there:
    // lengths between the lines of nodes are linear.
    const auto find =
      [](const auto &length, const unsigned int first, unsigned int last, double l) {
        unsigned int k = first;
        while (k + 1 < last && length(k + 1) < l)
          ++k;
        return k + (l - length(k)) / (length(k + 1) - length(k));
      };
    const unsigned int end = fillet_.end_row();
    const auto along = [&](const unsigned int column) { return fillet_.face_length(column, end); };
    const double a =
      find(along, 0, fillet_.n_columns(), options.place * along(fillet_.n_columns()));
    const unsigned int column = std::min(fillet_.n_columns() - 1, static_cast<unsigned int>(a));
    const auto         up     = [&](const unsigned int row) {
      return (column + 1 - a) * fillet_.profile_length(column, row) +
             (a - column) * fillet_.profile_length(column + 1, row);
    };
    return {a, find(up, Fillet::first_row, end, options.height * up(end))};
  }

  Gauge::Points Gauge::walk(Vector2            place,
                            const double       direction,
                            const double       length,
                            const std::string &section) const
  {
    // Small steps that end at the sides of facets: within a facet the tangents change little.
    constexpr unsigned int n_steps = 64;
    constexpr double       border  = 1e-9;
    Points                 points;
    for (double left = length; left > 1e-9 * length;)
      {
        // The facet ahead, where the place is on a side: which it is follows from the way.
        Vector2 way = Vector2::Zero();
        double  ds  = std::min(left, length / n_steps);
        for (unsigned int attempt = 0; attempt < 2; ++attempt)
          {
            const Point here = make_point(place + border * way);
            const auto  node = [&](const unsigned int c, const unsigned int r) {
              return body_.node_positions()[fillet_.node(here.column + c, here.row + r, 0)];
            };
            const double  a = place[0] - here.column, b = place[1] - here.row;
            const Vector3 along =
                            (1. - b) * (node(1, 0) - node(0, 0)) + b * (node(1, 1) - node(0, 1)),
                          up = (1. - a) * (node(0, 1) - node(0, 0)) + a * (node(1, 1) - node(1, 0));
            const Vector3   e1 = along.normalized(), e2 = (up - up.dot(e1) * e1).normalized();
            Eigen::Matrix2d to_lengths;
            to_lengths << e1.dot(along), e1.dot(up), 0., e2.dot(up);
            way = to_lengths.inverse() * Vector2(std::sin(direction), std::cos(direction));
          }
        for (unsigned int k = 0; k < 2; ++k)
          {
            const double next =
              way[k] > 0. ? std::floor(place[k] + border) + 1. : std::ceil(place[k] - border) - 1.;
            if (way[k] != 0.)
              ds = std::min(ds, (next - place[k]) / way[k]);
          }
        place += ds * way;
        const char        *beyond = place[0] < -border                        ? "the toe"
                                    : place[0] > fillet_.n_columns() + border ? "the heel"
                                    : place[1] < -border                      ? "the root land"
                                    : place[1] > fillet_.n_rows() + border ? "the first row of the flank"
                                                                           : nullptr;
        std::ostringstream room;
        set_figure_digits(room, 3);
        room << 2. * (length - left);
        if (beyond != nullptr)
          throw InputError(section + "/length",
                           std::string("the gauge reaches beyond ") + beyond +
                             ". The largest length about its middle is " + room.str() + " mm");
        left -= ds;
        points.push_back(make_point(place));
      }
    return points;
  }

  double Gauge::of_displacements(const NodeVectors &u, const unsigned int tooth) const
  {
    double stretch = 0, length = 0;
    for (std::size_t k = 0; k + 1 < points_.size(); ++k)
      {
        const Vector3 piece = undeformed(points_[k + 1], tooth) - undeformed(points_[k], tooth);
        stretch +=
          piece.normalized().dot(value(u, points_[k + 1], tooth) - value(u, points_[k], tooth));
        length += piece.norm();
      }
    return stretch / length;
  }

  double Gauge::of_places(const NodeVectors &x, const unsigned int tooth) const
  {
    double now = 0, before = 0;
    for (std::size_t k = 0; k + 1 < points_.size(); ++k)
      {
        now += (value(x, points_[k + 1], tooth) - value(x, points_[k], tooth)).norm();
        before += (undeformed(points_[k + 1], tooth) - undeformed(points_[k], tooth)).norm();
      }
    return now / before - 1.;
  }
} // namespace vfife
