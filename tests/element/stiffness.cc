// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Stiffness: patch test, zero eigenvalues, the short form, bending, stresses, largest frequency.
#include "../refusal.h"
#include "../tests.h"
#include "samples.h"

#include <vfife/element/stable_step.h>
#include <vfife/element/stress.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

using namespace vfife;

Vector24 flat(const HexahedronNodes &values)
{
  return Eigen::Map<const Vector24>(values.data());
}

double largest(const Eigen::MatrixXd &values)
{
  return values.cwiseAbs().maxCoeff();
}

void check_formulation(const StiffnessKind kind)
{
  const std::string name = word_of(kind, stiffness_choices()) + ": ";
  Samples           samples;
  Material          material;
  double            patch = 0., stress_error = 0., identity = 0., symmetry = 0.;
  double            largest_zero = 0., least_positive = 1.;
  for (unsigned int sample = 0; sample < 20; ++sample)
    {
      material.poissons_ratio = 0.15 + 0.15 * samples.number();
      const HexahedronNodes X =
        samples.hexahedron({1., 1. + sample / 4., 3.}, 0.2, {60., -50., 40.});
      const Matrix24 K = compute_stiffness(X, material, kind);

      // Any constant strain: nodal forces are V sigma b, stress is D strain everywhere.
      Matrix3 gradient;
      gradient << samples.vector(), samples.vector(), samples.vector();
      const HexahedronNodes u = 1e-6 * gradient * X;
      Stress                strain;
      for (unsigned int i = 0; i < 3; ++i)
        {
          strain[i]     = 1e-6 * gradient(i, i);
          strain[3 + i] = 1e-6 * (gradient(i, (i + 1) % 3) + gradient((i + 1) % 3, i));
        }
      const Stress stress = compute_elasticity(material) * strain;
      Matrix3      sigma;
      sigma << stress[0], stress[3], stress[5], stress[3], stress[1], stress[4], stress[5],
        stress[4], stress[2];
      const HexahedronNodes expected = compute_volume(X) * sigma * compute_mean_gradients(X);
      raise_to(patch, largest(K * flat(u) - flat(expected)) / (largest(K) * largest(u)));
      const auto recovered = compute_nodal_stresses(X, X + u, material, kind, FrameKind::polar);
      raise_to(stress_error, largest(recovered.colwise() - stress) / largest(stress));

      raise_to(identity,
               largest(K - expand(compute_reduced_stiffness(X, material, kind), material)) /
                 largest(K));
      raise_to(symmetry, largest(K - K.transpose()) / largest(K));
      const Eigen::SelfAdjointEigenSolver<Matrix24> solver(K, Eigen::EigenvaluesOnly);
      const auto                                   &eigenvalues = solver.eigenvalues();
      raise_to(largest_zero, largest(eigenvalues.head<6>()) / eigenvalues[23]);
      least_positive = std::min(least_positive, eigenvalues[6] / eigenvalues[23]);
    }
  // Round-off of coordinates of 60 mm beside sides of 1 mm.
  check_below(name + "patch test", patch, 1e-14);
  // The rotation and U - I are small: the stress is exact to first order in strains of 1e-6.
  check_below(name + "patch test stresses", stress_error, 1e-4);
  check_below(name + "dense and short form", identity, 1e-12);
  check_below(name + "symmetric", symmetry, 1e-16);
  check_below(name + "six zero eigenvalues", largest_zero, 1e-14);
  check(name + "the others positive", least_positive > 1e-4);
}

/** Box of length L, height h, width w bent about z to curvature kappa (exact nodal values). */
HexahedronNodes bent(const HexahedronNodes &X, const double kappa, const double nu)
{
  HexahedronNodes u;
  for (unsigned int a = 0; a < 8; ++a)
    {
      const double x = X(0, a), y = X(1, a), z = X(2, a);
      u.col(a) = kappa * Vector3(-x * y, 0.5 * (x * x + nu * (y * y - z * z)), nu * y * z);
    }
  return u;
}

void check_bending()
{
  const Material        material;
  const double          E = material.youngs_modulus, nu = material.poissons_ratio;
  const double          length = 20., height = 1., width = 2., kappa = 1e-6;
  Samples               samples;
  const HexahedronNodes X = samples.hexahedron({length, height, width}, 0.);
  const HexahedronNodes u = bent(X, kappa, nu);

  // sigma_xx = -E kappa y on the end faces: +-E kappa w h^2 / 24 at each of their nodes.
  HexahedronNodes expected = HexahedronNodes::Zero();
  for (unsigned int a = 0; a < 8; ++a)
    expected(0, a) =
      -E * kappa * width * height * height / 24. * reference_corner(a)[0] * reference_corner(a)[1];
  const Matrix24 K = compute_stiffness(X, material, StiffnessKind::incompatible_modes);
  check_below("incompatible modes: forces of pure bending, 20:1",
              largest(K * flat(u) - flat(expected)) / largest(expected),
              1e-9);
  const double exact_energy = 0.5 * E * width * std::pow(height, 3) / 12. * kappa * kappa * length;
  check_ratio("incompatible modes: energy of pure bending, 20:1",
              0.5 * flat(u).dot(K * flat(u)) / exact_energy,
              1e-9);
  const Matrix24 K_full = compute_stiffness(X, material, StiffnessKind::full);
  // Known from the shear that a trilinear element adds: about (L/h)^2 / (2 (1 + nu)) times too
  // stiff.
  check("full: locks in bending by more than a hundred times",
        0.5 * flat(u).dot(K_full * flat(u)) / exact_energy > 100.);

  const auto stresses =
    compute_nodal_stresses(X, X + u, material, StiffnessKind::incompatible_modes, FrameKind::polar);
  double error = 0.;
  for (unsigned int a = 0; a < 8; ++a)
    {
      Stress exact = Stress::Zero();
      exact[0]     = -E * kappa * X(1, a);
      raise_to(error, largest(stresses.col(a) - exact));
    }
  // Turning the frame and squares of strains leave the order of kappa L / 2 = 1e-5.
  check_below("incompatible modes: bending stress at the nodes",
              error / (0.5 * E * kappa * height),
              5e-5);
}

