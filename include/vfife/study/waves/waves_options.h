// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_waves_options_h
#define vfife_study_waves_waves_options_h

#include <vfife/base/parameter_handler.h>

#include <string>
#include <vector>

namespace vfife
{
  /** What pairs are that are driven at and around the speeds of waves. */
  enum class WaveSolver
  {
    reduced,
    run ///< explicit runs of whole bodies, and reduced pairs beside them
  };

  /** Section Waves. */
  struct WavesOptions
  {
    double lowest_speed  = 0; ///< of the pinion [rad/s]
    double highest_speed = 0; ///< [rad/s]

    std::vector<std::string> diameters   = {"0", "1", "2", "3", "4", "5", "6"};
    unsigned int             wave_orders = 1;  ///< waves of each number of diameters and direction
    unsigned int             mesh_orders = 3;  ///< multiples of the mesh frequency
    unsigned int             n_speeds    = 25; ///< of the frequencies over speed

    bool                     driven      = true; ///< whether waves are driven, not only predicted
    WaveSolver               solver      = WaveSolver::reduced;
    std::vector<std::string> offsets     = {"-3 %", "-1 %", "0 %", "1 %", "3 %"};
    double                   decay_times = 6; ///< of the wave, at each speed before what is counted

    double allowed_amplification = 1.1;
    double margin                = .02; ///< of the speed, on both sides of what is to be avoided

    void declare(dealii::ParameterHandler &prm);
    void check(const std::string &section) const;

    std::vector<unsigned int> diameter_numbers() const;
    std::vector<double>       offset_parts() const;
  };
} // namespace vfife

#endif
