// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/gear/spiral_bevel/local_contact.h>

#include <cmath>

namespace vfife
{
  LengthAndHeight::LengthAndHeight(const Blank   &blank,
                                   const Vector3 &position,
                                   const Vector3 &normal)
  {
    // directions of L and h at this point, in the frame of the body
    const double  c = std::cos(blank.pitch_angle), s = std::sin(blank.pitch_angle);
    const Vector3 radial = Vector3(position[0], position[1], 0.).normalized();
    const Vector3 length = s * radial + c * Vector3::UnitZ();
    const Vector3 height = c * radial - s * Vector3::UnitZ();
    // the tangent with h = const, and the one across it; signs towards heel and tip
    const Vector3 constant = normal.cross(height).normalized();
    lengthwise             = constant.dot(length) > 0. ? constant : Vector3(-constant);
    const Vector3 across   = normal.cross(lengthwise);
    upward                 = across.dot(height) > 0. ? across : Vector3(-across);
  }

  double LengthAndHeight::angle(const Vector3 &direction) const
  {
    return std::atan(direction.dot(upward) / direction.dot(lengthwise));
  }

  LineContact::LineContact(const Vector3 &position,
                           const Vector3 &normal,
                           const Matrix3 &gear_curvature_tensor,
                           const Vector3 &pinion_axis,
                           const Vector3 &gear_axis,
                           const double   speed_ratio)
    : position(position)
    , normal(normal)
    , gear_curvature_tensor(gear_curvature_tensor)
  {
    // f = n . (W x P) is the normal speed of the pinion's points relative to the gear flank
    const Vector3 W = pinion_axis + speed_ratio * gear_axis;
    sliding         = W.cross(position);
    // along the flank the normal out of the gear changes by + K du
    const Vector3 gradient = gear_curvature_tensor * sliding + normal.cross(W);
    // with the gear flank turning at - ratio, and seen from a point fixed to the pinion
    const double rate = -speed_ratio * (gear_axis.cross(normal).dot(sliding) +
                                        normal.dot(W.cross(gear_axis.cross(position)))) +
                        gradient.dot(sliding);
    // Contact along the line gradient . x = 0; across it the envelope bends by |g|^2 / rate, and
    // the line moves by rate / |g| (doc/theory/gear.md, Proposed pairs).
    across    = gradient.normalized();
    curvature = gradient.squaredNorm() / rate;
    speed     = rate / gradient.norm();
    arm       = std::abs(position.cross(normal).dot(gear_axis));
  }

  Matrix3 pinion_curvature_tensor(const LineContact &contact, const LocalContactDesign &design)
  {
    if (!(contact.curvature > 0.))
      throw InputError("the pinion flank conjugate to the gear's would be undercut at the mean "
                       "contact point");
    // The gap along the normal that the lag asks for, per distance across the line; the flanks
    // touch a little off the line, in the proportion of both curvatures.
    const double asked = design.lag_curvature * contact.arm / (contact.speed * contact.speed);
    if (!(asked < contact.curvature))
      throw InputError("the requested transmission error amplitude is not attainable (at most " +
                       figure_text(100. * contact.curvature / asked) + " % of it)");
    const double c     = asked * contact.curvature / (contact.curvature - asked);
    const double alpha = contact.curvature + c;
    const double pace  = -contact.speed * contact.curvature / alpha; // across, on the pinion

    // the path on the gear is the one on the pinion plus the sliding
    const double along =
      (pace + contact.across.dot(contact.sliding)) / contact.across.dot(design.path);
    const Vector3 path = (along * design.path - contact.sliding).normalized();
    const Vector3 side = contact.normal.cross(path);

    // (alpha a a^T + mu side side^T) path is along a, as the path's condition asks; mu makes the
    // smaller eigenvalue k
    const double k = design.small_curvature, share = contact.across.dot(path);
    const double denominator = alpha * share * share - k;
    if (!(denominator > 0.))
      throw InputError("no pinion flank has this path of contact and length of the ellipse. Choose "
                       "a path nearer to the lengthwise direction or a longer ellipse");
    const double mu = k * (alpha - k) / denominator;
    return alpha * contact.across * contact.across.transpose() + mu * side * side.transpose() -
           contact.gear_curvature_tensor;
  }
} // namespace vfife
