// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/system_matrices.h>

namespace vfife
{
  namespace
  {
    /** [a]x: cross product with the axis. */
    Matrix3 cross_matrix(const Vector3 &a)
    {
      Matrix3 m;
      m << 0., -a[2], a[1], a[2], 0., -a[0], -a[1], a[0], 0.;
      return m;
    }

    Matrix3 across(const Vector3 &a)
    {
      return Matrix3::Identity() - a * a.transpose();
    }
  } // namespace

  SystemMatrices::SystemMatrices(const Assembly &assembly, const MassKind mass)
    : assembly_(assembly)
    , mass_(mass)
  {
  }

  Eigen::MatrixXd SystemMatrices::mass_coefficients(const unsigned int e) const
  {
    const Discretization &d = assembly_.discretization();
    return compute_mass_coefficients(d.element_nodes(e), d.material(e).density, mass_);
  }

  unsigned int SystemMatrices::body(const unsigned int e) const
  {
    return assembly_.discretization().part_of_element(e).body;
  }

  const Axis &SystemMatrices::axis(const unsigned int e) const
  {
    return assembly_.discretization().model().bodies[body(e)].axis;
  }

  SparseValues SystemMatrices::stiffness() const
  {
    const Discretization &d = assembly_.discretization();
    return assembly_.matrix([&](const unsigned int e) {
      return compute_fem_stiffness(d.element_nodes(e), d.material(e), d.element());
    });
  }

  SparseValues SystemMatrices::mass() const
  {
    return assembly_.matrix([&](const unsigned int e) {
      return expand_coefficients(mass_coefficients(e), Matrix3::Identity());
    });
  }

  SparseValues SystemMatrices::spin_mass(const Rate &rate) const
  {
    return assembly_.matrix([&](const unsigned int e) {
      const double omega = rate(body(e));
      return expand_coefficients(omega * omega * mass_coefficients(e), across(axis(e).direction));
    });
  }

  SparseValues SystemMatrices::gyroscopic(const Rate &rate) const
  {
    return assembly_.matrix([&](const unsigned int e) {
      return expand_coefficients(rate(body(e)) * mass_coefficients(e),
                                 cross_matrix(axis(e).direction));
    });
  }

  SparseValues SystemMatrices::geometric(const std::vector<double> &u) const
  {
    const Discretization &d = assembly_.discretization();
    return assembly_.matrix([&](const unsigned int e) {
      return expand_coefficients(compute_geometric_coefficients(
                                   d.element_nodes(e), d.material(e), d.element(), d.gather(e, u)),
                                 Matrix3::Identity());
    });
  }

  OwnedVector SystemMatrices::centrifugal_load(const Rate &rate) const
  {
    const Discretization &d = assembly_.discretization();
    return assembly_.vector([&](const unsigned int e) -> Eigen::VectorXd {
      const Axis        &line  = axis(e);
      const double       omega = rate(body(e));
      const ElementNodes arms =
        across(line.direction) * (d.element_nodes(e).colwise() - line.point);
      const ElementNodes forces = omega * omega * arms * mass_coefficients(e);
      return Eigen::Map<const Eigen::VectorXd>(forces.data(), forces.size());
    });
  }

  OwnedVector SystemMatrices::apply_mass(const std::vector<double> &field) const
  {
    const Discretization &d = assembly_.discretization();
    return assembly_.vector([&](const unsigned int e) -> Eigen::VectorXd {
      const Eigen::VectorXd values = d.gather(e, field);
      const ElementNodes    forces =
        Eigen::Map<const ElementNodes>(values.data(), 3, values.size() / 3) * mass_coefficients(e);
      return Eigen::Map<const Eigen::VectorXd>(forces.data(), forces.size());
    });
  }

  std::vector<OwnedVector> SystemMatrices::near_kernel() const
  {
    const Discretization    &d = assembly_.discretization();
    std::vector<OwnedVector> kernel;
    for (const Discretization::Part &part : d.parts())
      {
        Vector3 centre = Vector3::Zero();
        for (unsigned int p = part.first_point; p < part.first_point + part.n_points; ++p)
          centre += d.points()[p] / part.n_points;
        for (const auto &motion : make_rigid_motions(d, part, centre))
          kernel.push_back(assembly_.restrict_field(motion));
      }
    return kernel;
  }

  SparseValues add_scaled(SparseValues a, const double factor, const SparseValues &b)
  {
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] += factor * b[i];
    return a;
  }
} // namespace vfife
