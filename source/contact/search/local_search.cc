// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/search/local_search.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** (xi, eta) this little outside still belong to the facet: round-off at a shared edge must not
     * lose a point. */
    constexpr double side_tolerance = 1e-9;

    /** At the surface's border more is allowed, so that points on coinciding borders do not come
     * and go. */
    constexpr double border_tolerance = 1e-3;

    /** A step below this leaves an error of its square times the facet's warp and curvature over
     * its size: below 1e-12 mm along the facet in the tests, and the gap does not depend on that to
     * the first order. */
    constexpr double last_step = 1e-7;

    enum class Outcome
    {
      moving,
      converged,
      singular
    };

    /**
     * One Newton step of r = x - y - lambda m = 0 for (xi, eta, lambda) by Cramer's rule: the
     * columns of the Jacobian are a = y_xi + lambda m_xi, b = y_eta + lambda m_eta, m.
     */
    inline Outcome newton_step(const FacetState &f, const Vector3 &x, Projection &p)
    {
      const Vector3 m   = f.normal(p.xi, p.eta);
      const Vector3 r   = x - f.position(p.xi, p.eta) - p.lambda * m;
      const Vector3 a   = f.y[1] + p.eta * f.y[3] + p.lambda * (f.m[1] + p.eta * f.m[3]);
      const Vector3 b   = f.y[2] + p.xi * f.y[3] + p.lambda * (f.m[2] + p.xi * f.m[3]);
      const Vector3 axb = a.cross(b);
      const double  det = axb.dot(m);
      if (!(det > 1e-6 * axb.norm()))
        return Outcome::singular;
      const double  by_det = 1. / det;
      const Vector3 rxm    = r.cross(m);
      const double  d_xi   = -by_det * b.dot(rxm);
      const double  d_eta  = by_det * a.dot(rxm);
      p.xi += d_xi;
      p.eta += d_eta;
      p.lambda += by_det * r.dot(axb);
      return std::abs(d_xi) + std::abs(d_eta) < last_step ? Outcome::converged : Outcome::moving;
    }

    /**
     * How far (xi, eta) lie beyond side s; negative inside. Corners and (sides) of a facet:
     *
     *      3--(2)--2
     *      |       |     eta
     *     (3)     (1)     ^
     *      |       |      |
     *      0--(0)--1      +--> xi
     */
    inline double excess(const Projection &p, const unsigned int side)
    {
      switch (side)
        {
        case 0:
          return -p.eta;
        case 1:
          return p.xi - 1.;
        case 2:
          return p.eta - 1.;
        default:
          return -p.xi;
        }
    }

    inline bool is_inside(const unsigned int border_sides, const Projection &p)
    {
      for (unsigned int side = 0; side < 4; ++side)
        if (!(excess(p, side) <= (border_sides & (1u << side) ? border_tolerance : side_tolerance)))
          return false;
      return true;
    }

    /** Whether (xi, eta) had to be brought back. */
    inline bool clamp(Projection &p)
    {
      const double xi = p.xi, eta = p.eta;
      p.xi  = std::min(2., std::max(-1., p.xi));
      p.eta = std::min(2., std::max(-1., p.eta));
      return p.xi != xi || p.eta != eta;
    }

    /** A point that is driven against the clamp in so many steps on end lies far outside. */
    constexpr unsigned int most_clamps = 4;

    /**
     * Goes over @p side into the neighbour. Along a side in counter-clockwise sense t runs 0..1;
     * the neighbour has the same edge backwards, so t turns into 1-t and the excess into depth
     * behind its own side.
     */
    inline void cross_side(const SurfaceGeometry &master, const unsigned int side, Projection &p)
    {
      const auto        &crossing = master.crossing(p.facet, side);
      const double       along[4] = {p.xi, p.eta, 1. - p.xi, 1. - p.eta};
      const double       t        = 1. - std::min(1.5, std::max(-0.5, along[side]));
      const double       depth    = std::min(1., excess(p, side));
      const unsigned int entry    = crossing.side;
      p.facet                     = crossing.facet;
      p.xi  = entry == 0 ? t : entry == 1 ? 1. - depth : entry == 2 ? 1. - t : depth;
      p.eta = entry == 0 ? depth : entry == 1 ? t : entry == 2 ? 1. - depth : 1. - t;
    }

    /** The inner side that (xi, eta) lie farthest beyond, or 4. */
    inline unsigned int side_to_cross(const SurfaceGeometry &master, const Projection &p)
    {
      const unsigned int border   = master.border_sides(p.facet);
      unsigned int       best     = 4;
      double             farthest = side_tolerance;
      for (unsigned int side = 0; side < 4; ++side)
        if (!(border & (1u << side)))
          {
            const double e = excess(p, side);
            if (e > farthest)
              {
                farthest = e;
                best     = side;
              }
          }
      return best;
    }
  } // namespace

  bool project_on_facet(const FacetState  &facet,
                        const unsigned int border_sides,
                        const Vector3     &x,
                        Projection        &p)
  {
    p.inside            = false;
    unsigned int clamps = 0;
    for (unsigned int i = 0; i < 25 && clamps < most_clamps; ++i)
      {
        const Outcome outcome = newton_step(facet, x, p);
        if (outcome == Outcome::singular)
          return false;
        if (outcome == Outcome::converged)
          {
            p.inside = is_inside(border_sides, p);
            return true;
          }
        clamps = clamp(p) ? clamps + 1 : 0;
      }
    // A point that is driven against the clamp lies far outside: that is an answer too.
    return !is_inside(border_sides, p);
  }

  bool project_walking(SurfaceGeometry &master, const Vector3 &x, Projection &p)
  {
    p.inside               = false;
    unsigned int crossings = 0, clamps = 0;
    for (unsigned int i = 0; i < 60 && clamps < most_clamps; ++i)
      {
        // A step on this facet: where it has converged inside, that is the foot.
        const Outcome outcome = newton_step(master.state(p.facet), x, p);
        if (outcome == Outcome::singular)
          return false;
        if (outcome == Outcome::converged && is_inside(master.border_sides(p.facet), p))
          {
            p.inside = true;
            return true;
          }
        // Outside: on in the neighbour, without waiting for convergence here.
        const unsigned int side = side_to_cross(master, p);
        if (side < 4)
          {
            if (++crossings > 20)
              return false;
            cross_side(master, side, p);
            continue;
          }
        // No neighbour there: beyond the border once converged.
        if (outcome == Outcome::converged)
          return true;
        clamps = clamp(p) ? clamps + 1 : 0;
      }
    return !is_inside(master.border_sides(p.facet), p);
  }

  double clamped_distance(const FacetState &facet, const Vector3 &x, const Projection &p)
  {
    return (x - facet.position(std::min(1., std::max(0., p.xi)), std::min(1., std::max(0., p.eta))))
      .norm();
  }
} // namespace vfife
