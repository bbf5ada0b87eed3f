// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/newton.h>
#include <vfife/gear/spiral_bevel/mean_contact.h>

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

namespace vfife
{
  namespace
  {
    using Seven         = Eigen::Matrix<double, 7, 1>;
    using SevenJacobian = Eigen::Matrix<double, 7, 7>;

    /** What closes the six equations of contact when the ratio of roll of the pinion is unknown. */
    enum class Closing
    {
      mean_cone_distance, ///< contact at the gear's mean cone distance
      cradle_at_rest      ///< the printed cradle angle is that of the mean contact point, phi1 = 0
    };

    /** The seven equations for the unknowns of FlankContact and the pinion's ratio of roll. */
    class RatioOfRollEquations
    {
    public:
      RatioOfRollEquations(const MachineSettings &settings,
                           const GearPairOptions &options,
                           const Flank           &gear_flank,
                           const Closing          closing)
        : settings_(settings)
        , pinion_(options.pinion.blank)
        , gear_(options.gear.blank)
        , shaft_angle_(options.shaft_angle)
        , gear_flank_(gear_flank)
        , closing_(closing)
      {
      }

      /** The six equations of contact with a pinion flank cut at this ratio of roll. */
      FlankContact contact(const double ratio_of_roll) const
      {
        MachineSettings settings = settings_;
        settings.ratio_of_roll   = ratio_of_roll;
        return FlankContact(Flank(settings, pinion_.pitch_angle),
                            gear_flank_,
                            pinion_frame(shaft_angle_),
                            gear_frame(),
                            static_cast<double>(pinion_.teeth) / gear_.teeth,
                            gear_.mean_cone_distance);
      }

      void operator()(const Seven &y, Seven &residual, SevenJacobian &jacobian) const
      {
        // y = (t1, phi1, rot1, t2, phi2, rot2, Ra): the contact's own equations and derivatives
        const FlankContact::Unknowns x = y.head<6>();
        FlankContact::Unknowns       f, f_up, f_down;
        FlankContact::Jacobian       J, unused;
        contact(y[6]).evaluate(x, f, J);
        residual.head<6>() = f;
        jacobian.setZero();
        jacobian.topLeftCorner<6, 6>() = J;

        // by Ra: Newton needs this one column to a few digits only: central differences
        const double step = 1e-5 * y[6];
        contact(y[6] + step).evaluate(x, f_up, unused);
        contact(y[6] - step).evaluate(x, f_down, unused);
        jacobian.topRightCorner<6, 1>() = (f_up - f_down) / (2. * step);

        // The seventh equation: phi1 = 0, or L2 / A_m - 1 = 0 with L2 = Z cos d + r sin d.
        if (closing_ == Closing::cradle_at_rest)
          {
            residual[6]                     = x[FlankContact::phi1];
            jacobian(6, FlankContact::phi1) = 1.;
            return;
          }
        const SurfaceDerivatives surface =
          gear_flank_.derivatives(x[FlankContact::t2], x[FlankContact::phi2]);
        const Vector3 &X = surface.point.position;
        const double   r = std::hypot(X[0], X[1]), length = gear_.mean_cone_distance;
        const Vector3  gradient(X[0] / r * std::sin(gear_.pitch_angle),
                               X[1] / r * std::sin(gear_.pitch_angle),
                               std::cos(gear_.pitch_angle));
        residual[6]                     = gradient.dot(X) / length - 1.;
        jacobian(6, FlankContact::t2)   = gradient.dot(surface.position_t) / length;
        jacobian(6, FlankContact::phi2) = gradient.dot(surface.position_phi) / length;
      }

    private:
      const MachineSettings &settings_;
      const Blank           &pinion_, &gear_;
      double                 shaft_angle_;
      const Flank           &gear_flank_;
      Closing                closing_;
    };

    /** A place on the gear's tooth: over the mean cone distance and the middle of the working
     * depth, in face widths and working depths. */
    struct ToothPlace
    {
      double along, up;
    };

    /** The nearest first. */
    const ToothPlace other_starts[] = {{0., -.2},
                                       {0., .2},
                                       {-.15, 0.},
                                       {.15, 0.},
                                       {-.15, -.2},
                                       {-.15, .2},
                                       {.15, -.2},
                                       {.15, .2},
                                       {0., -.4},
                                       {0., .4},
                                       {-.3, 0.},
                                       {.3, 0.},
                                       {-.3, -.4},
                                       {-.3, .4},
                                       {.3, -.4},
                                       {.3, .4}};

    double working_depth(const Blank &pinion, const Blank &gear)
    {
      return pinion.mean_addendum + gear.mean_addendum;
    }

