// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Strain and stress of a free surface's facets: linear fields, large rotations, no traction.
#include "../parts.h"
#include "../tests.h"

#include <vfife/element/stiffness.h>
#include <vfife/element/stress.h>
#include <vfife/stress/surface_stress.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

using namespace vfife;

/** A plane quadrilateral without equal sides, and one that is warped. */
FacetCorners make_facet(const double warp)
{
  FacetCorners X;
  X.col(0) = Vector3(0., 0., 0.);
  X.col(1) = Vector3(2., .3, .2);
  X.col(2) = Vector3(2.3, 1.1, 1.3);
  X.col(3) = Vector3(.2, .9, .8);
  // Into the plane of the first three, then out of it.
  const Vector3 n = (X.col(1) - X.col(0)).cross(X.col(2) - X.col(0)).normalized();
  X.col(3) -= n * n.dot(X.col(3)) - warp * n;
  return X;
}

Matrix3 make_gradient(const double size)
{
  Matrix3 gradient;
  gradient << 1., .2, -.3, .5, -.4, .1, .2, .6, .7;
  return size * gradient;
}

/** In the facet's own plane, 11 22 12. */
SurfaceTensor in_plane(const Matrix3 &tensor, const Eigen::Matrix<double, 3, 2> &axes)
{
  const Eigen::Matrix2d plane = axes.transpose() * tensor * axes;
  return {plane(0, 0), plane(1, 1), plane(0, 1)};
}

void linear_field()
{
  for (const double warp : {0., .3})
    {
      const FacetCorners  X = make_facet(warp);
      const FacetStrain   facet(X);
      const Matrix3       G      = make_gradient(1e-3);
      const SurfaceTensor strain = facet.of_displacements(G * X);
      check_below("linear field, strain",
                  (strain - in_plane(.5 * (G + G.transpose()), facet.axes())).norm() / G.norm(),
                  1e-14);
      check_below("axes are at right angles",
                  (facet.axes().transpose() * facet.axes() - Eigen::Matrix2d::Identity()).norm(),
                  1e-15);
    }
  // Seen from outside the corners go round against the clock: the normal is out of the metal.
  const FacetCorners X = make_facet(0.);
  const FacetStrain  facet(X);
  check("sense of the axes",
        facet.axes()
            .col(0)
            .cross(facet.axes().col(1))
            .dot((X.col(1) - X.col(0)).cross(X.col(3) - X.col(0))) > 0);
}

/** A stretch in the plane, then any rotation. */
void large_rotation()
{
  const FacetCorners                 X = make_facet(0.);
  const FacetStrain                  facet(X);
  const Eigen::Matrix<double, 3, 2> &e = facet.axes();
  Eigen::Matrix2d                    U;
  U << 1.002, .0007, .0007, .9985;
  const Matrix3 R = rotation_about(Vector3(1., -2., .5).normalized(), 2.1);
  const Vector3 n = e.col(0).cross(e.col(1));
  // Thickness changes as it likes.
  const Matrix3       F        = R * (e * U * e.transpose() + .9 * n * n.transpose());
  const SurfaceTensor expected = {U(0, 0) - 1., U(1, 1) - 1., U(0, 1)};
  check_below("stretch under a large rotation",
              (facet.of_places((F * X).colwise() + Vector3(5., 6., 7.)) - expected).norm(),
              1e-14);
  // Both measures differ by squares of the gradient.
  const Matrix3 G = make_gradient(1e-6);
  check_below("small displacements, both measures",
              (facet.of_places(X + G * X) - facet.of_displacements(G * X)).norm(),
              1e-10 * 1e-1);
}

/** The strain out of the plane that leaves the surface without traction, in all three
 * dimensions. */
void no_traction()
{
  const Material      material;
  const SurfaceTensor strain(1e-3, -4e-4, 3e-4);
  const double        nu = material.poissons_ratio;
  Stress              whole;
  whole << strain[0], strain[1], -nu / (1. - nu) * (strain[0] + strain[1]), 2. * strain[2], 0., 0.;
  whole                     = compute_elasticity(material) * whole;
  const SurfaceTensor plane = compute_surface_stress(strain, material);
  check_below("no stress across the surface", std::abs(whole[2]), 1e-10);
  check_below("stress in the plane",
              (plane - SurfaceTensor(whole[0], whole[1], whole[3])).norm(),
              1e-10);
}

/** Against eigenvalues of the whole tensor; the angle against its vector. */
void principal()
{
  for (const SurfaceTensor &s : {SurfaceTensor(300., 100., 50.),
                                 SurfaceTensor(-300., -100., 50.),
                                 SurfaceTensor(100., -300., -20.),
                                 SurfaceTensor(0., 0., -70.)})
    {
      Matrix3 tensor = Matrix3::Zero();
      tensor.topLeftCorner<2, 2>() << s[0], s[2], s[2], s[1];
      const Eigen::SelfAdjointEigenSolver<Matrix3> exact(tensor);
      const PrincipalStresses                      found = compute_principal_stresses(s);
      check_close("first principal stress", found.first, exact.eigenvalues()[2], 1e-10);
      check_close("third principal stress", found.third, exact.eigenvalues()[0], 1e-10);
      const Vector3 direction(std::cos(found.angle), std::sin(found.angle), 0.);
      const double  along = direction.dot(tensor * direction);
      check_close("stress along its direction",
                  std::abs(along),
                  std::max(found.first, -found.third),
                  1e-10);
    }
}

int main()
{
  return run_parts({linear_field, large_rotation, no_traction, principal});
}
