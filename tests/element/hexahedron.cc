// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Shape functions, volume, lumped mass, centroid and Jacobian of hexahedra.
#include "../tests.h"
#include "samples.h"

#include <vfife/element/hexahedron.h>

#include <Eigen/LU>

using namespace vfife;

int main()
{
  Samples samples;

  // Coordinates of some millimetres: round-off of sums of products is below 1e-13.
  const HexahedronNodes X     = samples.hexahedron({1., 2., 3.}, 0.2, {5., -4., 3.});
  const Vector3         point = 0.9 * samples.vector();
  check_ratio("shape functions sum to one", shape_functions(point).sum(), 1e-14);
  check_below("gradients sum to zero",
              reference_gradients(point).rowwise().sum().cwiseAbs().maxCoeff(),
              1e-14);
  double interpolation = 0.;
  for (unsigned int a = 0; a < 8; ++a)
    raise_to(interpolation, (X * shape_functions(reference_corner(a)) - X.col(a)).norm());
  check_below("shape functions interpolate the nodes", interpolation, 1e-13);
  const double    h = 1e-5;
  HexahedronNodes difference;
  for (unsigned int j = 0; j < 3; ++j)
    difference.row(j) = (shape_functions(point + h * Vector3::Unit(j)) -
                         shape_functions(point - h * Vector3::Unit(j)))
                          .transpose() /
                        (2. * h);
  check_below("gradients are derivatives",
              (difference - reference_gradients(point)).cwiseAbs().maxCoeff(),
              1e-10);
  check_below(
    "mean gradients reproduce linear fields",
    (X * compute_mean_gradients(X).transpose() - Matrix3::Identity()).cwiseAbs().maxCoeff(),
    1e-13);

  // A frustum of a pyramid: squares of sides 2 and 1, height 3: V = h (A + B + sqrt(A B)) / 3 = 7,
  // centroid h (A + 2 sqrt(A B) + 3 B) / (4 (A + sqrt(A B) + B)) = 33/28 above the larger one.
  HexahedronNodes frustum;
  for (unsigned int a = 0; a < 8; ++a)
    {
      const Vector3 corner = reference_corner(a);
      const double  half   = a < 4 ? 1. : 0.5;
      frustum.col(a)       = Vector3(half * corner[0], half * corner[1], a < 4 ? 0. : 3.);
    }
  const Eigen::Matrix<double, 8, 1> mass = compute_lumped_mass(frustum, 2.);
  check_close("volume of a frustum", compute_volume(frustum), 7., 1e-13);
  check_below("centroid of a frustum",
              (compute_centroid(frustum) - Vector3(0., 0., 33. / 28.)).norm(),
              1e-13);
  check_close("lumped mass sums to density times volume", mass.sum(), 14., 1e-13);
  check_below("lumped mass keeps the centre of mass",
              (frustum * mass / 14. - compute_centroid(frustum)).norm(),
              1e-13);
  check("lumped masses are positive", mass.minCoeff() > 0.);
  // det J is least at the upper corners: (1/2) (1/2) (3/2).
  check_close("least Jacobian of a frustum", compute_least_jacobian(frustum), 0.375, 1e-13);

  // Twisted so that det J is less at an integration point (by other software) than at any corner,
  // where it is a third more at least.
  HexahedronNodes twisted;
  twisted << -2., 0., -0.5, 1.5, 0., 1.5, -2., 0., //
    0., -1.5, 1., 0.5, -1.5, 0., 0.5, 1.5,         //
    -0.5, -1.5, -1., 0., 0., 1.5, 1.5, 1.;
  check_close("least Jacobian inside", compute_least_jacobian(twisted), 0.5756872293885554, 1e-13);

  HexahedronNodes folded = frustum;
  folded.col(7)          = Vector3(-0.8, -0.8, 0.5);
  check("a folded element has a negative Jacobian", compute_least_jacobian(folded) < 0.);
  return 0;
}
