// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/types.h>
#include <vfife/dynamics/motion/prescribed_place.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  namespace
  {
    constexpr unsigned int largest_iterations = 50;

    /** As many columns as equations, at most three: no allocation. */
    using Columns = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
    using Square  = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
    using Values  = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1>;

    Vector3 flattened(const Axis &axis, const Vector3 &place)
    {
      const Vector3 arm = place - axis.point;
      return arm - axis.direction.dot(arm) * axis.direction;
    }

    /** One equation c(x) = normal . (x - origin) - offset = 0, or c(x) = |flat x| - offset. */
    struct PlaceEquation
    {
      bool    is_cylinder = false;
      Vector3 normal = Vector3::Zero(), origin = Vector3::Zero();
      double  offset = 0;

      PlaceEquation() = default;

      PlaceEquation(const HeldDirection &held,
                    const Axis          &axis,
                    const Vector3       &start,
                    const double         value)
        : is_cylinder(held.coordinate == HeldCoordinate::radius)
        , normal(held.direction)
        , origin(start)
        , offset(value)
      {
        if (held.coordinate == HeldCoordinate::along)
          return;
        const Vector3 flat   = flattened(axis, start);
        const double  radius = flat.norm();
        origin               = axis.point;
        if (is_cylinder)
          {
            offset = radius + value;
            return;
          }
        // The half plane of the ray: its normal is the tangent there.
        const double angle = value / radius;
        normal             = std::cos(angle) * held.direction - std::sin(angle) / radius * flat;
        offset             = 0;
      }

      double residual(const Axis &axis, const Vector3 &x) const
      {
        return is_cylinder ? flattened(axis, x).norm() - offset : normal.dot(x - origin) - offset;
      }

      Vector3 gradient(const Axis &axis, const Vector3 &x) const
      {
        return is_cylinder ? Vector3(flattened(axis, x).normalized()) : normal;
      }
    };
  } // namespace

  namespace
  {
    /**
     * What a prescribed angle turns the node at @p old beyond @p resolved_turn, about the axis. The
     * direction of theta at the old place leads to the ray by a way of tan(turn): for a turn that a
     * step resolves that is where the constraint's force acts, at a right angle it leads nowhere,
     * and beyond to the other side of the axis. A load step of a relaxation may turn so far.
     */
    Matrix3 find_jump(const Axis                  &axis,
                      const Vector3               &start,
                      const Vector3               &old,
                      const HeldDirections        &held,
                      const std::array<double, 3> &values)
    {
      constexpr double resolved_turn = 0.1; // [rad]
      for (std::size_t k = 0; k < held.size(); ++k)
        if (held[k].coordinate == HeldCoordinate::angle)
          {
            const Vector3 flat = flattened(axis, start), now = flattened(axis, old);
            const double  angle = values[k] / flat.norm();
            const Vector3 ray =
              std::cos(angle) * flat.normalized() + std::sin(angle) * held[k].direction;
            const double turn = std::atan2(axis.direction.dot(now.cross(ray)), now.dot(ray));
            if (std::abs(turn) > resolved_turn)
              return rotation_about(axis.direction, turn - std::copysign(resolved_turn, turn));
          }
      return Matrix3::Identity();
    }
  } // namespace

  Vector3 place_prescribed(const Axis                  &axis,
                           const Vector3               &start,
                           const Vector3               &old_place,
                           const Vector3               &free_place,
                           const HeldDirections        &held,
                           const std::array<double, 3> &values)
  {
    // What no step resolves of a turn is one of the whole motion, from the old place to x*.
    const Matrix3 jump     = find_jump(axis, start, old_place, held, values);
    const bool    is_small = jump == Matrix3::Identity();
    const auto    turned   = [&](const Vector3 &x) {
      return is_small ? x : Vector3(axis.point + jump * (x - axis.point));
    };
    const Vector3 old = turned(old_place), free = turned(free_place);
    // What is not finite stays so, for the guards of the run to tell.
    if (!free.allFinite())
      return free;
    // x = free + D mu, D the directions at the old place: Newton's method for mu, one step where
    // all equations are planes.
    //
    //   e_theta ^
    //           |       o<-----o x*    a radius R alone: back along the old e_r onto its circle, so
    //    across |     / R              that the way across, which is the turn, stays as it is
    //           +---/------> e_r       (e_r, e_theta at the place before the step)
    const unsigned int           n = held.size();
    Columns                      directions(3, n);
    std::array<PlaceEquation, 3> equations;
    for (unsigned int k = 0; k < n; ++k)
      {
        directions.col(k) = present_direction(held[k], axis, old);
        equations[k]      = PlaceEquation(held[k], axis, start, values[k]);
      }
    const double size = (free - axis.point).norm() + (start - axis.point).norm();
    Vector3      x    = free;
    for (unsigned int i = 0;; ++i)
      {
        Values residual(n);
        Square jacobian(n, n);
        double worst = 0;
        for (unsigned int k = 0; k < n; ++k)
          {
            residual[k]     = equations[k].residual(axis, x);
            worst           = std::max(worst, std::abs(residual[k]));
            jacobian.row(k) = equations[k].gradient(axis, x).transpose() * directions;
          }
        // Round-off of the residuals, not of the place: where directions are nearly parallel the
        // place moves by more.
        if (i > 0 && worst <= 8. * std::numeric_limits<double>::epsilon() * size)
          break;
        if (i == largest_iterations || !x.allFinite())
          return Vector3::Constant(not_known);
        x -= directions * jacobian.fullPivLu().solve(residual);
      }
    // Along a coordinate axis to the last digit, so that a held node does not tremble.
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int c = 0; c < 3; ++c)
        if (held[k].coordinate == HeldCoordinate::along && held[k].direction[c] == 1)
          x[c] = start[c] + values[k];
    return x;
  }

  Vector3
  project_free(const Axis &axis, const Vector3 &x, const HeldDirections &held, const Vector3 &f)
  {
    // Directions of the present place, made orthonormal one after the other.
    Vector3            rest = f;
    Columns            orthonormal(3, held.size());
    const unsigned int n = held.size();
    for (unsigned int k = 0; k < n; ++k)
      {
        Vector3 direction = present_direction(held[k], axis, x);
        for (unsigned int j = 0; j < k; ++j)
          direction -= orthonormal.col(j).dot(direction) * orthonormal.col(j);
        orthonormal.col(k) = direction.normalized();
        rest -= orthonormal.col(k).dot(rest) * orthonormal.col(k);
      }
    return n == 3 ? Vector3(Vector3::Zero()) : rest;
  }
} // namespace vfife
