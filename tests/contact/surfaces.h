// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_contact_surfaces_h
#define vfife_tests_contact_surfaces_h

#include <vfife/base/facet_surface.h>
#include <vfife/contact/contact.h>
#include <vfife/contact/surface/facet_quadrature.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

/** Surfaces with known geometry for the contact tests, and their motion. */
namespace test_surfaces
{
  using namespace vfife;

  /** A structured grid of nu x nv facets: point(u, v) and unit outward normal(u, v), u and v in
   * [0,1]. */
  inline FacetSurface grid(const unsigned int                            nu,
                           const unsigned int                            nv,
                           const std::function<Vector3(double, double)> &point,
                           const std::function<Vector3(double, double)> &normal)
  {
    FacetSurface surface;
    surface.name = "grid";
    for (unsigned int j = 0; j <= nv; ++j)
      for (unsigned int i = 0; i <= nu; ++i)
        {
          surface.nodes.push_back(static_cast<unsigned int>(surface.nodes.size()));
          surface.positions.push_back(point(i / double(nu), j / double(nv)));
          surface.normals.push_back(normal(i / double(nu), j / double(nv)));
        }
    for (unsigned int j = 0; j < nv; ++j)
      for (unsigned int i = 0; i < nu; ++i)
        {
          const unsigned int a = j * (nu + 1) + i;
          surface.facets.push_back({{a, a + 1, a + nu + 2, a + nu + 1}});
          surface.group.push_back(0);
        }
    find_neighbours(surface);
    return surface;
  }

  /** Starts every facet at a random corner: the walk has to cope with any orientation of
   * neighbours. */
  inline void turn_facets(FacetSurface &surface, std::mt19937 &random)
  {
    for (auto &facet : surface.facets)
      std::rotate(facet.begin(), facet.begin() + random() % 4, facet.end());
    find_neighbours(surface);
  }

  /** Plane z = height, [x0,x1] x [y0,y1], normal +z or (down) -z. */
  inline FacetSurface plane(unsigned int nx,
                            unsigned int ny,
                            double       x0,
                            double       x1,
                            double       y0,
                            double       y1,
                            double       height,
                            bool         down = false)
  {
    return grid(
      nx,
      ny,
      [=](double u, double v) {
        if (down)
          std::swap(u, v);
        return Vector3(x0 + u * (x1 - x0), y0 + v * (y1 - y0), height);
      },
      [=](double, double) { return Vector3(0., 0., down ? -1. : 1.); });
  }

