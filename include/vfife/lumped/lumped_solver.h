// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_lumped_lumped_solver_h
#define vfife_lumped_lumped_solver_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/text/table.h>
#include <vfife/lumped/lumped_model.h>

#include <functional>

namespace vfife
{
  /** How long a speed is run and how exactly. */
  struct LumpedRunOptions
  {
    unsigned int settling_meshes = 400; ///< before anything is measured
    unsigned int measured_meshes = 60;
    unsigned int samples         = 64;   ///< per mesh cycle
    double       tolerance       = 1e-9; ///< of a step, relative to the static deflection

    void declare(dealii::ParameterHandler &prm);
  };

  /** What is left when a run at one speed has settled, over its measured mesh cycles. */
  struct LumpedResponse
  {
    double       mean_error = 0; ///< of the DTE [rad]
    double       rms_error  = 0; ///< about its mean [rad]
    double       pp_error   = 0; ///< largest less smallest [rad]
    double       mean_force = 0, rms_force = 0, pp_force = 0, largest_force = 0; ///< normal [N]
    unsigned int losses     = 0; ///< times that the drive flanks parted
    double       time_apart = 0; ///< part of the time in which they were apart
    double       time_coast = 0; ///< part of the time in which the coast flanks touched
    double energy_error     = 0; ///< largest residual of the energy balance over the largest energy
  };

  /**
   * Integrates a LumpedModel by the adaptive method of Dormand and Prince of order 5 with dense
   * output (Boost.Odeint); the kinks where flanks part and meet are met by its control of the step.
   * It starts in equilibrium; each run continues from the motion that the last one ended in.
   */
  class LumpedSolver
  {
  public:
    LumpedSolver(const LumpedModel &model, const LumpedRunOptions &options);

    /** A sample: time since the start of the measured part [s], position [mesh cycles], motion. */
    struct Sample
    {
      double          time, position;
      Eigen::VectorXd q, v;
      double          mesh_torque;
      double          energy_error; ///< [mJ]
    };
    using Observer = std::function<void(const Sample &)>;

    /** From here on the motion is @p q, @p v; the next run begins at position 0. */
    void set_motion(const Eigen::VectorXd &q, const Eigen::VectorXd &v);

    /** Runs at a pinion speed [rad/s] that gives @p mesh_frequency [Hz]; @p observe (may be empty)
     * sees the samples measured. Throws NumericalError where the motion is lost. */
    LumpedResponse run(double mesh_frequency, const Observer &observe = {});

  private:
    const LumpedModel &model_;
    LumpedRunOptions   options_;
    Eigen::VectorXd    q_, v_;
  };

  /** Columns of lumped.csv for a model. */
  Table make_motion_table(const LumpedModel &model);
  void  add_motion(const LumpedModel &model, const LumpedSolver::Sample &sample, Table &table);
} // namespace vfife

#endif
