// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/gear/measurement/settings_fit.h>

#include <Eigen/SVD>

#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace vfife
{
  namespace
  {
    constexpr double arcminute = pi / (180. * 60.);

    FittedSetting find_setting(const std::string &name)
    {
      std::vector<std::string> names;
      for (const FittedSetting &setting : fitted_settings())
        {
          if (setting.name == name)
            return setting;
          names.push_back(setting.name);
        }
      throw InputError("expected a machine setting, got \"" + name +
                       "\"; allowed: " + list_of(names) + did_you_mean(name, names));
    }
  } // namespace

  const std::vector<FittedSetting> &fitted_settings()
  {
    // Scales are steps in which machines are corrected; they weigh changes that do the same.
    static const std::vector<FittedSetting> settings = {
      {"point radius", &MachineSettings::point_radius, .01, "mm"},
      {"blade angle", &MachineSettings::blade_angle, arcminute, "deg"},
      {"radial distance", &MachineSettings::radial_distance, .01, "mm"},
      {"cradle angle", &MachineSettings::cradle_angle, arcminute, "deg"},
      {"blank offset", &MachineSettings::blank_offset, .01, "mm"},
      {"sliding base", &MachineSettings::sliding_base, .01, "mm"},
      {"machine center to back", &MachineSettings::machine_center_to_back, .01, "mm"},
      {"machine root angle", &MachineSettings::machine_root_angle, arcminute, "deg"},
      {"ratio of roll", &MachineSettings::ratio_of_roll, 1e-4, "-"},
      {"modified roll second order", &MachineSettings::second_order_roll, 1e-3, "1/rad"},
      {"modified roll third order", &MachineSettings::third_order_roll, 1e-2, "1/rad^2"},
      {"cutter tilt", &MachineSettings::cutter_tilt, arcminute, "deg"},
      {"cutter swivel", &MachineSettings::cutter_swivel, arcminute, "deg"}};
    return settings;
  }

  Table fit_table(const SettingsFitResult &found)
  {
    Table table{{"before", "um"}, {"after", "um"}};
    for (std::size_t i = 0; i < found.before.size(); ++i)
      table.add_row({found.before[i] / micrometre, found.after[i] / micrometre});
    return table;
  }

  SettingsFit::SettingsFit(const GearMember               &member,
                           const FlankSide                 side,
                           const std::vector<std::string> &free,
                           const bool                      free_turn,
                           const double                    threshold,
                           std::vector<Vector3>            points,
                           const std::vector<double>      &largest_changes)
    : given_(member.generated_flank(side).settings())
    , pitch_angle_(member.blank().pitch_angle)
    , own_turn_(member.turn(side))
    // a turn weighs as its arc does
    , turn_scale_(.01 / member.blank().meridian_point({member.blank().mean_cone_distance, 0.})[0])
    , threshold_(threshold)
    , free_turn_(free_turn)
    , points_(std::move(points))
  {
    for (const std::string &name : free)
      free_.push_back(find_setting(name));
    const std::size_t n = free_.size() + (free_turn_ ? 1 : 0);
    if (free_.empty())
      throw InputError("expected at least one machine setting, got none");
    if (points_.size() < n)
      {
        std::ostringstream message;
        message << "expected at least " << n << " points for " << n << " unknowns, got "
                << points_.size();
        throw InputError(message.str());
      }
    limits_ = Unknowns::Constant(n, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < largest_changes.size(); ++i)
      limits_[i] = largest_changes[i] / free_[i].scale;
  }

  MachineSettings SettingsFit::settings_of(const Unknowns &x) const
  {
    MachineSettings settings = given_;
    for (std::size_t i = 0; i < free_.size(); ++i)
      settings.*free_[i].value += x[i] * free_[i].scale;
    return settings;
  }

  double SettingsFit::turn_of(const Unknowns &x) const
  {
    return free_turn_ ? x[free_.size()] * turn_scale_ : 0.;
  }

  Eigen::VectorXd SettingsFit::distances(const Unknowns &x) const
  {
    // To the flank's point at the same (L, h), along its normal: the distance to the flank but for
    // terms of second order in it.
    const Flank     flank(settings_of(x), pitch_angle_);
    const Matrix3   back = rotation_about(Vector3::UnitZ(), -own_turn_ - turn_of(x));
    Eigen::VectorXd result(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      {
        const Vector3        at  = back * points_[i];
        const Vector2        L_h = flank.cone_coordinates(at);
        const GeneratedPoint own = flank.point_at(L_h[0], L_h[1]);
        result[i]                = -(at - own.position).dot(own.normal);
      }
    return result;
  }

  Eigen::MatrixXd SettingsFit::slopes(const Unknowns &x) const
  {
    // Central differences over a hundredth of the scales: nearly linear, far above round-off.
    constexpr double step = .01;
    Eigen::MatrixXd  result(points_.size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i)
      {
        const Unknowns change = step * Unknowns::Unit(x.size(), i);
        result.col(i)         = (distances(x + change) - distances(x - change)) / (2. * step);
      }
    return result;
  }

  SettingsFit::Unknowns SettingsFit::limited_step(const Eigen::MatrixXd &slopes,
                                                  const Unknowns        &x,
                                                  const Eigen::VectorXd &r,
                                                  unsigned int          &directions) const
  {
    // A setting whose step would leave its limits goes to the limit, and the others find the least
    // squares anew. The singular values of the slopes say which combinations the points tell, the
    // others stay.
    Unknowns          step = Unknowns::Zero(x.size());
    Eigen::MatrixXd   free = slopes;
    std::vector<bool> is_set(x.size(), false);
    for (bool inside = false; !inside;)
      {
        Eigen::JacobiSVD<Eigen::MatrixXd> svd(free, Eigen::ComputeThinU | Eigen::ComputeThinV);
        svd.setThreshold(threshold_);
        directions                 = svd.rank();
        const Unknowns of_the_free = -svd.solve(r + slopes * step);
        inside                     = true;
        for (Eigen::Index i = 0; i < x.size(); ++i)
          if (!is_set[i] && std::abs(x[i] + of_the_free[i]) > limits_[i])
            {
              step[i]   = std::copysign(limits_[i], x[i] + of_the_free[i]) - x[i];
              is_set[i] = true;
              inside    = false;
              free.col(i).setZero();
            }
        if (inside)
          for (Eigen::Index i = 0; i < x.size(); ++i)
            if (!is_set[i])
              step[i] = of_the_free[i];
      }
    return step;
  }

  bool SettingsFit::go_along(const Unknowns &step, Unknowns &x, Eigen::VectorXd &r) const
  {
    // A step that makes the sum of squares no smaller is halved.
    constexpr double least_damping = 1e-4;
    for (double damping = 1.; damping >= least_damping; damping /= 2.)
      {
        Eigen::VectorXd trial;
        try
          {
            trial = distances(x + damping * step);
          }
        catch (const InputError &)
          {
            continue; // settings that generate no flank there
          }
        if (trial.squaredNorm() < r.squaredNorm())
          {
            x += damping * step;
            r = trial;
            return true;
          }
      }
    return false;
  }

  SettingsFitResult SettingsFit::solve() const
  {
    // Gauss and Newton; every step that is taken is better than the one before.
    constexpr unsigned int most      = 50;
    constexpr double       last_step = 1e-6; // parts of a scale
    // Linear changes of the distances below this, or this part of them, are round-off [mm].
    constexpr double  round_off = 1e-8, least_part = 1e-4;
    Unknowns          x = Unknowns::Zero(free_.size() + (free_turn_ ? 1 : 0));
    Eigen::VectorXd   r = distances(x);
    SettingsFitResult result;
    result.before.assign(r.data(), r.data() + r.size());
    for (bool at_rest = false; !at_rest && result.unfinished.empty();)
      {
        if (result.iterations++ == most)
          {
            result.unfinished = "no convergence in " + std::to_string(most) +
                                " steps. Remove settings that have the same effect";
            break;
          }
        const Eigen::MatrixXd J    = slopes(x);
        const Unknowns        step = limited_step(J, x, r, result.directions);
        const double          gain = (J * step).lpNorm<Eigen::Infinity>();
        at_rest                    = step.lpNorm<Eigen::Infinity>() < last_step;
        if (!go_along(step, x, r) && !at_rest)
          {
            at_rest = gain < round_off || gain < least_part * r.lpNorm<Eigen::Infinity>();
            if (!at_rest)
              result.unfinished =
                "no part of the last step reduces the deviations. Limit the changes of the "
                "settings, or identify fewer settings";
          }
      }
    result.settings = settings_of(x);
    result.turn     = turn_of(x);
    result.after.assign(r.data(), r.data() + r.size());
    for (std::size_t i = 0; i < free_.size(); ++i)
      if (std::abs(x[i]) >= limits_[i] * (1. - 1e-9))
        result.at_limit.push_back(free_[i].name);
    return result;
  }
} // namespace vfife
