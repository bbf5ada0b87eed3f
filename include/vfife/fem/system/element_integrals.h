// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_element_integrals_h
#define vfife_fem_system_element_integrals_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/element/material.h>

#include <Eigen/Core>

#include <vector>

namespace vfife
{
  /**
   * incompatible_modes and full: 8 points with the stiffness of element/stiffness.h; quadratic and
   * cubic: dealii::FE_Q of degree 2 and 3, with 27 and 64 points.
   */
  enum class FemElement
  {
    incompatible_modes,
    full,
    quadratic,
    cubic
  };

  /** Degree of the displacements along an edge: 1, 2 or 3. */
  unsigned int degree_of(FemElement element);

  /** Gauss points along each axis. Gradients times det J have degree 3 degree - 1 on curved
   * elements; to integrate them exactly is the patch test. */
  unsigned int n_gauss(unsigned int degree);

  /** Places in [0, 1] of the points along an edge, those of dealii::FE_Q. */
  std::vector<double> places_along(unsigned int degree);

  /** The corners between which a point of the unit element lies: one at a corner, two on an edge,
   * four on a face, eight inside. */
  std::vector<unsigned int> corners_around(const Vector3 &unit);

  /** The points of an element's face @p f, seen from outside row by row, each row along the side
   * from corner 0 to 1 of BoundaryFace. */
  std::vector<unsigned int> numbers_on_face(unsigned int degree, unsigned int f);

  /**
   * consistent: rho int N_a N_b dV; lumped: its row sums (8 points, the masses of explicit
   * dynamics), or by Gauss and Lobatto's rule at the points, which are those of dealii::FE_Q.
   */
  enum class MassKind
  {
    consistent,
    lumped
  };

  /** "incompatible modes", "full integration", "quadratic", "cubic". */
  const Choices<FemElement> &fem_element_choices();
  /** "consistent", "lumped". */
  const Choices<MassKind> &mass_choices();

  /** Places of an element's points [mm], a column per point, lexicographic (x fastest): 8, 27 or
   * 64. The geometry is a field of the displacement's own space (isoparametric). */
  using ElementNodes = Eigen::Matrix<double, 3, Eigen::Dynamic>;

  /** Shape functions, their gradients [1/mm] and det J times the weight [mm^3] at a point. */
  struct ElementPoint
  {
    Eigen::VectorXd N;
    ElementNodes    gradients;
    double          weight = 0;
  };

  /** The Gauss points of an element, 2, 3 and 5 along each axis for the degrees 1, 2 and 3. Throws
   * NumericalError where det J <= 0. */
  std::vector<ElementPoint> compute_element_points(const ElementNodes &X);

  struct JacobianPoint
  {
    double  determinant; ///< of the places by the reference coordinates [mm^3]
    Vector3 place;       ///< [mm]
  };
  /** The smallest Jacobian determinant at the Gauss points and corners of an element. */
  JacobianPoint find_least_jacobian(const ElementNodes &X);

  /** Shape functions of an element's face and its normal times the weight [mm^2] at a point. */
  struct FacePoint
  {
    Eigen::VectorXd N;
    Vector3         normal;
  };

  /**
   * Gauss points of a face by its points @p X, degree + 1 along each side, those from corner 0 to 1
   * fastest; the normal is that side times the one from corner 0 to the last corner. Degree + 2
   * points along each side are exact for the normal times a shape function.
   */
  std::vector<FacePoint> compute_face_points(const ElementNodes &X);

  /** A point of a part of a face, with the bilinear functions of the part's corners in cyclic
   * order. */
  struct FacePartPoint : public FacePoint
  {
    Eigen::Vector4d bilinear;
  };

  /** Degree + 2 Gauss points along each side of the degree x degree parts of a face between its
   * points @p X, those from corner 0 to 1 fastest; the functions are bilinear in the reference
   * coordinates. */
  std::vector<std::vector<FacePartPoint>> compute_face_part_points(const ElementNodes &X);

  /** Derivatives of a face's shape functions, a column each, along its two sides at its @p degree x
   * @p degree Gauss points, where derivatives of displacements are most accurate. */
  const std::vector<Eigen::MatrixXd> &face_gradients(unsigned int degree);

  /** Stiffness [N/mm], DoF 3 * point + component. */
  Eigen::MatrixXd
  compute_fem_stiffness(const ElementNodes &X, const Material &material, FemElement element);

  /** n x n mass coefficients m_ab [t]; the mass matrix is m_ab times the identity of components. */
  Eigen::MatrixXd compute_mass_coefficients(const ElementNodes &X, double density, MassKind kind);

  /** Integrals of the density times the shape functions, by point [t]; of a point between corners
   * the part of those that are @p selected. */
  Eigen::VectorXd compute_selected_masses(const ElementNodes        &X,
                                          double                     density,
                                          unsigned int               degree,
                                          const std::array<bool, 8> &selected);

  /**
   * Stress xx yy zz xy yz zx [MPa] at the points of compute_element_points() for the displacements
   * @p u (3n) [mm], one column a point; bubbles of incompatible modes are recovered.
   */
  Eigen::Matrix<double, 6, Eigen::Dynamic> compute_point_stresses(const ElementNodes    &X,
                                                                  const Material        &material,
                                                                  FemElement             element,
                                                                  const Eigen::VectorXd &u);

  /** Values at the eight corners of an element from those at its compute_element_points(): the
   * values times this matrix, a column per corner. */
  const Eigen::MatrixXd &corner_extrapolation(unsigned int degree);
  /** The same at all points of the element. */
  const Eigen::MatrixXd &point_extrapolation(unsigned int degree);

  /** Values at evenly spaced places of an element, as many as it has points and in the same order:
   * the values at its points times this matrix, a column per place. */
  const Eigen::MatrixXd &even_places(unsigned int degree);

  /** The 3n x 3n matrix with the blocks @p coefficients(a, b) * @p block. */
  Eigen::MatrixXd expand_coefficients(const Eigen::MatrixXd &coefficients,
                                      const Eigen::Matrix3d &block);
} // namespace vfife

#endif
