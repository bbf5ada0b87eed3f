// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/system/load_forces.h>
#include <vfife/fem/system/rigid_motions.h>
#include <vfife/fem/system/system_matrices.h>

#include <algorithm>
#include <map>

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

    /** Projects on the plane across the axis. */
    Matrix3 across(const Vector3 &a)
    {
      return Matrix3::Identity() - a * a.transpose();
    }
  } // namespace

  SystemMatrices::SystemMatrices(const FemSystem    &system,
                                 const MassKind      mass,
                                 const StrainMeasure strain)
    : system_(system)
    , mass_(mass)
    , strain_(strain)
  {
  }

  Eigen::MatrixXd SystemMatrices::mass_coefficients(const unsigned int e) const
  {
    const FemSpace &d = system_.space();
    return compute_mass_coefficients(d.element_nodes(e), d.material(e).density, mass_);
  }

  unsigned int SystemMatrices::body(const unsigned int e) const
  {
    return system_.space().part_of_element(e).body;
  }

  const Axis &SystemMatrices::axis(const unsigned int e) const
  {
    return system_.space().model().bodies[body(e)].axis;
  }

  FemMatrix SystemMatrices::stiffness(const Rate &rate) const
  {
    const FemSpace &d       = system_.space();
    FemMatrix       K       = system_.matrix([&](const unsigned int e) {
      return compute_fem_stiffness(d.element_nodes(e), d.material(e), d.element());
    });
    const auto      springs = find_springs(d);
    if (!springs.empty())
      K = add_scaled(std::move(K), 1., system_.point_matrix(springs));
    return add_rings(std::move(K), rate);
  }

  FemMatrix SystemMatrices::add_rings(FemMatrix K, const Rate &rate) const
  {
    const BearingRings &rings = system_.rings();
    return rings.list().empty()
             ? K
             : add_scaled(std::move(K), 1., system_.ring_matrix(rings.stiffness(rate)));
  }

  FemMatrix SystemMatrices::mass() const
  {
    return system_.matrix([&](const unsigned int e) {
      return expand_coefficients(mass_coefficients(e), Matrix3::Identity());
    });
  }

  FemMatrix SystemMatrices::spin_mass(const Rate &rate) const
  {
    return system_.matrix([&](const unsigned int e) {
      // Omega^2 S, S = m_ab (1 - a a^T): the centrifugal force on the moved mass
      const double omega = rate(body(e));
      return expand_coefficients(omega * omega * mass_coefficients(e), across(axis(e).direction));
    });
  }

  FemMatrix SystemMatrices::gyroscopic(const Rate &rate) const
  {
    return system_.matrix([&](const unsigned int e) {
      // Omega G, G = m_ab [a]x: half of the Coriolis force 2 Omega a x u'
      return expand_coefficients(rate(body(e)) * mass_coefficients(e),
                                 cross_matrix(axis(e).direction));
    });
  }

  SystemMatrices::PointMatrices SystemMatrices::hub_curvature(const std::vector<double> &u,
                                                              const Rate                &rate) const
  {
    const FemSpace &d = system_.space();
    // The force F of the constraint stays radial. When the point moves by u_t along the circle of
    // radius r, F turns by u_t/r, which is a force F/r u_t along the tangent: a stiffness of -F/r.
    std::map<unsigned int, Vector3> reactions;
    for (const Constraint &constraint : d.model().constraints)
      if (const FemSpace::Part *part = d.find_part(constraint.body))
        if (constraint.kind == ConstraintKind::free_rotation ||
            constraint.kind == ConstraintKind::rigid_hub)
          for (const unsigned int p : d.points_of(*part, constraint.nodes))
            reactions.emplace(p, Vector3::Zero());
    // At the border of a sector a point gets part of its force from the elements at its images, and
    // the curvature of the image turns up in the row of its original.
    for (const auto &image : d.images())
      if (reactions.count(image.second) != 0)
        reactions.emplace(image.first, Vector3::Zero());

    // Force of the constraint on a point: internal forces minus centrifugal ones.
    for (unsigned int e = 0; e < d.n_elements(); ++e)
      {
        const unsigned int *points = d.element_points(e);
        const auto          is_hub = [&](const unsigned int p) { return reactions.count(p) != 0; };
        if (std::none_of(points, points + d.points_per_element(), is_hub))
          continue;
        // The load acts on the moved mass, as in the equilibrium.
        const Eigen::VectorXd v      = d.gather(e, u);
        const Eigen::VectorXd forces = compute_element_state(d.stress_free_nodes(e),
                                                             d.material(e),
                                                             d.element(),
                                                             strain_,
                                                             d.gather_from_stress_free(e, u),
                                                             false)
                                         .forces -
                                       centrifugal_force(e, v, rate);
        for (unsigned int a = 0; a < d.points_per_element(); ++a)
          if (is_hub(points[a]))
            reactions[points[a]] += forces.segment<3>(3 * a);
      }

    // What hangs moves with its masters, and so does the force on it.
    for (const auto &[point, masters] : d.hanging())
      if (const auto hanging = reactions.find(point); hanging != reactions.end())
        {
          for (const auto &[master, weight] : masters)
            if (const auto found = reactions.find(master); found != reactions.end())
              found->second += weight * hanging->second;
          reactions.erase(hanging);
        }
    PointMatrices curvatures;
    for (const auto &reaction : reactions)
      {
        const Axis   &line   = d.model().bodies[d.part_of_point(reaction.first).body].axis;
        const Vector3 arm    = across(line.direction) * (d.points()[reaction.first] - line.point);
        const Vector3 radial = arm.normalized(), tangent = line.direction.cross(radial);
        if (arm.norm() > 0)
          curvatures.emplace_back(reaction.first,
                                  -reaction.second.dot(radial) / arm.norm() * tangent *
                                    tangent.transpose());
      }
    return curvatures;
  }

  Eigen::VectorXd SystemMatrices::centrifugal_force(const unsigned int     e,
                                                    const Eigen::VectorXd &u,
                                                    const Rate            &rate) const
  {
    const FemSpace &d     = system_.space();
    const Axis     &line  = axis(e);
    const double    omega = rate(body(e));
    // Omega^2 m_ab (1 - a a^T) (X + u)_b, the columns of X being the element's points.
    const ElementNodes moved =
      d.element_nodes(e) + Eigen::Map<const ElementNodes>(u.data(), 3, u.size() / 3);
    const ElementNodes forces = omega * omega * across(line.direction) *
                                (moved.colwise() - line.point) * mass_coefficients(e);
    return Eigen::Map<const Eigen::VectorXd>(forces.data(), forces.size());
  }

  SystemMatrices::PointMatrices SystemMatrices::point_stiffnesses(const std::vector<double> &u,
                                                                  const Rate &rate) const
  {
    PointMatrices       points = find_springs(system_.space());
    const PointMatrices hub    = hub_curvature(u, rate);
    points.insert(points.end(), hub.begin(), hub.end());
    return points;
  }

  FemMatrix SystemMatrices::spinning_stiffness(const std::vector<double> &u, const Rate &rate) const
  {
    const FemSpace &d = system_.space();
    FemMatrix       K = system_.matrix([&](const unsigned int e) -> Eigen::MatrixXd {
      const double omega = rate(body(e));
      return compute_element_state(d.stress_free_nodes(e),
                                   d.material(e),
                                   d.element(),
                                   strain_,
                                   d.gather_from_stress_free(e, u),
                                   true)
               .tangent -
             expand_coefficients(omega * omega * mass_coefficients(e), across(axis(e).direction));
    });
    return add_rings(add_scaled(std::move(K), 1., system_.point_matrix(point_stiffnesses(u, rate))),
                     rate);
  }

  OwnedVector SystemMatrices::spinning_residual(const std::vector<double> &u,
                                                const Rate                &rate,
                                                const bool                 softening) const
  {
    const FemSpace     &d        = system_.space();
    OwnedVector         residual = system_.vector([&](const unsigned int e) -> Eigen::VectorXd {
      const Eigen::VectorXd v = d.gather(e, u);
      return centrifugal_force(e, softening ? v : Eigen::VectorXd::Zero(v.size()), rate) -
             compute_element_state(d.stress_free_nodes(e),
                                   d.material(e),
                                   d.element(),
                                   strain_,
                                   d.gather_from_stress_free(e, u),
                                   false)
               .forces;
    });
    std::vector<double> held(3 * static_cast<std::size_t>(d.n_points()), 0.);
    for (const auto &point : point_stiffnesses(u, rate))
      Eigen::Map<Vector3>(held.data() + 3 * std::size_t(point.first)) -=
        point.second * Eigen::Map<const Vector3>(u.data() + 3 * std::size_t(point.first));
    const BearingRings &rings = system_.rings();
    rings.add_forces(-rings.stiffness(rate) * rings.displacement(u), held);
    const OwnedVector springs = system_.restrict_forces(held);
    return add_scaled(std::move(residual), 1., springs);
  }

  Eigen::VectorXd SystemMatrices::mass_forces_of(const unsigned int         e,
                                                 const std::vector<double> &field) const
  {
    const Eigen::VectorXd values = system_.space().gather(e, field);
    const ElementNodes    forces =
      Eigen::Map<const ElementNodes>(values.data(), 3, values.size() / 3) * mass_coefficients(e);
    return Eigen::Map<const Eigen::VectorXd>(forces.data(), forces.size());
  }

  OwnedVector SystemMatrices::apply_mass(const std::vector<double> &field) const
  {
    return system_.vector([&](const unsigned int e) { return mass_forces_of(e, field); });
  }

  std::vector<double> SystemMatrices::mass_forces(const std::vector<double> &field) const
  {
    const FemSpace     &d = system_.space();
    std::vector<double> forces(field.size(), 0.);
    for (unsigned int e = 0; e < d.n_elements(); ++e)
      {
        const Eigen::VectorXd own    = mass_forces_of(e, field);
        const unsigned int   *points = d.element_points(e);
        for (Eigen::Index i = 0; i < own.size(); ++i)
          forces[3 * static_cast<std::size_t>(points[i / 3]) + i % 3] += own[i];
      }
    return forces;
  }

  std::vector<OwnedVector> SystemMatrices::near_kernel() const
  {
    const FemSpace          &d = system_.space();
    std::vector<OwnedVector> kernel;
    for (const FemSpace::Part &part : d.parts())
      {
        Vector3 centre = Vector3::Zero();
        for (unsigned int p = part.first_point; p < part.first_point + part.n_points; ++p)
          centre += d.points()[p] / part.n_points;
        for (const auto &motion : make_rigid_motions(d, part, centre))
          // The coarse levels of multigrid have to hold what costs no strain energy.
          kernel.push_back(system_.restrict_field(motion));
      }
    return kernel;
  }

  SystemMatrices::Rate constant_rate(const double rate)
  {
    return [rate](unsigned int) { return rate; };
  }
} // namespace vfife
