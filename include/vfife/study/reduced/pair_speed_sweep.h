// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_pair_speed_sweep_h
#define vfife_study_reduced_pair_speed_sweep_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/text/table.h>
#include <vfife/lumped/speed_sweep.h>
#include <vfife/reduced/reduced_options.h>
#include <vfife/study/cases/edges_under_load.h>
#include <vfife/study/reduced/near_cutoff.h>
#include <vfife/study/reduced/slow_mesh.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vfife
{
  class Log;
  class OutputFolder;
  class ReducedPair;
  class StressWavePlaces;
  struct Model;
  struct RunSummary;
  struct SpeedSample;
  struct State;

  /** Entries of section Reduced that sweeps over speed have beside those of SpeedSweepOptions. */
  struct PairSpeedSweepOptions
  {
    double settling_decay_times  = 0; ///< that a speed settles, at least
    double allowed_amplification = 0; ///< of forces and stresses; 0: nothing is judged
    double highest_frequency     = 0; ///< of their vibrations [Hz]; 0: half the cut-off

    void declare(dealii::ParameterHandler &prm);
  };

  /** How a reduced pair is swept over speeds. */
  struct PairSpeedSweepSetup
  {
    ReducedOptions        reduced;
    SpeedSweepOptions     speeds;
    PairSpeedSweepOptions options;
    double                cutoff  = 0; ///< that of the bodies [Hz]
    double                damping = 0; ///< of the momentum [1/s]
    unsigned int          samples = 0; ///< per mesh cycle

    std::optional<EdgesUnderLoad> edges; ///< that may carry; none: not looked for

    /** Of vibrations of force and stress that are looked at [Hz]. */
    double highest_frequency() const;
    /** Steps between two samples, a part of those between samples of a history: as many as show the
     * highest frequency well. @p steps: in a mesh cycle of a frequency [Hz]. */
    unsigned int find_stride(double mesh_frequency, unsigned int steps) const;
    /** Mesh cycles of a frequency [Hz] in which a speed settles. */
    unsigned int find_settling_meshes(double mesh_frequency) const;
    /** Width of a resonance with an order of the gear mesh between its half-power points, in the
     * speed of the driver [rad/s]. */
    double resonance_width(unsigned int order, unsigned int driver_teeth) const;
    /** What is wrong with speeds farther apart than a resonance with one of the judged orders is
     * wide; empty where they are near enough. */
    std::string find_wide_steps(unsigned int driver_teeth) const;

    /** Mesh orders whose resonances a sweep has to meet. */
    static constexpr unsigned int judged_orders = 3;
  };

  /** Tooth pairs of samples of a sweep, for EdgesUnderLoad. */
  Table make_swept_teeth_table();
  /** Columns of wave_response.csv. */
  Table make_wave_response_table();
  /** Columns of stress_response.csv. */
  Table make_stress_response_table();

  /** A reduced pair at one speed after the other, each from the motion at the one before. */
  class PairSpeedSweep
  {
  public:
    /** @p places: whose stresses are looked at; where they have fillets, the driven body has their
     * readings (list_fillet_readings()). All but the setup must outlive the object. */
    PairSpeedSweep(const Model            &model,
                   PairSpeedSweepSetup     setup,
                   const StressWavePlaces &places,
                   ReducedPair            &pair);

    /**
     * Finds the stresses without vibration at all speeds, and turns the pair at all speeds of the
     * passes, from the equilibrium at the first one on. @p report is called after each speed.
     * Throws NumericalError; the tables have what was before.
     */
    void run(const std::function<void()> &report, Log &log);

    /** Rows of resonance.csv. */
    const Table &resonance() const
    {
      return resonance_;
    }
    /** Rows of wave_response.csv. */
    const Table &waves() const
    {
      return waves_;
    }
    /** Rows of stress_response.csv. */
    const Table &stresses() const
    {
      return stresses_;
    }

    const NearCutoff &near_cutoff() const
    {
      return near_cutoff_;
    }
    /** Its edges are those of all samples. */
    const PairSpeedSweepSetup &setup() const
    {
      return setup_;
    }
    /** Of all speeds so far, settling included. */
    std::uint64_t n_steps() const
    {
      return n_steps_;
    }
    double time() const ///< [s]
    {
      return time_;
    }

  private:
    double mesh_frequency_at(double speed) const;
    /** Returns the steps per mesh cycle. */
    unsigned int    set_speed(double speed);
    Eigen::MatrixXd read_stresses() const;
    SpeedSample     take_sample(State &state) const;
    void            add_teeth(const State &state, Table &teeth) const;
    /** A mesh cycle so slow that nothing vibrates; empty without damping. */
    void record_slow_mesh();
    /** By place, the largest of all sectors and positions of the slow mesh with the spin of a speed
     * [MPa]; not known without that mesh. */
    std::vector<double> find_stresses_at_rest(double speed);
    /** @p at_rest: those at that speed. */
    void turn_at(double                     speed,
                 const std::string         &direction,
                 const std::vector<double> &at_rest,
                 Log                       &log);

    const Model            &model_;
    PairSpeedSweepSetup     setup_;
    const StressWavePlaces &places_;
    ReducedPair            &pair_;
    NearCutoff              near_cutoff_;
    std::uint64_t           n_steps_ = 0;
    double                  time_    = 0; ///< [s]
    SlowMesh                slow_mesh_;
    Table                   resonance_, waves_, stresses_;
  };

  /**
   * Does the sweep and writes its tables after each speed, exceedances.csv and @p summary at the
   * end, which has what was known before. Throws NumericalError after that, and Interrupted where a
   * signal has come. Collective.
   */
  void run_speed_sweep(PairSpeedSweep &sweep, RunSummary &summary, OutputFolder &folder, Log &log);
} // namespace vfife

#endif
