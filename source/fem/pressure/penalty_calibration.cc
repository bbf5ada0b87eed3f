// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact_rows.h"

#include <vfife/base/errors.h>
#include <vfife/fem/pressure/penalty_calibration.h>
#include <vfife/model/model.h>

#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  namespace
  {
    using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

    /** A tooth pair with less of the load does not count. */
    constexpr double least_part = 0.01;
    /** Bounds of penalties over the first one. Stiffer springs than the upper one only add to the
     * rattling of explicit steps: what they would still change of the approach is small. */
    constexpr double largest_factor = 1.5, least_factor = .02;
    /** Gaps up to so many times the deepest penetration are looked at: softer springs have wider
     * contacts. */
    constexpr double reach_factor = 6.;
    /** Squares of distances over the width: the weights of farther points are round-off. */
    constexpr double       farthest  = 20.;
    constexpr unsigned int n_rounds  = 8;  ///< of penalties and their spreading over the points
    constexpr unsigned int most_sets = 60; ///< of points that press
    constexpr unsigned int most_iterations = 60; ///< of the search for a factor

    /** Six digits: then any number of ranks has the same penalties, whose sums differ in the last
     * digits. */
    double round_digits(const double x)
    {
      const double unit = std::pow(10., std::floor(std::log10(x)) - 5.);
      return std::round(x / unit) * unit;
    }

    const ContactCell &cell_of(const ContactCell &cell)
    {
      return cell;
    }
    const ContactCell &cell_of(const FacingPoint &point)
    {
      return point.cell;
    }

    /** Changes of the gaps at @p cells by displacements at the @p rows. */
    template <typename Cell>
    SparseRows make_gaps(const ElasticContact    &contact,
                         const std::vector<Cell> &cells,
                         const ContactRows::At    at,
                         const ContactRows       &rows,
                         const std::size_t        n_rows)
    {
      ContactRows::Entries entries;
      for (std::size_t i = 0; i < cells.size(); ++i)
        rows.append_gap(contact, cell_of(cells[i]), at, i, entries);
      SparseRows gaps(cells.size(), n_rows);
      gaps.setFromTriplets(entries.begin(), entries.end());
      return gaps;
    }
  } // namespace

  PenaltyCalibration::PenaltyCalibration(const ContactPair &pair)
    : pair_(pair)
    , penalty_(pair.options.penalty.value)
    , rule_(facet_quadrature(pair.options.discretization, pair.options.points_per_facet.number))
  {
  }

  void PenaltyCalibration::add(const std::vector<ElasticContact> &contacts,
                               const ContactLoad                 &load,
                               const std::vector<GridPressure>   &grids)
  {
    // 1. The points that springs may press, and all rows that act there.
    double deepest = 0;
    for (const GridPressure &grid : grids)
      if (grid.carries())
        deepest = std::max(deepest, grid.pressures[grid.largest()] / penalty_);
    ContactRows                           needed(load);
    std::vector<std::vector<FacingPoint>> points;
    for (std::size_t i = 0; i < contacts.size(); ++i)
      {
        points.push_back(find_facing_points(
          contacts[i].surfaces, rule_, pair_.options.edge_fading, reach_factor * deepest));
        for (const FacingPoint &point : points.back())
          needed.add(contacts[i], point.cell, ContactRows::At::nodes);
        for (const ContactCell &cell : grids[i].cells)
          needed.add(contacts[i], cell, ContactRows::At::points);
      }
    const std::vector<unsigned int> rows        = needed.number();
    const Eigen::MatrixXd           flexibility = load.flexibility(rows);

    // 2. The forces of the grids take the place of those with which the state was found.
    std::vector<Eigen::VectorXd> own;
    Eigen::VectorXd              change(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k)
      change[k] = -load.forces[rows[k]];
    for (std::size_t i = 0; i < contacts.size(); ++i)
      {
        const GridPressure &grid = grids[i];
        const std::size_t   n    = grid.cells.size();
        Eigen::VectorXd     forces(n);
        for (std::size_t k = 0; k < n; ++k)
          forces[k] = grid.force_of(k);
        own.push_back(
          make_gaps(contacts[i], grid.cells, ContactRows::At::points, needed, rows.size())
            .transpose() *
          forces);
        change += own.back();
      }

    // 3. Gaps of the points under all forces but those of their own tooth pair.
    for (std::size_t i = 0; i < contacts.size(); ++i)
      {
        if (!(grids[i].moment > least_part * load.load) || points[i].empty())
          continue;
        Touch              touch;
        const Eigen::Index n = points[i].size();
        touch.areas.resize(n);
        touch.arms.resize(n);
        touch.gaps.resize(n);
        for (Eigen::Index k = 0; k < n; ++k)
          {
            const FacingPoint &point = points[i][k];
            touch.points.push_back(point.cell.place[0] * rule_.size() + point.cell.place[1]);
            touch.areas[k] = point.area;
            touch.arms[k]  = load.arm(point.cell.position, point.cell.normal);
            touch.gaps[k]  = point.cell.gap - grids[i].closing * touch.arms[k];
          }
        const SparseRows gaps =
          make_gaps(contacts[i], points[i], ContactRows::At::nodes, needed, rows.size());
        touch.gaps += gaps * (flexibility * (change - own[i]));
        touch.flexibility = gaps * flexibility * gaps.transpose();
        touch.moment      = grids[i].moment;
        touch.width       = grids[i].width;
        touches_.push_back(std::move(touch));
      }

    if (places_.empty() && !contacts.empty())
      {
        const SurfaceGeometry &slave = *contacts.front().surfaces.slave;
        for (const unsigned int f : slave.group_facets(0))
          for (const FacetQuadraturePoint &q : rule_)
            {
              Vector3 x = Vector3::Zero();
              for (unsigned int k = 0; k < 4; ++k)
                x += q.shape[k] * slave.reference(slave.corners(f)[k]);
              places_.push_back(x);
            }
      }
  }

  Eigen::VectorXd PenaltyCalibration::Touch::press(const Eigen::VectorXd &penalties)
  {
    // h = -(gaps + flexibility f) and f = penalty area h, for the points with h > 0.
    const Eigen::Index n = gaps.size();
    if (active.empty())
      for (Eigen::Index k = 0; k < n; ++k)
        if (gaps[k] < 0.)
          active.push_back(k);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(n);
    for (unsigned int i = 0; i < most_sets; ++i)
      {
        const Eigen::Index m = active.size();
        Eigen::MatrixXd    matrix(m, m);
        Eigen::VectorXd    right(m);
        for (Eigen::Index a = 0; a < m; ++a)
          {
            for (Eigen::Index b = 0; b < m; ++b)
              matrix(a, b) = flexibility(active[a], active[b]);
            matrix(a, a) += 1. / (penalties[active[a]] * areas[active[a]]);
            right[a] = -gaps[active[a]];
          }
        const Eigen::VectorXd found = matrix.partialPivLu().solve(right);
        forces.setZero();
        for (Eigen::Index a = 0; a < m; ++a)
          forces[active[a]] = std::max(0., found[a]);
        const Eigen::VectorXd     opened = gaps + flexibility * forces;
        std::vector<Eigen::Index> next;
        for (Eigen::Index k = 0; k < n; ++k)
          if (forces[k] > 0. || (opened[k] < 0. && forces[k] == 0.))
            next.push_back(k);
        // What a solution without tension presses is found when nothing else is added.
        const bool settled = next == active && found.size() > 0 && found.minCoeff() >= 0.;
        active             = std::move(next);
        if (settled || active.empty())
          break;
      }
    return forces;
  }

  double PenaltyCalibration::Touch::find_factor(const Eigen::VectorXd &penalties)
  {
    // The moment grows with the penalty.
    const auto lack = [&](const double log_factor) {
      return press(std::exp(log_factor) * penalties).dot(arms) / moment - 1.;
    };
    // The factor of a later round is near one: the bracket grows from there.
    const double end = std::log(1. / least_factor);
    double       low = -.05, high = .05, at_low = lack(low), at_high = lack(high);
    while (at_low >= 0. && low > -end)
      {
        high    = low;
        at_high = at_low;
        low     = std::max(-end, 4. * low);
        at_low  = lack(low);
      }
    while (at_high <= 0. && high < end)
      {
        low     = high;
        at_low  = at_high;
        high    = std::min(end, 4. * high);
        at_high = lack(high);
      }
    if (at_low >= 0.)
      return std::exp(low);
    if (at_high <= 0.)
      return std::exp(high);
    std::uintmax_t iterations = most_iterations;
    const auto     ends       = boost::math::tools::toms748_solve(
      lack, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(24), iterations);
    return std::exp(.5 * (ends.first + ends.second));
  }

  std::vector<double> PenaltyCalibration::spread(const std::vector<double>          &levels,
                                                 const std::vector<Eigen::VectorXd> &forces) const
  {
    std::vector<double> values;
    for (const Vector3 &x : places_)
      {
        // The nearest point counts for 1, so that points far from all contacts have its value.
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t t = 0; t < touches_.size(); ++t)
          for (Eigen::Index k = 0; k < forces[t].size(); ++k)
            if (forces[t][k] > 0.)
              nearest = std::min(nearest,
                                 (places_[touches_[t].points[k]] - x).squaredNorm() /
                                   (touches_[t].width * touches_[t].width));
        double sum = 0, weights = 0;
        for (std::size_t t = 0; t < touches_.size(); ++t)
          for (Eigen::Index k = 0; k < forces[t].size(); ++k)
            if (forces[t][k] > 0.)
              {
                const double distance = (places_[touches_[t].points[k]] - x).squaredNorm() /
                                        (touches_[t].width * touches_[t].width);
                if (distance - nearest > farthest)
                  continue;
                const double weight = forces[t][k] * std::exp(-2. * (distance - nearest));
                sum += weight * levels[t];
                weights += weight;
              }
        values.push_back(sum / weights);
      }
    return values;
  }

  PointPenalties PenaltyCalibration::find(const double lag)
  {
    if (touches_.empty())
      throw NumericalError("no tooth pair is loaded, so that its penalty cannot be found");
    for (Touch &touch : touches_)
      touch.gaps -= lag * touch.arms;
    // The points have one field, each touch asks for a factor of it: a few rounds agree.
    const double lowest  = std::log(penalty_ * least_factor),
                 highest = std::log(penalty_ * largest_factor);
    std::vector<double>          levels(touches_.size(), std::log(penalty_));
    std::vector<double>          field(places_.size(), std::log(penalty_));
    std::vector<Eigen::VectorXd> forces(touches_.size());
    PointPenalties               found;
    const auto                   penalties_of = [&](const Touch &touch) {
      Eigen::VectorXd penalties(touch.points.size());
      for (Eigen::Index k = 0; k < penalties.size(); ++k)
        penalties[k] = std::exp(field[touch.points[k]]);
      return penalties;
    };
    for (unsigned int round = 0; round < n_rounds; ++round)
      {
        for (std::size_t t = 0; t < touches_.size(); ++t)
          {
            const Eigen::VectorXd penalties = penalties_of(touches_[t]);
            const double          factor    = touches_[t].find_factor(penalties);
            levels[t] = std::min(highest, std::max(lowest, levels[t] + std::log(factor)));
            forces[t] = touches_[t].press(factor * penalties);
          }
        field = spread(levels, forces);
      }
    double sum = 0, forces_sum = 0, moments = 0;
    for (Touch &touch : touches_)
      {
        const Eigen::VectorXd penalties = penalties_of(touch), f = touch.press(penalties);
        found.left += std::abs(f.dot(touch.arms) - touch.moment);
        moments += touch.moment;
        sum += f.dot(penalties);
        forces_sum += f.sum();
      }
    found.left /= moments;
    found.mean      = forces_sum > 0. ? sum / forces_sum : penalty_;
    const auto ends = std::minmax_element(field.begin(), field.end());
    found.least     = std::exp(*ends.first);
    found.largest   = std::exp(*ends.second);
    for (const double value : field)
      found.stiffness.push_back(round_digits(std::exp(value - *ends.second)));
    found.largest = round_digits(found.largest);
    return found;
  }
} // namespace vfife
