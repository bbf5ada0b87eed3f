// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/base/text/number_text.h>
#include <vfife/bearing/rolling_bearing.h>
#include <vfife/contact/law/hertz.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Slices along a roller. */
    constexpr unsigned int n_slices = 15;
    /** Depth over the element's diameter that stands for the largest load. */
    constexpr double largest_depth = 5e-3;

    /** Pressure that a contact of steel carries without lasting harm, ISO 76 [MPa]. */
    constexpr double static_pressure = 4000.;

    /** E* of elements and rings [MPa]. */
    double modulus_of(const RollingBearingData &data)
    {
      return contact_modulus(data.youngs_modulus,
                             data.poissons_ratio,
                             data.youngs_modulus,
                             data.poissons_ratio);
    }

    /** Diameter of an element over the pitch diameter, in the direction of contact. */
    double gamma_of(const RollingBearingData &data)
    {
      return data.diameter * std::cos(data.contact_angle) / data.pitch_diameter;
    }

    /** A ball in a groove: @p along is the curvature of both together around the axis. */
    HertzContact
    groove_contact(const RollingBearingData &data, const double conformity, const double along)
    {
      return {Vector2(2. / data.diameter - 1. / (conformity * data.diameter), along),
              modulus_of(data)};
    }
    HertzContact inner_contact(const RollingBearingData &data)
    {
      const double gamma = gamma_of(data);
      return groove_contact(data,
                            data.inner_conformity,
                            2. / data.diameter * (1. + gamma / (1. - gamma)));
    }

    /** Force over depth^1.5 of ball and raceways, inner and outer contact in series [N/mm^1.5]. */
    double ball_constant(const RollingBearingData &data)
    {
      const double       gamma = gamma_of(data);
      const HertzContact outer = groove_contact(data,
                                                data.outer_conformity,
                                                2. / data.diameter * (1. - gamma / (1. + gamma)));
      // Q = (depth/approach(1))^1.5.
      return std::pow(inner_contact(data).approach(1.) + outer.approach(1.), -1.5);
    }

    /** Palmgren: depth = 3.84e-5 Q^0.9/l^0.8 at each of the two contacts of a roller [N, mm]. */
    double roller_constant(const RollingBearingData &data)
    {
      return std::pow(std::pow(data.length, .8) / 7.68e-5, 1. / .9);
    }

    /** Rows of radial and axial way of a point of the inner ring at radius @p r, height @p z and
     * the angle with that cosine and sine: d + tilt x P. */
    Eigen::Matrix<double, 2, 5> way_of(const double r, const double z, const Vector2 &angle)
    {
      const double                c = angle[0], s = angle[1];
      Eigen::Matrix<double, 2, 5> way;
      way << c, s, 0., -z * s, z * c, 0., 0., 1., r * s, -r * c;
      return way;
    }

    /** Change of the rows with the angle. */
    Eigen::Matrix<double, 2, 5> change_of_way(const double r, const double z, const Vector2 &angle)
    {
      const double                c = angle[0], s = angle[1];
      Eigen::Matrix<double, 2, 5> way;
      way << -s, c, 0., -z * c, -z * s, 0., 0., 0., r * c, r * s;
      return way;
    }

    /** Cosine and sine of the angle of element @p j of @p n, the first one at @p first. */
    Vector2 angle_of(const unsigned int j, const unsigned int n, const double first)
    {
      const double psi = first + 2. * pi * j / n;
      return {std::cos(psi), std::sin(psi)};
    }
  } // namespace

  RollingBearing::RollingBearing(const RollingBearingData &data, const Matrix5 &damping)
    : BearingLaw(damping)
    , data_(data)
  {
    const bool balls = data.element == RollingElement::ball;
    if (data.n < 3)
      throw InputError("number of elements", "expected 3 or more, got " + std::to_string(data.n));
    if (!(data.diameter > 0 && data.pitch_diameter > data.diameter))
      throw InputError("pitch diameter",
                       "must be larger than the diameter of an element; both must be positive");
    if (data.n * data.diameter > pi * data.pitch_diameter)
      throw InputError(
        "number of elements",
        std::to_string(data.n) + " elements of diameter " + number_text(data.diameter) +
          " mm do not fit on pitch diameter " + number_text(data.pitch_diameter) + " mm (at most " +
          std::to_string(static_cast<unsigned int>(pi * data.pitch_diameter / data.diameter)) +
          ")");
    if (balls && !(data.inner_conformity > .5 && data.outer_conformity > .5))
      throw InputError(data.inner_conformity > .5 ? "outer conformity" : "inner conformity",
                       "must be above 0.5 (usually 0.515 to 0.53), because the radius of a groove "
                       "is larger than the radius of the ball");
    if (!balls && !(data.length > 0))
      throw InputError("element length", "is required for rollers");
    constant_ = balls ? ball_constant(data) : roller_constant(data);
    check_interference();
    find_preload();
    if (data.working_load.isZero(0.))
      linearized_ = evaluate(Vector5::Zero());
    else
      {
        Vector5 q;
        q << displacement_under(data.working_load), 0., 0.;
        linearized_ = evaluate(q);
        linearized_.load += linearized_.stiffness * q;
      }
  }

  void RollingBearing::check_interference() const
  {
    if (!(data_.clearance < 0))
      return;
    // The undisplaced bearing presses all elements alike.
    const double force = element_forces(Vector5::Zero()).front();
    // Of a line, p = sqrt(q E*/(pi R)), at the inner race.
    const double pressure = data_.element == RollingElement::ball
                              ? inner_contact(data_).largest_pressure(force)
                              : std::sqrt(force / data_.length * modulus_of(data_) /
                                          (pi * .5 * data_.diameter * (1. - gamma_of(data_))));
    if (!(pressure <= static_pressure))
      {
        std::ostringstream text;
        text << "an interference of " << -data_.clearance
             << " mm overloads the bearing: without load "
             << "its elements have a pressure of " << pressure << " MPa, more than the "
             << static_pressure << " MPa that ISO 76 allows on races";
        throw InputError("clearance", text.str());
      }
  }

  BearingResponse RollingBearing::of_balls(const Vector5             &q,
                                           const double               first,
                                           std::vector<double> *const forces) const
  {
    // Between the groove centres lies (A0 cos alpha - Pd/2, +-A0 sin alpha) without load; the ball
    // is pressed by what the distance is longer than A0 = (f_i + f_o - 1) D.
    const double A0 = (data_.inner_conformity + data_.outer_conformity - 1.) * data_.diameter;
    const double c = std::cos(data_.contact_angle), s = data_.sense * std::sin(data_.contact_angle);
    const double to_groove = (data_.inner_conformity - .5) * data_.diameter;
    BearingResponse response;
    for (unsigned int j = 0; j < data_.n; ++j)
      {
        const double  r = .5 * data_.pitch_diameter + to_groove * c, z = to_groove * s;
        const Vector2 angle                   = angle_of(j, data_.n, first);
        const Eigen::Matrix<double, 2, 5> way = way_of(r, z, angle);
        const Vector2 line   = Vector2(A0 * c - .5 * data_.clearance, A0 * s) + way * q;
        const double  length = line.norm(), depth = length - A0;
        const double  force = depth > 0 ? constant_ * std::pow(depth, 1.5) : 0.;
        if (forces != nullptr)
          forces->push_back(force);
        if (!(depth > 0))
          continue;
        const Vector2 direction = line / length;
        const Vector5 slope     = way.transpose() * direction;
        response.energy += .4 * force * depth;
        response.load -= force * slope;
        response.turn_slope += force * direction.dot(change_of_way(r, z, angle) * q);
        response.stiffness += 1.5 * force / depth * slope * slope.transpose() +
                              force / length * way.transpose() *
                                (Eigen::Matrix2d::Identity() - direction * direction.transpose()) *
                                way;
      }
    return response;
  }

  BearingResponse RollingBearing::of_rollers(const Vector5             &q,
                                             const double               first,
                                             std::vector<double> *const forces) const
  {
    // The line of a slice at t along the roller: normal (cos alpha, +-sin alpha), along it
    // (-+sin alpha, cos alpha).
    const double c = std::cos(data_.contact_angle), s = data_.sense * std::sin(data_.contact_angle);
    BearingResponse response;
    for (unsigned int j = 0; j < data_.n; ++j)
      {
        const Vector2 angle = angle_of(j, data_.n, first);
        double        sum   = 0;
        for (unsigned int k = 0; k < n_slices; ++k)
          {
            const double  t = data_.length * ((k + .5) / n_slices - .5);
            const double  r = .5 * data_.pitch_diameter - s * t, z = c * t;
            const Vector5 slope = way_of(r, z, angle).transpose() * Vector2(c, s);
            const double  depth = slope.dot(q) - .5 * data_.clearance * c;
            if (!(depth > 0))
              continue;
            const double force = constant_ / n_slices * std::pow(depth, 10. / 9.);
            sum += force;
            response.energy += 9. / 19. * force * depth;
            response.load -= force * slope;
            response.turn_slope += force * Vector2(c, s).dot(change_of_way(r, z, angle) * q);
            response.stiffness += 10. / 9. * force / depth * slope * slope.transpose();
          }
        if (forces != nullptr)
          forces->push_back(sum);
      }
    return response;
  }

  BearingResponse RollingBearing::respond(const Vector5             &q,
                                          const double               first,
                                          std::vector<double> *const forces) const
  {
    const Vector5 moved = q + offset_ * Vector5::Unit(2);
    return data_.element == RollingElement::ball ? of_balls(moved, first, forces)
                                                 : of_rollers(moved, first, forces);
  }

  double RollingBearing::cage_share() const
  {
    return data_.cage_rolls ? .5 * (1. - gamma_of(data_)) : 0.;
  }

  BearingResponse RollingBearing::evaluate(const Vector5 &displacement, const double turn) const
  {
    const double    share    = cage_share();
    BearingResponse response = respond(displacement, data_.cage_angle + share * turn, nullptr);
    response.turn_slope *= share;
    return response;
  }

  std::vector<double> RollingBearing::element_forces(const Vector5 &displacement) const
  {
    std::vector<double> forces;
    respond(displacement, data_.cage_angle, &forces);
    return forces;
  }

  BearingResponse RollingBearing::linearized() const
  {
    return linearized_;
  }

  double RollingBearing::curve_range() const
  {
    return 2e-3 * data_.diameter;
  }

  Matrix5 RollingBearing::stiffness_bound() const
  {
    // Every element at the largest depth, in its own direction and as if it carried along both.
    const double depth = largest_depth * data_.diameter;
    const double slope = data_.element == RollingElement::ball
                           ? 1.5 * constant_ * std::sqrt(depth)
                           : 10. / 9. * constant_ * std::pow(depth, 1. / 9.);
    Matrix5      bound = Matrix5::Zero();
    for (unsigned int j = 0; j < data_.n; ++j)
      {
        const Eigen::Matrix<double, 2, 5> way =
          way_of(.5 * (data_.pitch_diameter + data_.length + data_.diameter),
                 .5 * (data_.length + data_.diameter),
                 angle_of(j, data_.n, data_.cage_angle));
        bound += slope * way.transpose() * way;
      }
    return bound;
  }

  void RollingBearing::find_preload()
  {
    if (data_.preload == 0)
      return;
    if (data_.preload < 0 || data_.contact_angle == 0)
      throw InputError("preload", "requires a contact angle above 0, and must not be negative");
    // The axial force grows with the way in its sense: bisection, up to depths that no bearing has.
    const auto force_at = [&](const double way) {
      offset_ = data_.sense * way;
      return std::abs(respond(Vector5::Zero(), data_.cage_angle, nullptr).load[2]);
    };
    double low = 0, high = .2 * data_.diameter;
    if (force_at(high) < data_.preload)
      throw InputError("preload",
                       "exceeds the capacity of the bearing (at most " +
                         figure_text(force_at(high)) + " N)");
    while (high - low > 1e-14 * data_.diameter)
      {
        const double middle                             = .5 * (low + high);
        (force_at(middle) < data_.preload ? low : high) = middle;
        if (middle == low && middle == high)
          break;
      }
    offset_ = data_.sense * .5 * (low + high);
  }

  Vector3 RollingBearing::displacement_under(const Vector3 &force) const
  {
    // The least of energy - force . way, by Newton's steps with a term mu that is as large as the
    // energy asks for: within a clearance there is no stiffness at all.
    const auto at = [this](const Vector3 &way) {
      Vector5 q;
      q << way, 0., 0.;
      return evaluate(q);
    };
    Vector3         way  = Vector3::Zero();
    BearingResponse here = at(way);
    double          mu = stiffness_bound()(0, 0), potential = here.energy;
    for (unsigned int step = 0; step < 500; ++step)
      {
        const Vector3 rest = force + here.load.head<3>();
        if (rest.norm() <= 1e-9 * force.norm())
          return way;
        const Matrix3 K       = here.stiffness.topLeftCorner<3, 3>() + mu * Matrix3::Identity();
        const Vector3 next    = way + K.ldlt().solve(rest);
        const auto    there   = at(next);
        const double  lowered = there.energy - force.dot(next);
        if (!(next.norm() < .2 * data_.diameter))
          break;
        // Near the end round-off hides the gain of a step that still brings forces nearer.
        if (lowered <= potential + 1e-14 * std::abs(potential))
          {
            way       = next;
            here      = there;
            potential = lowered;
            mu *= .2;
          }
        else
          mu = 4. * mu + 1e-12 * stiffness_bound()(0, 0);
      }
    throw InputError("working load",
                     "the bearing has no equilibrium under this load. Choose a direction that the "
                     "bearing supports, or a smaller load");
  }
} // namespace vfife
