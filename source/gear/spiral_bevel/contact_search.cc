// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/newton.h>
#include <vfife/gear/spiral_bevel/contact_search.h>

#include <cmath>
#include <limits>

namespace vfife
{
  bool is_on_tooth(const Blank &blank, const Vector2 &L_h)
  {
    return L_h[0] > blank.inner_cone_distance() && L_h[0] < blank.outer_cone_distance &&
           L_h[1] < blank.flank_tip(L_h[0]) && L_h[1] > -blank.dedendum(L_h[0]);
  }

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

    /** A point of the gear flank, turned to where it meets the pinion next to the plane of the
     * axes. */
    struct MeshingGearPoint
    {
      GeneratedPoint point;
      double         rotation;
      Vector3        pinion_normal; ///< of the pinion's flank there, in the pinion's frame

      /** @p L_h: cone coordinates on the gear. */
      MeshingGearPoint(const GearPairOptions &options, const Flank &gear_flank, const Vector2 &L_h)
        : point(gear_flank.point_at(L_h[0], L_h[1]))
        , rotation(-polar_angle(point.position))
      {
        const RigidMotion one = pinion_frame(options.shaft_angle);
        find_meshing_rotation(point,
                              one,
                              gear_frame(),
                              static_cast<double>(options.pinion.blank.teeth) /
                                options.gear.blank.teeth,
                              rotation);
        pinion_normal = -(one.rotation.transpose() * turned_frame(gear_frame(), rotation).rotation *
                          point.normal);
      }
    };

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
      const MeshingGearPoint two(options, gear_flank, {length, -height});

