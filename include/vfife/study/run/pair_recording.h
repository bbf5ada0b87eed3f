// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_pair_recording_h
#define vfife_study_run_pair_recording_h

#include <vfife/contact/law/hertz.h>
#include <vfife/output/measures/body_ring.h>
#include <vfife/output/observers/fillet_writers.h>
#include <vfife/output/observers/part_stress_watch.h>
#include <vfife/output/observers/rim_writer.h>
#include <vfife/study/pressure/pressure_writer.h>
#include <vfife/study/run/pair_preload.h>
#include <vfife/study/run/pair_probes.h>
#include <vfife/study/run/stepping.h>
#include <vfife/study/stress_waves/stress_wave_places.h>

#include <functional>
#include <optional>

namespace vfife
{
  class PairCase;
  class RootSubmodels;
  class Table;
  struct DynamicsOptions;
  struct InstantOptions;
  struct OutputOptions;

  /** What a solver shows of a gear pair. Without `rim` and `bores` the state has the positions of
   * all nodes, from which these follow, and stresses of all elements besides. */
  struct PairReadings
  {
    /** What gives the strains of fillets: by submodels, or without them by the run's elements. */
    using Fillets = std::function<FilletMeasure(const RootStress &, const RootSubmodels *)>;

    ProbeMeasure       probes;
    Fillets            fillets;
    FlankReader        flanks;
    RimWriter::Measure rim   = nullptr; ///< RimWriter's
    RingMotions        bores = nullptr; ///< MisalignmentWriter's
  };

  /** What a run of a gear pair writes and tells beyond a run of any model, whatever its solver. */
  class PairRecording
  {
  public:
    /** Adds the writers of the pair to @p stepping, and to its summary what is known before the
     * first step: speeds, torque, penalty, arm. @p history: rows of history.csv. Everything given
     * but the readings must outlive the object. */
    PairRecording(const PairCase        &pair_case,
                  const DynamicsOptions &dynamics,
                  const OutputOptions   &output,
                  PairReadings           readings,
                  const Table           &history,
                  Stepping              &stepping);

    /** Adds the writers of root stresses, gauges and pressures that the options ask for, and of
     * waves of stress (Output/stress wave diameters). Looks at the largest stresses of web, rim and
     * hub where all positions are known. @p elements: those of the motion. Throws InputError for
     * diameters that the sectors cannot show, and as PressureWriter. */
    void record_stresses(const FilletOptions  &fillets,
                         const RootSubmodels  *submodels,
                         const InstantOptions &instants,
                         const FemOptions     &elements);

    /** In the state of the first step: chooses the copies of probes, unless the torque is still to
     * come, and says when they pass the mesh. Collective. */
    void prepare();

    /** Adds to the summary of a run that has ended or failed what its equilibrium tells, and the
     * steady part of the history. Says how many mesh cycles a steady part needs
     * (count_steady_meshes()). */
    void add_motion(const PairPreload &preload);

    /** Adds figures of contact, stresses and probes to the summary of a run that has ended, and
     * says whether edges of the teeth have carried. Where the speed changes, writes amplitudes of
     * history and rim's waves over it, also of a run that has failed. Collective. */
    void add_results(const PairPreload &preload);

  private:
    NamedFigures list_figures() const;
    void         record_fillets(const FilletOptions &options, const RootSubmodels *submodels);
    void         record_parts();
    void         record_stress_waves();
    void         find_steady(double swing_frequency);
    void         add_contact(double penalty_lag);
    void         write_orders() const;
    bool         has_constant_torque() const;
    /** When the last mesh cycle of the run begins [s]. */
    double last_mesh() const;

    const PairCase                 &case_;
    const DynamicsOptions          &dynamics_;
    const OutputOptions            &output_;
    const PairReadings              readings_;
    const Table                    &history_;
    Stepping                       &stepping_;
    const RunTimes                  times_;
    const Model                    &model_;
    RunObservers                   &observers_;
    RunSummary                     &summary_;
    Log                            &log_;
    const HertzContact              hertz_;
    PairProbes                      copies_;
    std::optional<RootStress>       fillets_;
    FilletMeasure                   strains_;               ///< of the fillets
    bool                            records_teeth_ = false; ///< of the fillets
    std::optional<StressWavePlaces> wave_places_;
    const Table                    *teeth_     = nullptr; ///< rows of teeth.csv
    const Table                    *probes_    = nullptr; ///< rows of probes.csv
    const Table                    *rim_       = nullptr; ///< rows of rim.csv
    const PressureWriter           *pressures_ = nullptr;
    const PartStressWatch          *parts_     = nullptr;
  };
} // namespace vfife

#endif
