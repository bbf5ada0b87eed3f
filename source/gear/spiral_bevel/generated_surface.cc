// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/spiral_bevel/generated_surface.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** @p v turned about z by the angle of cosine @p c and sine @p s. */
    Vector3 rotate_about_z(const double c, const double s, const Vector3 &v)
    {
      return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
    }

    /** z x v: the velocity of v that turns about z at unit rate. */
    Vector3 z_cross(const Vector3 &v)
    {
      return {-v[1], v[0], 0.};
    }
  } // namespace

  struct GeneratedSurface::Cutter
  {
    Vector3 center, center_phi; ///< of the circle of blade tips, from the machine centre [mm]
    Matrix3 tilt, tilt_phi;     ///< turns vectors of the upright cutter
    double  ratio, ratio_phi;   ///< of roll, and its rate
    double  cos_blank, sin_blank;

    /** A vector of the upright cutter (and its derivative by t) in the machine. */
    Moving carry(const Vector3 &v, const Vector3 &v_t) const;
  };

  GeneratedSurface::Moving GeneratedSurface::Cutter::carry(const Vector3 &v,
                                                           const Vector3 &v_t) const
  {
    return {tilt * v, tilt * v_t, tilt_phi * v};
  }

  GeneratedSurface::GeneratedSurface(const MachineSettings &settings)
    : settings_(settings)
    , sin_blade_(std::sin(settings.blade_angle))
    , cos_blade_(std::cos(settings.blade_angle))
    , sin_root_(std::sin(settings.machine_root_angle))
    , cos_root_(std::cos(settings.machine_root_angle))
    , apex_(settings.apex())
  {
    if (!(settings.ratio_of_roll > 0.))
      throw InputError("a flank cannot be generated without a ratio of roll");
    if (!(settings.point_radius > 0.))
      throw InputError("a flank cannot be generated without a point radius");
  }

  const MachineSettings &GeneratedSurface::settings() const
  {
    return settings_;
  }

  Vector3 GeneratedSurface::into_blank_frame(const Vector3 &v) const
  {
    return {sin_root_ * v[0] + cos_root_ * v[2], -v[1], cos_root_ * v[0] - sin_root_ * v[2]};
  }

  // Machine frame, seen along the cradle axis z; the upright cutter's axis is z as well.
  //
  //      y ^         C  cutter centre; round it the blade tips, radius r_p, at the angles t
  //        |      . '
  //        |  S . '        the blank's axis a lies in the plane of x and z, its apex at O
  //        |  . '  q + phi
  //        +-----------------> x, along the root generatrix
  GeneratedSurface::Cutter GeneratedSurface::cutter_at(const double phi) const
  {
    // Centre of the blade tips' circle, carried round the cradle axis:
    //   C = S (cos(q + phi), sin(q + phi), 0),   dC/dphi = z x C
    const double Q = settings_.cradle_angle + phi, S = settings_.radial_distance;
    Cutter       cutter;
    cutter.center     = {S * std::cos(Q), S * std::sin(Q), 0.};
    cutter.center_phi = z_cross(cutter.center);
    // The direction of the tilt turns with the cradle: dT/dphi v = z x T v - T (z x v).
    const Vector3 direction =
      rotate_about_z(std::cos(phi), std::sin(phi), settings_.tilt_direction());
    cutter.tilt = rotation_about(direction, settings_.cutter_tilt);
    for (unsigned int d = 0; d < 3; ++d)
      cutter.tilt_phi.col(d) =
        z_cross(cutter.tilt.col(d)) - cutter.tilt * z_cross(Vector3::Unit(d));
    // The blank turns by psi(phi); psi' is the ratio of roll at this position.
    cutter.ratio     = settings_.roll_rate(phi);
    cutter.ratio_phi = settings_.roll_acceleration(phi);
    const double psi = settings_.blank_rotation(phi);
    cutter.cos_blank = std::cos(psi);
    cutter.sin_blank = std::sin(psi);
    return cutter;
  }

  GeneratedSurface::Moving GeneratedSurface::relative_to_apex(const Cutter &cutter,
                                                              const Moving &from_center) const
  {
    return Moving{cutter.center - apex_, Vector3::Zero(), cutter.center_phi} + from_center;
  }

  GeneratedSurface::Moving GeneratedSurface::into_body(const Cutter &cutter, const Moving &v) const
  {
    // X = Rz(psi) R v,   dX/dphi = Rz(psi) R dv/dphi + psi' z x X
    const auto turned = [&](const Vector3 &x) {
      return rotate_about_z(cutter.cos_blank, cutter.sin_blank, into_blank_frame(x));
    };
    const Vector3 value = turned(v.value);
    return {value, turned(v.t), turned(v.phi) + cutter.ratio * z_cross(value)};
  }

  GeneratedSurface::Meshing GeneratedSurface::meshing(const Cutter  &cutter,
                                                      const Moving  &normal,
                                                      const Moving  &position,
                                                      const Vector3 &apex) const
  {
    // f = n . v,   v = z x r + psi' a x (r - O): velocity of the cutter's point relative to the
    // blank; r from the machine centre, r - O from the apex, a the axis of the blank.
    // Derivatives by the product rule; psi' depends on phi alone.
    const Vector3 axis(cos_root_, 0., -sin_root_);
    const auto    velocity = [&](const Vector3 &from_machine, const Vector3 &from_apex) -> Vector3 {
      return z_cross(from_machine) + cutter.ratio * axis.cross(from_apex);
    };
    const Vector3 v = velocity(position.value + apex, position.value);
    const Vector3 v_phi =
      velocity(position.phi, position.phi) + cutter.ratio_phi * axis.cross(position.value);
    return {normal.value.dot(v),
            normal.t.dot(v) + normal.value.dot(velocity(position.t, position.t)),
            normal.phi.dot(v) + normal.value.dot(v_phi)};
  }

  // Blade in the plane of e and z; sigma = +1 outside, -1 inside, where it leans the other way.
  //
  //      z ^         /
  //        |        /  al, to the cutter axis
  //        |       / s
  //        +------/----------> e
  //          r_p   tip plane z = 0
  SurfaceDerivatives GeneratedSurface::generate(const double t, const double phi) const
  {
    const double  sigma  = settings_.sigma();
    const Cutter  cutter = cutter_at(phi);
    const Vector3 e(std::cos(t), std::sin(t), 0.), e_t = z_cross(e), z = Vector3::UnitZ();

    // The straight blade at the angle t about the cutter axis, s from its tip, seen from the apex:
    //   r = P0 + s P1,   P0 = C - O + r_p T e,   P1 = T (sigma sin al e + cos al z)
    //   n = T (sigma cos al e - sin al z), which does not depend on s
    const Moving P0 =
      relative_to_apex(cutter,
                       cutter.carry(settings_.point_radius * e, settings_.point_radius * e_t));
    const Moving P1 =
      cutter.carry(sigma * sin_blade_ * e + cos_blade_ * z, sigma * sin_blade_ * e_t);
    const Moving n =
      cutter.carry(sigma * cos_blade_ * e - sin_blade_ * z, sigma * cos_blade_ * e_t);

    // The equation of meshing is linear in s: f0 + s f1 = 0 gives the point that generates,
    //   s = -f0 / f1,   ds = -(df0 + s df1) / f1
    const Meshing constant = meshing(cutter, n, P0, apex_);
    const Meshing linear   = meshing(cutter, n, P1, Vector3::Zero());
    const double  s        = -constant.value / linear.value;
    const double  s_t      = -(constant.t + s * linear.t) / linear.value;
    const double  s_phi    = -(constant.phi + s * linear.phi) / linear.value;

    // Position and normal in the frame of the turned blank; s depends on t and phi.
    const Moving       position = into_body(cutter,
                                      {P0.value + s * P1.value,
                                             P0.t + s * P1.t + s_t * P1.value,
                                             P0.phi + s * P1.phi + s_phi * P1.value});
    const Moving       normal   = into_body(cutter, n);
    SurfaceDerivatives result;
    result.point.position = position.value;
    result.point.normal   = normal.value;
    result.point.t        = t;
    result.point.phi      = phi;
    result.point.s        = s;
    result.position_t     = position.t;
    result.position_phi   = position.phi;
    result.normal_t       = normal.t;
    result.normal_phi     = normal.phi;
    return result;
  }

  GeneratedSurface::EdgePoint
  GeneratedSurface::edge_point(const double t, const double phi, const double lambda) const
  {
    // The rounded edge touches the blade at the distance edge_width() from the sharp tip and the
    // tip plane below it:
    //   radius  r_p - sigma w + sigma rf sin(lambda),   height  rf (1 - cos(lambda))
    //   n = T (sigma sin(lambda) e - cos(lambda) z)
    const double sigma = settings_.sigma(), sin_l = std::sin(lambda), cos_l = std::cos(lambda);
    const double radius = settings_.point_radius - sigma * settings_.edge_width() +
                          sigma * settings_.edge_radius * sin_l;
    const double  height = settings_.edge_radius * (1. - cos_l);
    const Cutter  cutter = cutter_at(phi);
    const Vector3 e(std::cos(t), std::sin(t), 0.), e_t = z_cross(e), z = Vector3::UnitZ();

    const Moving position =
      relative_to_apex(cutter, cutter.carry(radius * e + height * z, radius * e_t));
    const Moving normal = cutter.carry(sigma * sin_l * e - cos_l * z, sigma * sin_l * e_t);
    return {into_body(cutter, position),
            into_body(cutter, normal),
            meshing(cutter, normal, position, apex_)};
  }

  double GeneratedSurface::clearing(const SurfaceDerivatives &surface) const
  {
    // With the blade's normal n, the angle t and the distance s as coordinates of the blade and its
    // velocity v relative to the blank, tangential where f = n . v = 0, a point of the blank has
    // the distance D from the blade with
    //   D'' = -(f_phi + f_t t' + f_s s'),   v = -(r_t t' + r_s s')
    // The derivatives s_t and s_phi of f(t, s, phi) = 0 make of that, with N . (r_t x r_s) =
    // sigma rho, rho the blade's radius,
    //   D'' = N . (X_t x X_phi) f_s / (sigma rho),   f_s = sigma (z + psi' a) . (T e_t)
    const double t = surface.point.t, phi = surface.point.phi;
    const double radius = settings_.point_radius + settings_.sigma() * surface.point.s * sin_blade_;
    const double ratio  = settings_.roll_rate(phi);
    const Vector3 turning(ratio * cos_root_, 0., 1. - ratio * sin_root_);
    Vector3       across(-std::sin(t), std::cos(t), 0.);
    if (settings_.cutter_tilt != 0.)
      {
        // the direction of the tilt turns with the cradle
        const Vector3 direction =
          rotation_about(Vector3::UnitZ(), phi) * settings_.tilt_direction();
        across = rotation_about(direction, settings_.cutter_tilt) * across;
      }
    return surface.point.normal.dot(surface.position_t.cross(surface.position_phi)) *
           turning.dot(across) / radius;
  }

  double GeneratedSurface::ratio_of_roll_at(const MachineSettings &settings,
                                            const double           t,
                                            const double           s)
  {
    // f = n . (z x r) + Ra n . (a x (r - O)) = 0 solved for Ra; any ratio of roll serves to make
    // the frames
    MachineSettings trial = settings;
    trial.ratio_of_roll   = 1.;
    const GeneratedSurface surface(trial);
    const Cutter           cutter = surface.cutter_at(0.);
    const double           sigma  = settings.sigma();
    const Vector3 e(std::cos(t), std::sin(t), 0.), axis(surface.cos_root_, 0., -surface.sin_root_);
    const Vector3 n =
      cutter.tilt * (sigma * surface.cos_blade_ * e - surface.sin_blade_ * Vector3::UnitZ());
    const Vector3 r =
      cutter.center + cutter.tilt * ((settings.point_radius + sigma * s * surface.sin_blade_) * e +
                                     s * surface.cos_blade_ * Vector3::UnitZ());
    return -n.dot(z_cross(r)) / n.dot(axis.cross(r - surface.apex_));
  }

  double GeneratedSurface::angle_of_normal(const MachineSettings &settings, const double axial)
  {
    // (T n) . a = n . b with b = T^-1 a: sigma cos al (b_x cos t + b_y sin t) - sin al b_z
    const double  g = settings.machine_root_angle, al = settings.blade_angle;
    const Vector3 b = rotation_about(settings.tilt_direction(), -settings.cutter_tilt) *
                      Vector3(std::cos(g), 0., -std::sin(g));
    const double cosine =
      (axial + std::sin(al) * b[2]) / (settings.sigma() * std::cos(al) * std::hypot(b[0], b[1]));
    return polar_angle(b) +
           std::copysign(std::acos(std::max(-1., std::min(1., cosine))), -settings.cradle_angle);
  }
} // namespace vfife
