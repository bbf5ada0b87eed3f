// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_resonance_nearest_wave_h
#define vfife_reduced_resonance_nearest_wave_h

#include <vfife/reduced/resonance/contact_meetings.h>

#include <optional>
#include <string>

namespace vfife
{
  class ReducedPair;
  struct ModalDamping;
  struct Model;

  /** Of the speeds at which mesh orders meet free vibrations in contact the one nearest to another
   * speed. */
  struct NearestWave
  {
    ContactMeeting meeting;
    double         speed    = 0; ///< of the driver [rad/s]
    double         distance = 0; ///< of the speeds, over the one asked for [-]

    /** "n = 3 forward, order 2, 8989 rpm, 0.1 %" */
    std::string describe() const;
  };

  /** The nearest of @p meetings to the @p speed of the driver [rad/s], among those with a tenth or
   * more of the largest amplitude at resonance within 10 % of the speed. @p ratio: of the driven
   * body's rate over the driver's, > 0. Nothing where there are no meetings. */
  std::optional<NearestWave>
  find_nearest_wave(const std::vector<ContactMeeting> &meetings, double ratio, double speed);

  /** Of the mesh orders 1 to 3 to the model's speed, where it is constant and one is near; the
   * @p pair, with the @p damping that it has, starts anew. Throws NumericalError. */
  std::optional<NearestWave>
  find_nearest_wave(const Model &model, const ModalDamping &damping, ReducedPair &pair);
} // namespace vfife

#endif