      // The pinion's flank must have the opposite normal there: that gives t1, and Ra.
      MachineSettings trial = settings;
      if (!(trial.ratio_of_roll > 0.))
        {
          const double t      = GeneratedSurface::angle_of_normal(settings, two.pinion_normal[2]);
          const double s      = (pinion.mean_dedendum + height) / std::cos(settings.blade_angle);
          trial.ratio_of_roll = GeneratedSurface::ratio_of_roll_at(settings, t, s);
        }
      // The pinion's point at the same height, turned into the plane of the axes.
      const GeneratedPoint point1 = Flank(trial, pinion.pitch_angle).point_at(length, height);
      Seven                y;
      y << point1.t, point1.phi, -polar_angle(point1.position), two.point.t, two.point.phi,
        two.rotation, trial.ratio_of_roll;
      return y;
    }

    /**
     * The contact for which local synthesis makes a pinion flank: the middle of the gear's tooth,
     * the cradle at rest (doc/theory/gear.md, Proposed pairs). Settings of another origin do not
     * touch there.
     */
    Seven synthesized_contact(const MachineSettings &settings,
                              const GearPairOptions &options,
                              const Flank           &gear_flank)
    {
      const Blank           &pinion = options.pinion.blank, &gear = options.gear.blank;
      const MeshingGearPoint two(options,
                                 gear_flank,
                                 {gear.mean_cone_distance, middle_height(pinion, gear)});
      const double           t = GeneratedSurface::angle_of_normal(settings, two.pinion_normal[2]);
      const GeneratedPoint   one = Flank(settings, pinion.pitch_angle).evaluate(t, 0.);
      Seven                  y;
      y << t, 0., polar_angle(two.pinion_normal) - polar_angle(one.normal), two.point.t,
        two.point.phi, two.rotation, settings.ratio_of_roll;
      return y;
    }

    /** Finds where two flanks touch at the ratio of the teeth. */
    class ContactSearch
    {
    public:
      ContactSearch(const MachineSettings &settings,
                    const GearPairOptions &options,
                    const Flank           &gear_flank)
        : settings_(settings)
        , options_(options)
        , gear_flank_(gear_flank)
      {
      }

      FlankContact contact(const Seven &y) const
      {
        return equations(Closing::cradle_at_rest).contact(y[6]);
      }

      /**
       * Starts in the middle of the tooth. Where the ratio of roll is given the flanks may have the
       * ratio of the teeth at other points too, on the teeth or beyond them, and Newton's method
       * may come there: then it starts from places around the middle as well, and the contact
       * nearest to it counts; before all others, the contact of a synthesis. False where no contact
       * is found. Throws InputError where the flanks do not reach the middle.
       */
      bool find(Seven &y) const
      {
        constexpr double near_middle = .1;
        if (!is_given())
          return solve_from({0., 0.}, y);
        std::optional<InputError> unreached;
        bool                      converged = attempt(ToothPlace{0., 0.}, y, unreached);
        double                    distance  = converged ? distance_of(y) : not_found;
        if (distance > near_middle)
          for (const ToothPlace &place : other_starts)
            {
              Seven                     other;
              std::optional<InputError> ignored;
              if (!attempt(place, other, ignored))
                continue;
              // The same contact again is no better by its round-off.
              const double of_other = distance_of(other);
              if (of_other > distance - 1e-6)
                continue;
              y         = other;
              distance  = of_other;
              converged = true;
            }
        converged = find_synthesized(y) || converged;
        if (!converged && unreached)
          throw *unreached;
        return converged;
      }

    private:
      /** Farther than any contact. */
      static constexpr double not_found = std::numeric_limits<double>::infinity();

      bool is_given() const
      {
        return settings_.ratio_of_roll > 0.;
      }

      RatioOfRollEquations equations(const Closing closing) const
      {
        return RatioOfRollEquations(settings_, options_, gear_flank_, closing);
      }

      /** Given ratio of roll: six equations. Otherwise seven, first at the mean cone distance,
       * which is near the start, then with the cradle at rest. */
      bool solve(Seven &y) const
      {
        if (!is_given())
          return solve_newton<7>(equations(Closing::mean_cone_distance), y) &&
                 solve_newton<7>(equations(Closing::cradle_at_rest), y) && y[6] > 0.;
        const FlankContact     flanks = contact(y);
        FlankContact::Unknowns x      = y.head<6>();
        const bool             converged =
          solve_newton<6>([&](const FlankContact::Unknowns &x,
                              FlankContact::Unknowns       &f,
                              FlankContact::Jacobian       &J) { flanks.evaluate(x, f, J); },
                          x);
        y.head<6>() = x;
        return converged;
      }

      bool solve_from(const ToothPlace &place, Seven &y) const
      {
        y = start_of_mean_contact(settings_, options_, gear_flank_, place);
        return solve(y);
      }

      /** The same, false where a flank does not reach the place. */
      bool attempt(const ToothPlace &place, Seven &y, std::optional<InputError> &error) const
      {
        try
          {
            return solve_from(place, y);
          }
        catch (const InputError &caught)
          {
            error = caught;
            return false;
          }
      }

      /** Whether the flanks touch where synthesis makes them touch: then @p y is that contact. */
      bool find_synthesized(Seven &y) const
      {
        // Settings in files have twelve digits.
        constexpr double tolerance = 1e-6, same = 1e-6;
        try
          {
            Seven                  other = synthesized_contact(settings_, options_, gear_flank_);
            FlankContact::Unknowns residual;
            FlankContact::Jacobian unused;
            contact(other).evaluate(other.head<6>(), residual, unused);
            if (!(residual.norm() < tolerance))
              return false;
            if ((other - y).head<6>().norm() > same && solve(other))
              y = other;
            return true;
          }
        catch (const InputError &)
          {
            return false;
          }
      }

      /** How far a contact is from the middle of the gear's tooth, in face widths and working
       * depths; beyond the teeth, or where the cutter leaves nothing of a flank, farther than any
       * other. */
      double distance_of(const Seven &y) const
      {
        constexpr double     beyond = 1e6;
        const FlankContact   flanks = contact(y);
        const Blank         &pinion = options_.pinion.blank, &gear = options_.gear.blank;
        const GeneratedPoint one =
                               flanks.pinion().evaluate(y[FlankContact::t1], y[FlankContact::phi1]),
                             two =
                               flanks.gear().evaluate(y[FlankContact::t2], y[FlankContact::phi2]);
        const Vector2 on_gear  = flanks.gear().cone_coordinates(two.position);
        const bool    on_teeth = is_on_tooth(gear, on_gear) &&
                              is_on_tooth(pinion, flanks.pinion().cone_coordinates(one.position)) &&
                              flanks.pinion().is_left(one) && flanks.gear().is_left(two);
        return (on_teeth ? 0. : beyond) +
               std::hypot((on_gear[0] - gear.mean_cone_distance) / gear.face_width,
                          (on_gear[1] - middle_height(pinion, gear)) / working_depth(pinion, gear));
      }

      const MachineSettings &settings_;
      const GearPairOptions &options_;
      const Flank           &gear_flank_;
    };
  } // namespace

  std::optional<ContactSearchResult> search_contact(const MachineSettings &settings,
                                                    const GearPairOptions &options,
                                                    const Flank           &gear_flank)
  {
    const ContactSearch search(settings, options, gear_flank);
    Seven               y;
    if (!search.find(y))
      return {};
    return ContactSearchResult{search.contact(y), y.head<6>(), y[6]};
  }
} // namespace vfife