/** On a parallelepiped the one-point element with its stabilization is that of the bubbles. */
void check_parallelepiped()
{
  Samples               samples;
  const Material        material;
  const HexahedronNodes box = samples.hexahedron({1., 2., 4.}, 0.);
  Matrix3               shear;
  shear << 1., 0.3, -0.2, 0., 1., 0.4, 0.1, 0., 1.;
  const HexahedronNodes X     = shear * box;
  const Matrix24        modes = compute_stiffness(X, material, StiffnessKind::incompatible_modes);
  const Matrix24        point = compute_stiffness(X, material, StiffnessKind::one_point);
  check_below("one point: incompatible modes on a parallelepiped",
              largest(modes - point) / largest(modes),
              1e-13);
  // Not on others: they are different elements.
  const HexahedronNodes distorted = samples.hexahedron({1., 2., 4.}, 0.2);
  const double          difference =
    largest(compute_stiffness(distorted, material, StiffnessKind::incompatible_modes) -
            compute_stiffness(distorted, material, StiffnessKind::one_point)) /
    largest(modes);
  check("one point: another element where it is distorted", difference > 1e-4 && difference < 0.5);
}

void check_frequency()
{
  // A cube of side a, nu = 0, full integration: pure dilatation in one direction couples two
  // lumped halves, omega^2 = 4 E / (rho a^2); patterns of hourglass type are softer or equal
  // (2x2x2 points).
  Material material;
  material.poissons_ratio = 0.;
  Samples               samples;
  const HexahedronNodes X     = samples.hexahedron({2., 2., 2.}, 0.);
  const auto            mass  = compute_lumped_mass(X, material.density);
  const Matrix24        K     = compute_stiffness(X, material, StiffnessKind::full);
  const double          omega = compute_largest_frequency(K, mass);
  const double          bar   = std::sqrt(material.youngs_modulus / material.density);
  check_ratio("largest frequency of a cube, nu = 0", omega / bar, 1e-12);
  check_close("twice the size, half the frequency",
              compute_largest_frequency(compute_stiffness(2. * X, material, StiffnessKind::full),
                                        compute_lumped_mass(2. * X, material.density)) /
                omega,
              0.5,
              1e-12);
  check("an element without mass is refused",
        refuses<NumericalError>([&] { compute_largest_frequency(K, 0. * mass); }));
}

int main()
{
  for (const auto &choice : stiffness_choices())
    check_formulation(choice.second);
  check_parallelepiped();
  check_bending();
  check_frequency();

  Stress stress = Stress::Zero();
  stress[0]     = 3.;
  check_close("von Mises stress of tension", von_mises(stress), 3., 1e-14);
  stress[0] = 0.;
  stress[4] = 2.;
  check_close("von Mises stress of shear", von_mises(stress), 2. * std::sqrt(3.), 1e-14);

  // A stress with all six components, xx yy zz xy yz zx, in axes that are turned: a_i . sigma a_j.
  Matrix3 tensor;
  tensor << 1., 4., 6., 4., 2., 5., 6., 5., 3.;
  const Matrix3 axes = (Eigen::AngleAxisd(0.7, Vector3(1., 2., 2.) / 3.)).toRotationMatrix();
  for (unsigned int c = 0; c < 6; ++c)
    stress[c] = c + 1.;
  const Stress turned = turn_stress(stress, axes);
  double       error  = 0.;
  for (unsigned int c = 0; c < 6; ++c)
    {
      const unsigned int i = c % 3, j = c < 3 ? i : (i + 1) % 3;
      raise_to(error, std::abs(turned[c] - axes.col(i).dot(tensor * axes.col(j))));
    }
  check_below("a turned stress, component by component", error, 1e-13);

  Samples         samples;
  HexahedronNodes folded = samples.hexahedron({1., 1., 1.}, 0.);
  folded.row(0) *= -1.;
  check("a folded element is refused", refuses<NumericalError>([&] {
          compute_stiffness(folded, Material(), StiffnessKind::full);
        }));
  return 0;
}
