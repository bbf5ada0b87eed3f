// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_pair_results_h
#define vfife_study_run_pair_results_h

#include <vfife/contact/law/hertz.h>
#include <vfife/output/files/summary.h>
#include <vfife/output/measures/body_ring.h>
#include <vfife/output/observers/fillet_writers.h>
#include <vfife/output/observers/part_stress_watch.h>
#include <vfife/output/observers/rim_writer.h>
#include <vfife/study/pressure/pressure_writer.h>
#include <vfife/study/stress_waves/stress_wave_places.h>

#include <cstdint>
#include <optional>

namespace vfife
{
  class Case;
  class Log;
  class OutputFolder;
  class RootSubmodels;
  class RunObservers;
  class Table;
  struct DynamicsOptions;
  struct InstantOptions;
  struct Model;
  struct OutputOptions;

  /** What a run of a gear pair writes and tells beyond a run of any model. */
  class PairResults
  {
  public:
    /** @p history_steps from sample to sample, the run ends at @p end_time [s]. Everything given
     * must outlive the object. */
    PairResults(const Model         &model,
                const HertzContact  &hertz,
                const OutputOptions &output,
                std::uint64_t        history_steps,
                double               end_time);

    /** Adds the writers of the pair; @p measure_rim: RimWriter's, @p motion_of:
     * MisalignmentWriter's. */
    void add_observers(RunObservers      &observers,
                       RimWriter::Measure measure_rim = nullptr,
                       RingMotions        motion_of   = nullptr);

    /** What gives the strains of fillets: by submodels, or without them by the run's elements. */
    using MakeFilletMeasure =
      std::function<FilletMeasure(const RootStress &, const RootSubmodels *)>;

    /** Adds the writers of root stresses and gauges that @p options ask for. */
    void record_fillets(const FilletOptions     &options,
                        const RootSubmodels     *submodels,
                        const MakeFilletMeasure &measure,
                        RunObservers            &observers);

    /** Adds the writers of waves of stress that Output/stress wave diameters asks for, of probes
     * and of the fillets that are recorded. Throws InputError for diameters that the sectors cannot
     * show. */
    void record_stress_waves(ProbeMeasure measure, RunObservers &observers);

    /** Looks at the largest stresses of web, rim and hub over the run, a few times in a mesh cycle;
     * of runs with positions of all nodes. */
    void record_parts(const DynamicsOptions &dynamics, RunObservers &observers);

    /** Adds the writer of pressures on grids of their own at the instants that @p options ask for,
     * if any; as PressureWriter. */
    void record_pressures(const InstantOptions &options,
                          const FemOptions     &elements,
                          const PairRun        &run,
                          const FlankReader    &read_flanks,
                          Log                  &log,
                          RunObservers         &observers);

    /** What is known before the first step: speeds, torque, penalty, Case::arm_range(). */
    NamedFigures list_figures(double penalty, const std::optional<Vector2> &arm_range) const;

    /** Adds the steady part of the @p history to the summary; @p swing_frequency [Hz]. Says how
     * many mesh cycles a steady part needs (count_steady_meshes()). */
    void find_steady(const Table           &history,
                     double                 swing_frequency,
                     const DynamicsOptions &dynamics,
                     RunSummary            &summary,
                     Log                   &log) const;

    /** Adds figures of contact and stresses to the summary of a run that has ended; @p penalty_lag
     * [rad]. */
    void
    add_contact(double penalty_lag, std::size_t n_samples, RunSummary &summary, Log &log) const;

    /** Says whether edges of the teeth of @p pair_case have carried: write_edge_contact(). */
    void write_edges(const Case &pair_case, const OutputFolder &folder, Log &log) const;

    /** Writes amplitudes of the @p history and of the rim's waves over the speed, where it changes.
     */
    void write_orders(const OutputFolder &folder, const Table &history) const;

    /** Rows of probes.csv. */
    const Table &probe_rows() const
    {
      return *probes_;
    }

  private:
    bool has_constant_torque() const;
    /** When the last mesh cycle of the run begins [s]. */
    double last_mesh() const;

    const Model                    &model_;
    HertzContact                    hertz_;
    const OutputOptions            &output_;
    std::uint64_t                   history_steps_;
    double                          end_time_;
    std::optional<RootStress>       fillets_;
    FilletMeasure                   strains_;               ///< of the fillets
    bool                            records_teeth_ = false; ///< of the fillets
    std::optional<StressWavePlaces> wave_places_;
    const Table                    *teeth_     = nullptr; ///< rows of teeth.csv
    const Table                    *probes_    = nullptr;
    const Table                    *rim_       = nullptr; ///< rows of rim.csv
    const PressureWriter           *pressures_ = nullptr;
    const PartStressWatch          *parts_     = nullptr;
  };
} // namespace vfife

#endif
