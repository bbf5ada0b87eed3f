// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_lumped_speed_sweep_h
#define vfife_lumped_speed_sweep_h

#include <vfife/lumped/lumped_solver.h>

namespace vfife
{
  enum class SweepKind
  {
    none,
    up,
    up_and_down
  };

  /** Section Sweep. */
  struct SpeedSweepOptions
  {
    SweepKind    kind          = SweepKind::none;
    double       lowest_speed  = 0; ///< of the pinion [rad/s]
    double       highest_speed = 0; ///< [rad/s]
    unsigned int n_speeds      = 60;

    void declare(dealii::ParameterHandler &prm);
    void check(const std::string &section) const;
  };

  /** Columns of resonance.csv. */
  Table make_resonance_response_table();

  /** Adds a row a speed, upwards and then, where asked for, downwards; each speed begins with the
   * motion of the one before, so both branches of a jump are found. */
  void sweep_speeds(const LumpedModel       &model,
                    const LumpedRunOptions  &run,
                    const SpeedSweepOptions &options,
                    Table                   &table);

  /** All speeds of a pass, upwards or downwards [rad/s]; both meet the same ones. */
  std::vector<double> list_speeds(const SpeedSweepOptions &options, bool upwards);

  /** Adds a row for one speed [rad/s] of a driver with @p teeth. */
  void add_response(const std::string    &direction,
                    double                speed,
                    unsigned int          teeth,
                    const LumpedResponse &response,
                    Table                &table);
} // namespace vfife

#endif