    /** Of the middle of the working depth over the gear's pitch cone [mm]. */
    double middle_height(const Blank &pinion, const Blank &gear)
    {
      return (gear.mean_addendum - pinion.mean_addendum) / 2;
    }

    /**
     * Start of Newton's iteration: contact at @p place, at first in the middle of the working depth
     * at the gear's mean cone distance, the cradle at rest. There the axial component of the normal
     * fixes t1, and the equation of meshing, linear in it, the ratio of roll unless that is given.
     */
    Seven start_of_mean_contact(const MachineSettings &settings,
                                const GearPairOptions &options,
                                const Flank           &gear_flank,
                                const ToothPlace      &place)
    {
      // Heights over the pitch cones are opposite.
      const Blank &pinion = options.pinion.blank, &gear = options.gear.blank;
      const double height = -middle_height(pinion, gear) - place.up * working_depth(pinion, gear);
      const double length = gear.mean_cone_distance + place.along * gear.face_width;
      const GeneratedPoint point2 = gear_flank.point_at(length, -height);
      // Turned to where it meets the pinion, next to the plane of the axes.
      const RigidMotion one  = pinion_frame(options.shaft_angle);
      double            rot2 = -polar_angle(point2.position);
      find_meshing_rotation(
        point2, one, gear_frame(), static_cast<double>(pinion.teeth) / gear.teeth, rot2);
      const Vector3 normal =
        -(one.rotation.transpose() * turned_frame(gear_frame(), rot2).rotation * point2.normal);

      // The pinion's flank must have the opposite normal there: that gives t1, and Ra.
      MachineSettings trial = settings;
      if (!(trial.ratio_of_roll > 0.))
        {
          const double t      = Flank::angle_of_normal(settings, normal[2]);
          const double s      = (pinion.mean_dedendum + height) / std::cos(settings.blade_angle);
          trial.ratio_of_roll = Flank::ratio_of_roll_at(settings, t, s);
        }
      // The pinion's point at the same height, turned into the plane of the axes.
      const GeneratedPoint point1 = Flank(trial, pinion.pitch_angle).point_at(length, height);
      Seven                y;
      y << point1.t, point1.phi, -polar_angle(point1.position), point2.t, point2.phi, rot2,
        trial.ratio_of_roll;
      return y;
    }

    bool is_inside(const Blank &blank, const Vector2 &L_h)
    {
      return L_h[0] > blank.inner_cone_distance() && L_h[0] < blank.outer_cone_distance &&
             L_h[1] < blank.addendum(L_h[0]) && L_h[1] > -blank.dedendum(L_h[0]);
    }

    /**
     * From the middle of the tooth. The flanks may have the ratio of the teeth at other points too,
     * on the teeth or beyond them, and Newton's method may come there: then from places around the
     * middle, and the contact nearest to it. False where none is found.
     */
    bool find_nearest_contact(const std::function<bool(const ToothPlace &, Seven &)> &solve_from,
                              const std::function<double(const Seven &)>             &distance_of,
                              Seven                                                  &y)
    {
      constexpr double near_middle = .1;
      bool             converged   = solve_from({0., 0.}, y);
      double distance = converged ? distance_of(y) : std::numeric_limits<double>::infinity();
      if (distance > near_middle)
        for (const ToothPlace &place : other_starts)
          {
            Seven other;
            if (!solve_from(place, other))
              continue;
            // The same contact again is no better by its round-off.
            const double of_other = distance_of(other);
            if (!std::isfinite(of_other) || of_other > distance - 1e-6)
              continue;
            y         = other;
            distance  = of_other;
            converged = true;
          }
      return converged;
    }

    /** Throws InputError where the mean contact @p L_h is not on the tooth of @p section. */
    void check_inside(const Blank       &blank,
                      const Vector2     &L_h,
                      const std::string &section,
                      const char        *flank)
    {
      if (is_inside(blank, L_h))
        return;
      std::ostringstream message;
      message << section << "/" << flank << ": the mean contact point at L = " << L_h[0]
              << " mm, h = " << L_h[1] << " mm lies outside the tooth (L "
              << blank.inner_cone_distance() << " to " << blank.outer_cone_distance << " mm, h "
              << -blank.dedendum(L_h[0]) << " to " << blank.addendum(L_h[0])
              << " mm): the settings of the two flanks do not fit";
      throw InputError("Gear pair/" + section + "/" + flank, message.str());
    }
  } // namespace

  FlankContact::Unknowns MeanContact::unknowns() const
  {
    FlankContact::Unknowns x;
    x << pinion.t, pinion.phi, rot1, gear.t, gear.phi, rot2;
    return x;
  }

