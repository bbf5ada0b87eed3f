// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_pressure_calibrated_penalty_h
#define vfife_study_pressure_calibrated_penalty_h

#include <optional>
#include <vector>

namespace vfife
{
  class PairCase;
  class Compliance;
  class Log;
  struct Model;
  struct Transmission;

  /** Turns of the driver at equal positions over one gear mesh, from zero [rad]: those of a static
   * transmission error. calibrate_penalty() uses every second one and leaves the compliance with
   * what all of them need. */
  std::vector<double> turns_over_mesh(const Transmission &transmission);

  /** Static transmission errors under the whole torque at every @p every -th of turns_over_mesh()
   * [rad]: of the linear bodies on the contact's springs. Throws NumericalError as
   * PairEquilibrium. Collective. */
  std::vector<double>
  find_static_errors(Compliance &compliance, const Model &model, unsigned int every = 1);

  /** Whether calibrate_penalty() has something to do: the case leaves the penalty open, and its
   * contact in one pass has a load. */
  bool needs_calibration(const PairCase &the_case, const Model &model);

  /**
   * Gives the points of the loaded contact of a gear pair the penalties with which its teeth
   * approach each other as on the contact's own grid (PenaltyCalibration) at positions over one
   * mesh cycle, and the other contact their mean. @p compliance: of the @p model. With a
   * @p mean_error [rad] the springs also supply what the elements of the bodies lack until the mean
   * static transmission error is that. Returns the static transmission errors that the springs are
   * to have [rad], at equal steps over turns_over_mesh(). Where the grid gives none, a warning
   * says why, the penalties stay, and nothing is returned. Collective.
   */
  std::vector<double> calibrate_penalty(const PairCase       &the_case,
                                        Compliance           &compliance,
                                        Log                  &log,
                                        Model                &model,
                                        std::optional<double> mean_error = std::nullopt);

  /** By how much the static transmission errors of the springs exceed the @p errors that
   * calibrate_penalty() has returned [rad], at the same turns: ContactPair::spring_errors. Throws
   * as find_static_errors(). Collective. */
  std::vector<double>
  find_spring_errors(Compliance &compliance, const Model &model, const std::vector<double> &errors);

  /** Mean static transmission error of a pair over a mesh cycle under the whole torque, of the
   * linear bodies on the contact's own grid [rad]: by every second position of
   * calibrate_penalty(). Throws as Compliance and PairPressure. Collective. */
  double find_mean_error(const PairCase &the_case, Compliance &compliance, const Model &model);
} // namespace vfife

#endif