  /** Tabulates the offsets of the facets to the sphere |x - centre| = radius with @p n
   * Gauss-Lobatto points, or to the cylinder of that radius about @p axis (a unit vector). */
  inline void add_sphere_offsets(FacetSurface      &surface,
                                 const Vector3     &centre,
                                 const double       radius,
                                 const unsigned int n,
                                 const Vector3     &axis = Vector3::Zero())
  {
    const auto points     = gauss_lobatto_points(n);
    surface.offset_points = n;
    surface.offset_row.clear();
    surface.offsets.clear();
    for (unsigned int f = 0; f < surface.facets.size(); ++f)
      {
        surface.offset_row.push_back(f);
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int i = 0; i < n; ++i)
            {
              const auto N = bilinear_weights(points[i], points[j]);
              Vector3    y = Vector3::Zero(), m = Vector3::Zero();
              for (unsigned int k = 0; k < 4; ++k)
                {
                  y += N[k] * surface.positions[surface.facets[f][k]];
                  m += N[k] * surface.normals[surface.facets[f][k]];
                }
              m.normalize();
              // |d + delta m|^2 = R^2, the root next to zero (m points out of the sphere or into
              // it)
              const Vector3 d = y - centre - axis * axis.dot(y - centre);
              m -= axis * axis.dot(m);
              const double a = m.squaredNorm(), b = d.dot(m), c = d.squaredNorm() - radius * radius;
              surface.offsets.push_back(b > 0. ? -c / (b + std::sqrt(b * b - a * c))
                                               : -c / (b - std::sqrt(b * b - a * c)));
            }
      }
  }

  /** A patch about the +z pole of a sphere around the origin, tan of half angle @p width, n x n
   * facets. */
  inline FacetSurface sphere_patch(const double       radius,
                                   const double       width,
                                   const unsigned int n,
                                   const bool         offsets = true)
  {
    const auto direction = [=](double u, double v) {
      return Vector3(width * (2. * u - 1.), width * (2. * v - 1.), 1.).normalized();
    };
    FacetSurface surface = grid(
      n, n, [=](double u, double v) { return Vector3(radius * direction(u, v)); }, direction);
    if (offsets)
      add_sphere_offsets(surface, Vector3::Zero(), radius, 5);
    return surface;
  }

  /** The same patch looking down (about the -z pole). */
  inline FacetSurface
  sphere_patch_down(const double radius, const double width, const unsigned int n)
  {
    const auto direction = [=](double u, double v) {
      return Vector3(width * (2. * v - 1.), width * (2. * u - 1.), -1.).normalized();
    };
    FacetSurface surface = grid(
      n, n, [=](double u, double v) { return Vector3(radius * direction(u, v)); }, direction);
    add_sphere_offsets(surface, Vector3::Zero(), radius, 5);
    return surface;
  }

  /** Positions, velocities and forces of a surface. */
  struct MovingSurface
  {
    explicit MovingSurface(const FacetSurface &surface_)
      : surface(surface_)
      , positions(3 * surface_.positions.size())
      , velocities(positions.size(), 0.)
      , forces(positions.size(), 0.)
    {
      place({});
    }

    /** Moves the undeformed surface rigidly. */
    void place(const RigidMotion &motion)
    {
      body = motion;
      for (unsigned int n = 0; n < surface.positions.size(); ++n)
        at(positions, n) = motion(surface.positions[n]);
    }

    static Eigen::Map<Vector3> at(std::vector<double> &values, const unsigned int n)
    {
      return Eigen::Map<Vector3>(values.data() + 3 * n);
    }

    SurfaceMotion motion() const
    {
      return {positions.data(), velocities.data(), body};
    }

    void clear_forces()
    {
      std::fill(forces.begin(), forces.end(), 0.);
    }

    Vector3 force()
    {
      Vector3 sum = Vector3::Zero();
      for (unsigned int n = 0; n < surface.positions.size(); ++n)
        sum += at(forces, n);
      return sum;
    }

    Vector3 moment()
    {
      Vector3 sum = Vector3::Zero();
      for (unsigned int n = 0; n < surface.positions.size(); ++n)
        sum += at(positions, n).cross(at(forces, n));
      return sum;
    }

    FacetSurface        surface;
    std::vector<double> positions, velocities, forces;
    RigidMotion         body;
  };

  inline void
  add_forces(Contact &contact, MovingSurface &slave, MovingSurface &master, const double dt = 1e-7)
  {
    contact.add_forces(
      slave.motion(), master.motion(), dt, slave.forces.data(), master.forces.data());
  }

  /** A penalty [N/mm^3] that is given, not from the step. */
  inline ContactOptions with_penalty(const double penalty)
  {
    ContactOptions options;
    options.penalty.value = penalty;
    return options;
  }

  /**
   * The slave goes a closed path, an angle from 0 to 2 pi, in 8000 positions: largest difference of
   * the work of the contact's forces (trapezoidal rule) and the change of its energy, over the
   * largest energy. Candidates are found anew every so many positions.
   */
  inline double find_energy_residual(const FacetSurface                             &slave_surface,
                                     const FacetSurface                             &master_surface,
                                     const ContactOptions                           &options,
                                     const std::function<RigidMotion(double angle)> &path,
                                     const unsigned int                              search_every)
  {
    MovingSurface       slave(slave_surface), master(master_surface);
    Contact             contact(slave.surface, master.surface, options);
    const unsigned int  n_positions = 8000;
    double              work = 0., most = 0., residual = 0., first = 0.;
    std::vector<double> positions, forces;
    for (unsigned int i = 0; i <= n_positions; ++i)
      {
        slave.place(path(2. * pi * i / n_positions));
        if (i % search_every == 0)
          contact.find_candidates(slave.body, master.body, 3.);
        slave.clear_forces();
        add_forces(contact, slave, master);
        const double energy = contact.results().at(0).energy;
        // force and motion of each node
        for (unsigned int k = 0; i > 0 && k < slave.forces.size(); ++k)
          work += 0.5 * (slave.forces[k] + forces[k]) * (slave.positions[k] - positions[k]);
        if (i == 0)
          first = energy;
        raise_to(most, energy);
        raise_to(residual, std::abs(work + energy - first));
        positions = slave.positions;
        forces    = slave.forces;
      }
    return residual / most;
  }
} // namespace test_surfaces

#endif
