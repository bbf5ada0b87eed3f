// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_statics_dual_means_h
#define vfife_fem_statics_dual_means_h

#include <vfife/fem/system/fem_space.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace vfife
{
  struct BoundaryFace;

  /** Means of displacements at the corners of quadrilaterals on surfaces, weighted with the dual
   * functions of the bilinear ones (NodeAverages). */
  class DualMeans
  {
  public:
    /** Integrals over a quadrilateral of phi_i, phi_i phi_j and phi_i N_a: phi the bilinear
     * functions, N the shape functions of points. */
    class Quadrilateral
    {
    public:
      /** A point of a quadrature, with its @p area and its functions. */
      void add(double                           area,
               const Eigen::Vector4d           &phi,
               const std::vector<unsigned int> &points,
               const Eigen::VectorXd           &N);

    private:
      friend class DualMeans;
      Eigen::Vector4d                         of_one_      = Eigen::Vector4d::Zero();
      Eigen::Matrix4d                         of_products_ = Eigen::Matrix4d::Zero();
      std::map<unsigned int, Eigen::Vector4d> of_shapes_;
    };

    void add(const Quadrilateral &quadrilateral, const std::array<unsigned int, 4> &corners);

    /** By corner. */
    std::map<unsigned int, PointWeights> find() const;

  private:
    std::map<unsigned int, std::map<unsigned int, double>> sums_; ///< by corner and point
    std::map<unsigned int, double>                         areas_;
  };

  /** The faces of all surfaces in contact, each once, of the parts whose elements have points
   * between the nodes. */
  std::vector<std::pair<const FemSpace::Part *, std::vector<BoundaryFace>>>
  find_divided_faces(const FemSpace &space);
} // namespace vfife

#endif
