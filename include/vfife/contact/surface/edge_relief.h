// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_surface_edge_relief_h
#define vfife_contact_surface_edge_relief_h

#include <vfife/base/facet_surface.h>
#include <vfife/contact/law/contact_options.h>

#include <array>
#include <vector>

namespace vfife
{
  /**
   * Relief of a surface near its edges (FacetSurface::edges): how much lower than the given surface
   * it lies,
   *   r(xi, eta) = sum over the edges of depth (1 - d/width)^2 where d < width, else 0,
   * d being the distance to the edge, bilinear between its values at the corners of the facet. Each
   * edge (tip, toe, heel) has its own d, as the least of them would not be linear in a facet at a
   * corner of the flank. r is continuous over the surface, its slope within a facet.
   */
  class EdgeRelief
  {
  public:
    /** None. */
    EdgeRelief() = default;

    /** Distances are straight lines between undeformed nodes and edges of the same group: along a
     * surface of curvature k they would be longer by the part (k width)^2/24. */
    EdgeRelief(const FacetSurface &surface, const ContactOptions &options);

    /** Relief [mm] at (xi, eta). Not for empty(). */
    double value(const unsigned int facet, const double xi, const double eta) const
    {
      double sum = 0.;
      for (unsigned int i = starts_[facet]; i < starts_[facet + 1]; ++i)
        {
          const double t = 1. - distances_[i].value(xi, eta);
          sum += t > 0. ? depth_ * t * t : 0.;
        }
      return sum;
    }

    /** Derivatives of the relief with respect to xi and eta [mm]. Not for empty(). */
    std::array<double, 2>
    gradient(const unsigned int facet, const double xi, const double eta) const
    {
      std::array<double, 2> sum = {{0., 0.}};
      for (unsigned int i = starts_[facet]; i < starts_[facet + 1]; ++i)
        {
          const BilinearDistance &d = distances_[i];
          const double            t = 1. - d.value(xi, eta);
          if (t <= 0.)
            continue;
          sum[0] -= 2. * depth_ * t * (d.c[1] + eta * d.c[3]);
          sum[1] -= 2. * depth_ * t * (d.c[2] + xi * d.c[3]);
        }
      return sum;
    }

    bool empty() const
    {
      return starts_.empty();
    }

    /** Upper bound of value() [mm]. */
    double largest() const
    {
      return depth_ * most_edges_;
    }

  private:
    /** Distance to an edge over the width: c0 + c1 xi + c2 eta + c3 xi eta. */
    struct BilinearDistance
    {
      std::array<double, 4> c;

      double value(const double xi, const double eta) const
      {
        return c[0] + xi * c[1] + eta * (c[2] + xi * c[3]);
      }
    };

    double                        depth_      = 0.;
    unsigned int                  most_edges_ = 0; ///< within reach of one facet
    std::vector<unsigned int>     starts_;         ///< per facet: its first distance
    std::vector<BilinearDistance> distances_;
  };
} // namespace vfife

#endif