  double MeanContact::lag(const MeshSide side,
                          const double   speed_ratio,
                          const double   rotation1,
                          const double   rotation2) const
  {
    const double deviation = rotation2 - rot2 + speed_ratio * (rotation1 - rot1);
    return side == MeshSide::drive ? deviation : -deviation;
  }

  MeanContact find_mean_contact(const GearPairOptions &options,
                                const MeshSide         side,
                                const FlankSide        pinion_side,
                                const FlankSide        gear_side)
  {
    const MachineSettings &settings = options.pinion.settings(pinion_side);
    const Flank gear_flank(options.gear.settings(gear_side), options.gear.blank.pitch_angle);
    const bool  given = settings.ratio_of_roll > 0.;

    const auto equations = [&](const Closing closing) {
      return RatioOfRollEquations(settings, options, gear_flank, closing);
    };
    // Given ratio of roll: six equations. Otherwise seven, first at the mean cone distance, which
    // is near the start, then with the cradle at rest.
    const auto solve_from = [&](const ToothPlace &place, Seven &y) {
      y = start_of_mean_contact(settings, options, gear_flank, place);
      if (!given)
        return solve_newton<7>(equations(Closing::mean_cone_distance), y) &&
               solve_newton<7>(equations(Closing::cradle_at_rest), y) && y[6] > 0.;
      const FlankContact     contact = equations(Closing::cradle_at_rest).contact(y[6]);
      FlankContact::Unknowns x       = y.head<6>();
      const bool             converged =
        solve_newton<6>([&](const FlankContact::Unknowns &x,
                            FlankContact::Unknowns       &f,
                            FlankContact::Jacobian       &J) { contact.evaluate(x, f, J); },
                        x);
      y.head<6>() = x;
      return converged;
    };
    // How far a contact is from the middle of the gear's tooth, in face widths and working depths;
    // beyond the teeth: infinitely far.
    const auto distance_of = [&](const Seven &y) {
      const FlankContact contact = equations(Closing::cradle_at_rest).contact(y[6]);
      const auto         L_h     = [](const Flank &flank, const double t, const double phi) {
        return flank.cone_coordinates(flank.evaluate(t, phi).position);
      };
      const Blank  &pinion = options.pinion.blank, &gear = options.gear.blank;
      const Vector2 on_gear = L_h(contact.gear(), y[FlankContact::t2], y[FlankContact::phi2]);
      if (!is_inside(gear, on_gear) ||
          !is_inside(pinion, L_h(contact.pinion(), y[FlankContact::t1], y[FlankContact::phi1])))
        return std::numeric_limits<double>::infinity();
      return std::hypot((on_gear[0] - gear.mean_cone_distance) / gear.face_width,
                        (on_gear[1] - middle_height(pinion, gear)) / working_depth(pinion, gear));
    };

    Seven      y;
    const bool converged =
      given ? find_nearest_contact(solve_from, distance_of, y) : solve_from({0., 0.}, y);
    if (!converged)
      throw InputError(std::string("Gear pair/Pinion/") + section_of(pinion_side) +
                         "/ratio of roll",
                       std::string("the pinion's ") +
                         (side == MeshSide::drive ? "drive" : "coast") +
                         " flank does not mesh with the gear at the speed ratio of the teeth" +
                         (given ? "; is the ratio of roll right?" : " for any ratio of roll"));

    // Points on both flanks and their common normal in the fixed frame.
    const FlankContact contact = equations(Closing::cradle_at_rest).contact(y[6]);
    MeanContact        mean;
    mean.rot1          = y[FlankContact::rot1];
    mean.rot2          = y[FlankContact::rot2];
    mean.pinion        = contact.pinion().evaluate(y[FlankContact::t1], y[FlankContact::phi1]);
    mean.gear          = contact.gear().evaluate(y[FlankContact::t2], y[FlankContact::phi2]);
    mean.pinion_L_h    = contact.pinion().cone_coordinates(mean.pinion.position);
    mean.gear_L_h      = contact.gear().cone_coordinates(mean.gear.position);
    mean.ratio_of_roll = y[6];

    const Matrix3 R = turned_frame(gear_frame(), mean.rot2).rotation;
    mean.position   = R * mean.gear.position;
    mean.normal     = -R * mean.gear.normal;
    mean.arm        = std::abs(mean.position.cross(mean.normal)[2]);
    check_inside(options.pinion.blank, mean.pinion_L_h, "Pinion", section_of(pinion_side));
    check_inside(options.gear.blank, mean.gear_L_h, "Gear", section_of(gear_side));
    return mean;
  }
} // namespace vfife
