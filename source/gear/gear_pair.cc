// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/gear_pair.h>
#include <vfife/gear/newton.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    FlankSide other(const FlankSide side)
    {
      return side == FlankSide::concave ? FlankSide::convex : FlankSide::concave;
    }

    const char *name(const FlankSide side)
    {
      return side == FlankSide::concave ? "Concave flank" : "Convex flank";
    }

    double polar_angle(const Vector3 &position)
    {
      return std::atan2(position[1], position[0]);
    }

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
        const FlankContact::Unknowns x = y.head<6>();
        FlankContact::Unknowns       f, f_up, f_down;
        FlankContact::Jacobian       J, unused;
        contact(y[6]).evaluate(x, f, J);
        residual.head<6>() = f;
        jacobian.setZero();
        jacobian.topLeftCorner<6, 6>() = J;

        // Newton needs this one column to a few digits only: central differences
        const double step = 1e-5 * y[6];
        contact(y[6] + step).evaluate(x, f_up, unused);
        contact(y[6] - step).evaluate(x, f_down, unused);
        jacobian.topRightCorner<6, 1>() = (f_up - f_down) / (2. * step);

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

    /**
     * Start of Newton's iteration: contact in the middle of the working depth at the gear's mean
     * cone distance, the cradle at rest. There the axial component of the normal fixes t1, and the
     * equation of meshing, linear in it, the ratio of roll unless that is given.
     */
    Seven start_of_mean_contact(const MachineSettings &settings,
                                const GearPairOptions &options,
                                const Flank           &gear_flank)
    {
      const Blank       &pinion = options.pinion.blank, &gear = options.gear.blank;
      const double       height = (pinion.mean_addendum - gear.mean_addendum) / 2;
      const SurfacePoint point2 = gear_flank.point_at(gear.mean_cone_distance, -height);
      const RigidMotion  one    = pinion_frame(options.shaft_angle);
      double             rot2   = -polar_angle(point2.position);
      find_meshing_rotation(
        point2, one, gear_frame(), static_cast<double>(pinion.teeth) / gear.teeth, rot2);
      const Vector3 normal =
        -(one.rotation.transpose() * turned_frame(gear_frame(), rot2).rotation * point2.normal);

      MachineSettings trial = settings;
      if (!(trial.ratio_of_roll > 0.))
        {
          const double t      = Flank::angle_of_normal(settings, normal[2]);
          const double s      = (pinion.mean_dedendum + height) / std::cos(settings.blade_angle);
          trial.ratio_of_roll = Flank::ratio_of_roll_at(settings, t, s);
        }
      const SurfacePoint point1 =
        Flank(trial, pinion.pitch_angle).point_at(gear.mean_cone_distance, height);
      Seven y;
      y << point1.t, point1.phi, -polar_angle(point1.position), point2.t, point2.phi, rot2,
        trial.ratio_of_roll;
      return y;
    }

    /** The pinion's frame with the mounting errors; the shaft angle opens about y through the apex.
     */
    RigidMotion mounted_pinion_frame(const GearPairOptions &options)
    {
      RigidMotion   frame = pinion_frame(options.shaft_angle);
      const Matrix3 tilt  = rotation_about(Vector3::UnitY(), options.shaft_angle_error);
      frame.rotation      = tilt * frame.rotation;
      frame.translation =
        options.pinion_axial_shift * frame.rotation.col(2) + options.offset * Vector3::UnitY();
      return frame;
    }

    void check_inside(const Blank       &blank,
                      const Vector2     &L_h,
                      const std::string &section,
                      const char        *flank)
    {
      if (L_h[0] > blank.inner_cone_distance() && L_h[0] < blank.outer_cone_distance &&
          L_h[1] < blank.addendum(L_h[0]) && L_h[1] > -blank.dedendum(L_h[0]))
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

  MachineSettings &GearPair::Design::pinion_settings(const FlankSide side)
  {
    return side == FlankSide::concave ? options.pinion.concave : options.pinion.convex;
  }

  Flank GearPair::Design::gear_flank(const FlankSide side) const
  {
    return Flank(side == FlankSide::concave ? options.gear.concave : options.gear.convex,
                 options.gear.blank.pitch_angle);
  }

  MeanContact GearPair::find_mean_contact(Design &design, const MeshSide side)
  {
    const Blank     &blank1 = design.options.pinion.blank, &blank2 = design.options.gear.blank;
    const bool       drive       = side == MeshSide::drive;
    const FlankSide  pinion_side = drive ? design.pinion_upper : other(design.pinion_upper);
    const FlankSide  gear_side   = drive ? design.gear_upper : other(design.gear_upper);
    MachineSettings &settings    = design.pinion_settings(pinion_side);
    const Flank      gear_flank  = design.gear_flank(gear_side);
    const bool       given       = settings.ratio_of_roll > 0.;

    Seven y = start_of_mean_contact(settings, design.options, gear_flank);

    const auto equations = [&](const Closing closing) {
      return RatioOfRollEquations(settings, design.options, gear_flank, closing);
    };
    bool converged = false;
    if (given)
      {
        const FlankContact     contact = equations(Closing::cradle_at_rest).contact(y[6]);
        FlankContact::Unknowns x       = y.head<6>();
        converged                      = solve_newton<6>([&](const FlankContact::Unknowns &x,
                                        FlankContact::Unknowns       &f,
                                        FlankContact::Jacobian &J) { contact.evaluate(x, f, J); },
                                    x);
        y.head<6>()                    = x;
      }
    else
      converged = solve_newton<7>(equations(Closing::mean_cone_distance), y) &&
                  solve_newton<7>(equations(Closing::cradle_at_rest), y) && y[6] > 0.;
    if (!converged)
      throw InputError(std::string("Gear pair/Pinion/") + name(pinion_side) + "/ratio of roll",
                       std::string("the pinion's ") + (drive ? "drive" : "coast") +
                         " flank does not mesh with the gear at the speed ratio of the teeth" +
                         (given ? "; is the ratio of roll right?" : " for any ratio of roll"));

    settings.ratio_of_roll     = y[6];
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
    check_inside(blank1, mean.pinion_L_h, "Pinion", name(pinion_side));
    check_inside(blank2, mean.gear_L_h, "Gear", name(gear_side));
    return mean;
  }

  GearPair::Design GearPair::derive(const GearPairOptions &options)
  {
    options.check();
    Design design;
    design.options      = options.completed();
    const Blank &blank1 = design.options.pinion.blank, &blank2 = design.options.gear.blank;

    // The pinion pushes with the flank that leads when it turns about + its axis: the upper one;
    // the gear, turning about -, is pushed on its upper one.
    design.gear_upper =
      is_on_lower_flank(
        design.gear_flank(FlankSide::concave).point_at(blank2.mean_cone_distance, 0.))
        ? FlankSide::convex
        : FlankSide::concave;
    design.pinion_upper = other(design.gear_upper);
    std::vector<InputError> errors;
    for (const MeshSide side : {MeshSide::drive, MeshSide::coast})
      try
        {
          design.mean_contact[static_cast<unsigned int>(side)] = find_mean_contact(design, side);
        }
      catch (const InputError &error)
        {
          errors.push_back(error);
        }
    if (errors.size() == 1)
      throw errors.front();
    if (!errors.empty())
      throw InputErrors(errors);

    const MeanContact &drive = design.mean_contact[0], &coast = design.mean_contact[1];
    const double       ratio = static_cast<double>(blank1.teeth) / blank2.teeth;
    design.backlash_angle    = design.options.backlash / ((drive.arm + coast.arm) / 2);
    design.thickness_turn = ((coast.rot2 + coast.rot1 * ratio) - (drive.rot2 + drive.rot1 * ratio) +
                             design.backlash_angle) /
                            ratio;
    return design;
  }

  GearMember GearPair::make_pinion(const Design &design)
  {
    const GearMemberOptions &own = design.options.pinion;
    const Flank              concave(own.concave, own.blank.pitch_angle),
      convex(own.convex, own.blank.pitch_angle);
    const bool is_concave = design.pinion_upper == FlankSide::concave;
    const auto turned     = [&](const double angle) {
      const double concave_turn = is_concave ? 0. : angle, convex_turn = is_concave ? angle : 0.;
      return GearMember("pinion", own.blank, concave, convex, concave_turn, convex_turn);
    };
    try
      {
        return turned(design.thickness_turn);
      }
    catch (const InputError &error)
      {
        // Throws where no tooth is left without backlash either: then something else is wrong.
        const double taken =
          design.backlash_angle * design.options.gear.blank.teeth / own.blank.teeth;
        turned(design.thickness_turn - taken);
        std::ostringstream text;
        text << error.what() << "; a backlash of " << design.options.backlash << " mm takes "
             << taken * 180. / pi << " deg of it";
        throw InputError("Gear pair/Mounting/backlash", text.str());
      }
  }

  GearPair::GearPair(const GearPairOptions &options)
    : design_(derive(options))
    , pinion_frame_(mounted_pinion_frame(options))
    , gear_frame_(gear_frame())
    , pinion_(make_pinion(design_))
    // the two flanks of one cut bound a slot; the tooth below it has the slot's lower flank as its
    // upper one
    , gear_("gear",
            design_.options.gear.blank,
            design_.gear_flank(FlankSide::concave),
            design_.gear_flank(FlankSide::convex),
            design_.gear_upper == FlankSide::concave ? 0.
                                                     : -2. * pi / design_.options.gear.blank.teeth,
            design_.gear_upper == FlankSide::concave ? -2. * pi / design_.options.gear.blank.teeth
                                                     : 0.)
  {
    gear_frame_.translation[2] = options.gear_axial_shift;
    if (design_.options.proposal.is_given())
      check_proposed_contact(*this);
  }

  const GearPairOptions &GearPair::options() const
  {
    return design_.options;
  }

  const GearMember &GearPair::pinion() const
  {
    return pinion_;
  }

  const GearMember &GearPair::gear() const
  {
    return gear_;
  }

  FlankSide GearPair::pinion_side(const MeshSide side) const
  {
    return side == MeshSide::drive ? design_.pinion_upper : other(design_.pinion_upper);
  }

  FlankSide GearPair::gear_side(const MeshSide side) const
  {
    return side == MeshSide::drive ? design_.gear_upper : other(design_.gear_upper);
  }

  double GearPair::speed_ratio() const
  {
    return static_cast<double>(pinion_.blank().teeth) / gear_.blank().teeth;
  }

  const MeanContact &GearPair::mean_contact(const MeshSide side) const
  {
    return design_.mean_contact[static_cast<unsigned int>(side)];
  }

  double GearPair::rot1_reference() const
  {
    return mean_contact(MeshSide::drive).rot1;
  }

  double GearPair::rot2_reference() const
  {
    return mean_contact(MeshSide::drive).rot2;
  }

  double GearPair::thickness_turn() const
  {
    return design_.thickness_turn;
  }

  double GearPair::backlash_angle() const
  {
    return design_.backlash_angle;
  }

  RigidMotion GearPair::pinion_placement(const double rotation) const
  {
    return turned_frame(pinion_frame_, rotation);
  }

  RigidMotion GearPair::gear_placement(const double rotation) const
  {
    return turned_frame(gear_frame_, rotation);
  }

  FlankContact GearPair::flank_contact(const MeshSide side) const
  {
    return FlankContact(pinion_.generated_flank(pinion_side(side)),
                        gear_.generated_flank(gear_side(side)),
                        pinion_frame_,
                        gear_frame_,
                        speed_ratio(),
                        gear_.blank().mean_cone_distance);
  }
} // namespace vfife
