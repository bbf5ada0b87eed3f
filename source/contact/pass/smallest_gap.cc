// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/pass/smallest_gap.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace vfife
{
  namespace
  {
    /** The facets with the smallest samples are searched: the smallest gap may lie in a facet whose
     * sample is not the smallest. */
    constexpr std::size_t n_searched_facets = 9;

    /** Widths of the 3 x 3 stencils, in parts of a facet. The gap is smooth: after two rounds the
     * parabola's error is of the order 0.06^3. */
    constexpr double stencil_widths[] = {0.25, 0.25, 0.06, 0.015};

    /** Where the quadratic function through 3 x 3 values at spacing 1 is smallest, within [-1,1]^2.
     */
    std::array<double, 2> lowest_point(const std::array<double, 9> &g)
    {
      using Vector2 = Eigen::Vector2d;
      // g[i + 3 j] at (i - 1, j - 1): least-squares coefficients of the full quadratic
      //   g = g0 + by_s s + by_t t + by_ss s^2/2 + by_st s t + by_tt t^2/2.
      double by_s = 0., by_t = 0., by_ss = 0., by_tt = 0., by_st = 0.;
      for (unsigned int k = 0; k < 3; ++k)
        {
          by_s += (g[2 + 3 * k] - g[3 * k]) / 6.;
          by_t += (g[k + 6] - g[k]) / 6.;
          by_ss += (g[2 + 3 * k] - 2. * g[1 + 3 * k] + g[3 * k]) / 3.;
          by_tt += (g[k + 6] - 2. * g[k + 3] + g[k]) / 3.;
        }
      by_st = (g[8] - g[6] - g[2] + g[0]) / 4.;
      Eigen::Matrix2d hessian;
      hessian << by_ss, by_st, by_st, by_tt;
      const Vector2 slope(by_s, by_t);
      // Its lowest point where it has one, else down the slope; back into the square.
      Vector2 best = Vector2::Zero();
      if (by_ss > 0. && hessian.determinant() > 0.)
        best = -hessian.inverse() * slope;
      else if (slope.norm() > 0.)
        best = -slope.normalized();
      const double size = best.cwiseAbs().maxCoeff();
      if (size > 1.)
        best /= size;
      return {{best[0], best[1]}};
    }

    /** Smallest gap over a slave facet, from its smallest sample on. */
    ContactPoint refine_gap(PassSurfaces &surfaces, const ListedPoint &sample)
    {
      const SurfaceGeometry &slave  = surfaces.slave.surface();
      const auto            &k      = slave.corners(sample.slave_facet);
      Projection             last   = sample.projection;
      const double           no_gap = std::numeric_limits<double>::infinity();
      ContactPoint           smallest;
      // The gap at a place of the slave's facet, projected from where the last one was.
      const auto gap_at = [&](const double s, const double t) {
        const auto    N = bilinear_weights(s, t);
        const Vector3 x = N[0] * slave.node(k[0]) + N[1] * slave.node(k[1]) +
                          N[2] * slave.node(k[2]) + N[3] * slave.node(k[3]);
        Projection p = last;
        if (!project_walking(surfaces.master, x, p) || !p.inside)
          return no_gap;
        last             = p;
        const double gap = surfaces.gap(p, slave.offset(sample.slave_facet, s, t));
        if (gap < smallest.gap)
          {
            smallest.position     = x;
            smallest.slave_facet  = sample.slave_facet;
            smallest.master_facet = p.facet;
            smallest.xi           = p.xi;
            smallest.eta          = p.eta;
            smallest.gap          = gap;
          }
        return gap;
      };

      // From the sample on, to the lowest point of a parabola through stencils that become
      // narrower.
      const FacetQuadraturePoint &from = surfaces.slave.rule()[sample.rule_point];
      double                      s = from.xi, t = from.eta;
      gap_at(s, t);
      for (const double width : stencil_widths)
        {
          // The stencil stays within the facet.
          s = std::min(1. - width, std::max(width, s));
          t = std::min(1. - width, std::max(width, t));
          std::array<double, 9> gaps;
          for (unsigned int i = 0; i < 9; ++i)
            gaps[i] = gap_at(s + width * (static_cast<double>(i % 3) - 1.),
                             t + width * (static_cast<double>(i / 3) - 1.));
          if (std::find(gaps.begin(), gaps.end(), no_gap) != gaps.end())
            break; // at the master's border: the smallest of the samples made so far
          const auto lowest = lowest_point(gaps);
          s += width * lowest[0];
          t += width * lowest[1];
          gap_at(s, t);
        }
      return smallest;
    }
  } // namespace

  ContactPoint find_smallest_gap(PassSurfaces &surfaces, const std::vector<ListedPoint> &points)
  {
    // The smallest sample of each facet, and of these the smallest few.
    std::vector<const ListedPoint *> samples;
    for (const ListedPoint &point : points)
      if (!std::isfinite(point.gap))
        continue;
      else if (samples.empty() || samples.back()->slave_facet != point.slave_facet)
        samples.push_back(&point);
      else if (point.gap < samples.back()->gap)
        samples.back() = &point;
    const auto end =
      samples.begin() + static_cast<std::ptrdiff_t>(std::min(n_searched_facets, samples.size()));
    std::partial_sort(samples.begin(),
                      end,
                      samples.end(),
                      [](const ListedPoint *a, const ListedPoint *b) { return a->gap < b->gap; });
    ContactPoint smallest;
    for (auto sample = samples.begin(); sample != end; ++sample)
      {
        const ContactPoint refined = refine_gap(surfaces, **sample);
        if (refined.gap < smallest.gap)
          smallest = refined;
      }
    return smallest;
  }
} // namespace vfife
