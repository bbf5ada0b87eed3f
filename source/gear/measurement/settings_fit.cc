// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/gear/measurement/settings_fit.h>

#include <Eigen/SVD>

#include <cmath>
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
      throw InputError("there is no machine setting \"" + name +
                       "\" to be found; allowed: " + list_of(names) + did_you_mean(name, names));
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
    Table table;
    table.add_column("before", "um");
    table.add_column("after", "um");
    for (std::size_t i = 0; i < found.before.size(); ++i)
      table.add_row({found.before[i] / micrometre, found.after[i] / micrometre});
    return table;
  }

  SettingsFit::SettingsFit(const GearMember               &member,
                           const FlankSide                 side,
                           const std::vector<std::string> &free,
                           const bool                      free_turn,
                           const double                    threshold,
                           std::vector<Vector3>            points)
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
      throw InputError("no machine setting is to be found");
    if (points_.size() < n)
      {
        std::ostringstream message;
        message << points_.size() << " points cannot tell " << n << " unknowns";
        throw InputError(message.str());
      }
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

  SettingsFitResult SettingsFit::solve() const
  {
    // Gauss and Newton; the singular values of the slopes say which combinations the points tell,
    // the others stay. A step that makes the sum of squares no smaller is halved.
    constexpr unsigned int most      = 50;
    constexpr double       last_step = 1e-6, least_damping = 1e-4; // parts of a scale
    Unknowns               x = Unknowns::Zero(free_.size() + (free_turn_ ? 1 : 0));
    Eigen::VectorXd        r = distances(x);
    SettingsFitResult      result;
    result.before.assign(r.data(), r.data() + r.size());
    for (bool converged = false; !converged;)
      {
        if (result.iterations++ == most)
          throw NumericalError("no machine settings found: " + std::to_string(most) +
                               " steps do not come to rest; leave settings out that do the same");
        Eigen::JacobiSVD<Eigen::MatrixXd> svd(slopes(x), Eigen::ComputeThinU | Eigen::ComputeThinV);
        svd.setThreshold(threshold_);
        result.directions   = svd.rank();
        const Unknowns step = -svd.solve(r);
        converged           = step.lpNorm<Eigen::Infinity>() < last_step;
        for (double damping = 1.;; damping /= 2.)
          {
            const auto trial = [&]() -> Eigen::VectorXd {
              try
                {
                  return distances(x + damping * step);
                }
              catch (const InputError &)
                {
                  return {}; // settings that generate no flank there
                }
            }();
            if (trial.size() > 0 && trial.squaredNorm() < r.squaredNorm())
              {
                x += damping * step;
                r = trial;
                break;
              }
            if (damping < least_damping)
              {
                converged = true; // round-off is left
                break;
              }
          }
      }
    result.settings = settings_of(x);
    result.turn     = turn_of(x);
    result.after.assign(r.data(), r.data() + r.size());
    return result;
  }
} // namespace vfife
