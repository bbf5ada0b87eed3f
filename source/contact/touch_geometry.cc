// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/touch_geometry.h>

namespace vfife
{
  namespace
  {
    /** Weight and its slope: 0 at t = 0, 1 from t = 1 on, without kink. */
    struct SmoothStep
    {
      double value, slope;

      explicit SmoothStep(const double t)
        : value(t <= 0.   ? 0.
                : t >= 1. ? 1.
                          : t * t * (3. - 2. * t))
        , slope(t <= 0. || t >= 1. ? 0. : 6. * t * (1. - t))
      {
      }
    };
  } // namespace

  Fading::Fading(const SurfaceGeometry &master, const Projection &p, const double width)
  {
    const unsigned int border = master.border_sides(p.facet);
    if (border == 0)
      return;
    // The product of a step from each border side, so that corners fade in both directions.
    const double     scale = 1. / width;
    const SmoothStep one((border & 8u) != 0 ? p.xi * scale : 1.);
    const SmoothStep two((border & 2u) != 0 ? (1. - p.xi) * scale : 1.);
    const SmoothStep three((border & 1u) != 0 ? p.eta * scale : 1.);
    const SmoothStep four((border & 4u) != 0 ? (1. - p.eta) * scale : 1.);
    const double     along_xi = one.value * two.value, along_eta = three.value * four.value;
    weight    = along_xi * along_eta;
    slope_xi  = scale * (one.slope * two.value - one.value * two.slope) * along_eta;
    slope_eta = scale * (three.slope * four.value - three.value * four.slope) * along_xi;
  }

  TangentBasis::TangentBasis(SurfaceGeometry  &master,
                             const Projection &p,
                             const Vector3    &x,
                             const Vector3    &unit_normal)
    : normal(unit_normal)
  {
    // Dual vectors of y_xi, y_eta, n; slopes of bilinear weights in the order (0,0), (1,0), (1,1),
    // (0,1).
    const FacetState &state  = master.state(p.facet);
    const Vector3     y_xi   = state.along_xi(p.eta);
    const Vector3     y_eta  = state.along_eta(p.xi);
    const auto        offset = master.offset_gradient(p.facet, p.xi, p.eta);
    const double      by_det = 1. / y_xi.dot(y_eta.cross(normal));
    distance                 = (x - state.position(p.xi, p.eta)).dot(normal);
    dual_xi                  = by_det * y_eta.cross(normal);
    dual_eta                 = by_det * normal.cross(y_xi);
    slope_xi                 = normal.dot(y_xi) + offset[0];
    slope_eta                = normal.dot(y_eta) + offset[1];
    shape_xi                 = {{p.eta - 1., 1. - p.eta, p.eta, -p.eta}};
    shape_eta                = {{p.xi - 1., -p.xi, p.xi, 1. - p.xi}};
  }

  double TangentBasis::couple_share(const Vector3 &force, const unsigned int k) const
  {
    // Slave and master points are apart by `distance` along the normal (gap and offsets), so a
    // tangential force makes a couple. Normal forces h_k n on the master's corners balance it: h_k
    // = alpha N_k,xi + beta N_k,eta sum to zero and have the moment (alpha y_xi + beta y_eta) x n.
    return distance * (force.dot(dual_xi) * shape_xi[k] + force.dot(dual_eta) * shape_eta[k]);
  }
} // namespace vfife
