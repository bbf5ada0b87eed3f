// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_surface_facet_quadrature_h
#define vfife_contact_surface_facet_quadrature_h

#include <vfife/contact/law/contact_options.h>

#include <array>
#include <vector>

namespace vfife
{
  /** Bilinear weights N_k of the corners (0,0), (1,0), (1,1), (0,1). */
  inline std::array<double, 4> bilinear_weights(const double xi, const double eta)
  {
    return {{(1. - xi) * (1. - eta), xi * (1. - eta), xi * eta, (1. - xi) * eta}};
  }

  /** A point of the quadrature on the unit square, with its bilinear weights. */
  struct FacetQuadraturePoint
  {
    double                xi, eta, weight; ///< the weights sum to one
    std::array<double, 4> shape;
  };

  /** Gauss-Legendre points and weights on [0,1], exact to degree 2n-1. */
  void gauss_legendre(unsigned int n, std::vector<double> &points, std::vector<double> &weights);

  /** Gauss-Lobatto points on [0,1], ends included, n >= 2: roots of (1-x^2) P'_{n-1}(x). */
  std::vector<double> gauss_lobatto_points(unsigned int n);

  /** n x n Gauss points (xi fastest), or the four corners for ContactDiscretization::nodes. */
  std::vector<FacetQuadraturePoint> facet_quadrature(ContactDiscretization discretization,
                                                     unsigned int          points_per_facet);

  /**
   * The offsets of FacetSurface as polynomials: Lagrange interpolation at the tensor Gauss-Lobatto
   * points is turned once into coefficients of s^i t^j, s = 2 xi - 1, t = 2 eta - 1, so that a
   * value costs n^2 multiply-adds.
   */
  class OffsetPolynomials
  {
  public:
    /** No offsets. */
    OffsetPolynomials() = default;

    /** @p offsets: rows of n*n values [mm], xi fastest. Throws InputError on a size that does not
     * fit. */
    OffsetPolynomials(unsigned int n, const std::vector<double> &offsets);

    /** Offset [mm] of row @p row at (xi, eta). */
    double value(const unsigned int row, const double xi, const double eta) const
    {
      const double  s = 2. * xi - 1., t = 2. * eta - 1.;
      const double *c   = coefficients_.data() + static_cast<std::size_t>(row) * n_ * n_;
      double        sum = 0.;
      for (unsigned int j = n_; j-- > 0;)
        {
          double line = 0.;
          for (unsigned int i = n_; i-- > 0;)
            line = line * s + c[j * n_ + i];
          sum = sum * t + line;
        }
      return sum;
    }

    /** Derivatives of the offset with respect to xi and eta [mm]. */
    std::array<double, 2> gradient(const unsigned int row, const double xi, const double eta) const
    {
      const double  s = 2. * xi - 1., t = 2. * eta - 1.;
      const double *c    = coefficients_.data() + static_cast<std::size_t>(row) * n_ * n_;
      double        by_s = 0., by_t = 0., sum = 0.;
      for (unsigned int j = n_; j-- > 0;)
        {
          double line = 0., slope = 0.;
          for (unsigned int i = n_; i-- > 0;)
            {
              slope = slope * s + line;
              line  = line * s + c[j * n_ + i];
            }
          by_t = by_t * t + sum;
          sum  = sum * t + line;
          by_s = by_s * t + slope;
        }
      return {{2. * by_s, 2. * by_t}};
    }

    bool empty() const
    {
      return coefficients_.empty();
    }

    unsigned int n_rows() const
    {
      return n_ == 0 ? 0 : static_cast<unsigned int>(coefficients_.size() / (n_ * n_));
    }

  private:
    unsigned int        n_ = 0;
    std::vector<double> coefficients_;
  };
} // namespace vfife

#endif
