// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/cases/run_length.h>

#include <cmath>
#include <string>

namespace vfife
{
  double PairCase::mesh_frequency() const
  {
    return operation_.mesh_frequency(teeth()[0]);
  }

  double PairCase::end_time() const
  {
    if (operation_.end_time > 0)
      return operation_.end_time;
    const double at_first_speed = operation_.meshes.number / mesh_frequency();
    if (operation_.speed_history.is_constant())
      return at_first_speed;
    try
      {
        return operation_.speed_history.find_time(at_first_speed);
      }
    catch (const InputError &error)
      {
        throw InputError("Operation/speed",
                         std::string("the speed ") + error.what() + " of " +
                           std::to_string(operation_.meshes.number) + " mesh cycles");
      }
  }

  double PairCase::run_meshes() const
  {
    return operation_.end_time > 0
             ? mesh_frequency() * operation_.speed_history.integral(operation_.end_time)
             : operation_.meshes.number;
  }

  bool PairCase::may_be_made_longer() const
  {
    return !operation_.speed_history.is_formula();
  }

  std::vector<unsigned int> PairCase::list_lengths(const DynamicsOptions &dynamics) const
  {
    if (!operation_.meshes.is_word || operation_.end_time > 0)
      return {};
    // Vibrations begin to fall when a ramp has ended.
    const unsigned int most  = operation_.most_meshes,
                       first = count_steady_meshes(mesh_frequency(), 1., dynamics);
    const auto ramp          = dynamics.start == Start::ramp ? std::ceil(operation_.ramp) : 0.;
    std::vector<unsigned int> lengths;
    for (double length = first + ramp; length < most; length = std::ceil(1.5 * length))
      lengths.push_back(static_cast<unsigned int>(length));
    lengths.push_back(most);
    return lengths;
  }

  void PairCase::set_length(const unsigned int meshes)
  {
    operation_.meshes.number = meshes;
  }

  double PairCase::largest_speed_factor() const
  {
    // Of a table on the whole: a run that is made longer goes on with the same samples. What has
    // no speed, as kinds that stand still, has no end either.
    const ParameterHistory &history = operation_.speed_history;
    if (history.is_constant() || !(operation_.speed > 0))
      return 1.;
    return history.find_range(history.is_formula() ? end_time() : history.end()).second;
  }

  double PairCase::torque_on(const unsigned int member) const
  {
    const std::array<unsigned int, 2> numbers = teeth();
    const unsigned int                driven  = operation_.driving == DrivingMember::pinion ? 1 : 0;
    // Given on the driven member or on the pinion; the other one has the same work.
    const bool at_pinion = operation_.pinion_torque > 0;
    return (at_pinion ? operation_.pinion_torque : operation_.torque) * double(numbers[member]) /
           double(numbers[at_pinion ? 0 : driven]);
  }

  double PairCase::driven_torque() const
  {
    return torque_on(operation_.driving == DrivingMember::pinion ? 1 : 0);
  }

  const ParameterHistory &PairCase::driven_torque_history() const
  {
    return operation_.pinion_torque > 0 ? operation_.pinion_torque_history
                                        : operation_.torque_history;
  }

  void PairCase::check_histories(const DynamicsOptions &dynamics) const
  {
    if (!driven_torque_history().is_constant() && dynamics.start == Start::ramp)
      throw InputError("Operation/torque",
                       "expected a constant torque with Dynamics/start = ramp, got a torque over "
                       "time. Set Dynamics/start = static equilibrium");
    if (operation_.meshes.is_word && !(operation_.end_time > 0))
      {
        operation_.require_constant("Operation", "run until its ripple is steady");
        if (!(dynamics.mass_damping() > 0) && !(dynamics.mesh_damping > 0))
          throw InputError("Operation/mesh cycles",
                           "until steady requires Dynamics/mass proportional damping or driven "
                           "speed damping, because "
                           "otherwise vibrations do not decay");
      }
    if (!(operation_.speed_history.find_range(end_time()).first > 0))
      throw InputError("Operation/speed",
                       "reaches zero within the run; it must be positive to the end");
  }

  double PairCase::ramp_time() const
  {
    const double at_first_speed = operation_.ramp / mesh_frequency();
    return at_first_speed > 0 ? operation_.speed_history.find_time(at_first_speed) : 0.;
  }

  void PairCase::check_run(const DynamicsOptions &dynamics) const
  {
    if (dynamics.start == Start::undeformed)
      throw InputError("Dynamics/start",
                       "expected \"static equilibrium\", \"steady torsional vibration\" or "
                       "\"ramp\" for a gear pair, "
                       "got \"undeformed\", which is for models of the section Model");
    check_histories(dynamics);
    check_dampers(dynamics);
  }

  void PairCase::check_dampers(const DynamicsOptions &dynamics) const
  {
    // Compliance of the reference pair, measured once over damping/ring_rate(): -0.2 % at 0.025,
    // -12 % at 0.25, -28 % at 0.5 (doc/theory/dynamics.md, Mesh damping).
    const double unit       = recommended_damping * ring_rate();
    const bool   too_strong = dynamics.mass_damping() > 10 * unit;
    if (!too_strong && !(dynamics.mesh_damping > 100 * unit))
      return;
    const auto rate = [unit](const unsigned int times) {
      return std::to_string(std::lround(times * unit)) + " 1/s";
    };
    throw InputError(
      !too_strong                  ? "Dynamics/driven speed damping"
      : dynamics.damping_ratio > 0 ? "Dynamics/damping ratio"
                                   : "Dynamics/mass proportional damping",
      "the damping distorts the static deflection pattern and the compliance (by more than 25 % at "
      "the largest damping). For a gear of this size set damping at most " +
        rate(10) + " (ratio times 4 pi frequency) and driven speed damping at most " + rate(100) +
        "; recommended: at most " + rate(1));
  }

  // dt = 1/(f s n), n = ceil(1/(f s dt_s)): whole steps from sample to sample, so that samples lie
  // at the same positions of every mesh cycle. Where the speed changes, its largest value counts.
  double PairCase::choose_step(const double stable_step, const unsigned int samples) const
  {
    const double frequency = mesh_frequency() * largest_speed_factor();
    if (!(frequency > 0))
      return stable_step; // at rest
    const double steps_per_sample = std::ceil(1. / (frequency * stable_step * samples));
    return 1. / (frequency * samples * steps_per_sample);
  }
} // namespace vfife
