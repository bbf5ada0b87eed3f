// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/types.h>
#include <vfife/model/model.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/reduced/resonance/linear_response.h>
#include <vfife/reduced/resonance/nearest_wave.h>
#include <vfife/reduced/resonance/static_passage.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Mesh orders that drive waves. */
    constexpr unsigned int driving_orders = 3;
    /** Parts of the speed within which they are looked for, the next one where there is none. */
    constexpr double surroundings[] = {.1, .4};
    /** Positions of a mesh cycle: their mean force gives the poles, their harmonics up to the
     * driving orders the amplitudes, of which the size is enough. */
    constexpr unsigned int n_positions = 12;
    /** Of the largest amplitude nearby: weaker resonances are as many as there are orders and
     * modes, and one of them is always near. */
    constexpr double noticeable = 0.1;

    /** Square of the amplitude at resonance, of the displacements weighted by masses, up to a
     * factor that all at one speed have in common. */
    double strength_of(const ContactMeeting &meeting)
    {
      // The kinetic energy has the square of the frequency.
      const double decay = meeting.rate.imag() * meeting.mesh_order;
      return meeting.energy / (decay * decay);
    }

    /** The largest of the meetings that @p is_near; of all where none is. */
    template <typename IsNear>
    double find_largest_strength(const std::vector<ContactMeeting> &meetings, const IsNear &is_near)
    {
      double nearby = 0, all = 0;
      for (const ContactMeeting &meeting : meetings)
        {
          all = std::max(all, strength_of(meeting));
          if (is_near(meeting))
            nearby = std::max(nearby, strength_of(meeting));
        }
      return nearby > 0 ? nearby : all;
    }
  } // namespace

  std::string NearestWave::describe() const
  {
    std::ostringstream text;
    text << describe_wave(meeting) << ", mesh order " << meeting.mesh_order << ", " << std::fixed
         << std::setprecision(0) << speed * 30. / pi << " rpm of the pinion, "
         << std::setprecision(1) << 100. * distance << " % from the operating speed";
    return text.str();
  }

  std::optional<NearestWave> find_nearest_wave(const std::vector<ContactMeeting> &meetings,
                                               const double                       ratio,
                                               const double                       speed)
  {
    if (meetings.empty())
      return {};
    const auto speed_of = [ratio](const ContactMeeting &meeting) {
      return std::abs(meeting.rate.real()) / ratio;
    };
    const auto distance_of = [&](const ContactMeeting &meeting) {
      return std::abs(speed_of(meeting) / speed - 1.);
    };
    const double least =
      noticeable * noticeable * find_largest_strength(meetings, [&](const ContactMeeting &meeting) {
        return distance_of(meeting) <= surroundings[0];
      });
    const ContactMeeting *nearest = nullptr;
    for (const ContactMeeting &meeting : meetings)
      if (!(strength_of(meeting) < least) &&
          (nearest == nullptr || distance_of(meeting) < distance_of(*nearest)))
        nearest = &meeting;
    return NearestWave{*nearest, speed_of(*nearest), distance_of(*nearest)};
  }

  std::optional<NearestWave>
  find_nearest_wave(const Model &model, const ModalDamping &damping, ReducedPair &pair)
  {
    const Transmission &t = *model.only_transmission();
    if (!t.has_constant_rate() || t.driver_rate == 0)
      return {};
    const double         step = pair.time_step();
    const StaticPassage  passage(model, pair, n_positions);
    const LinearResponse linear(
      pair.body(t.driven), passage, damping, pair.sector_sense(t.driven), t.driven_sense);
    const double ratio = std::abs(t.ratio()), rate = ratio * t.driver_rate,
                 turning = model.bodies[t.driven].rate < 0 ? -1. : 1.;
    std::optional<NearestWave> found;
    for (const double part : surroundings)
      if (!found)
        found = find_nearest_wave(find_contact_meetings(linear,
                                                        driving_orders,
                                                        (1. - part) * rate,
                                                        (1. + part) * rate,
                                                        turning),
                                  ratio,
                                  t.driver_rate);
    pair.set_speed(t.driver_rate, step);
    return found;
  }
} // namespace vfife
