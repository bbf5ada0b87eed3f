// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_pressure_pressure_writer_h
#define vfife_study_pressure_pressure_writer_h

#include <vfife/contact/law/hertz.h>
#include <vfife/fem/pressure/instant_pressure.h>
#include <vfife/model/observer.h>
#include <vfife/model/state.h>
#include <vfife/output/files/csv_stream.h>
#include <vfife/study/pressure/pressure_tables.h>

#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  class PairCase;
  class Log;
  class OutputFolder;
  struct InstantOptions;

  /** The flanks in a state, at least the teeth that are in contact; equal on all ranks. */
  using FlankReader = std::function<FlankState(const State &)>;

  /** From where a run's nodes are, of all ranks: collective. What is given must outlive it. */
  FlankReader gather_flanks(const Model &model, const Communicator &communicator);

  /** A gear pair and how long it runs. */
  struct PairRun
  {
    const Model &model;
    PairOutlines outlines;
    HertzContact hertz;        ///< of one tooth pair
    double       end_time = 0; ///< [s]
  };

  /** Of a case with teeth. */
  PairRun describe_run(const PairCase &pair_case, const Model &model, double end_time);

  /** Throws InputError where pressures cannot be found at the instants that are asked for.
   * @p elements: those of the motion. */
  void
  check_pressures(const InstantOptions &options, const FemOptions &elements, const PairRun &run);

  /** pressure.csv and pressure_field.csv of a run: pressures on grids of their own at some
   * instants. */
  class PressureWriter : public Observer
  {
  public:
    /** Throws as check_pressures(). What is given must outlive the object. Collective. */
    PressureWriter(const OutputFolder   &folder,
                   const InstantOptions &options,
                   const FemOptions     &elements,
                   const PairRun        &run,
                   FlankReader           read_flanks,
                   Log                  &log);

    bool        due(const State &state) const override;
    void        observe(const Model &model, const State &state) override;
    std::string part_name() const override;
    void        serialize(ByteStream &stream) override;
    void        finish(const Model &model, const State &state) override;

    /** The largest pressures so far. */
    NamedFigures list_figures() const
    {
      return tables_.list_figures();
    }

  private:
    std::vector<ToothPressure> find_pressures(const Model &model, const State &state);

    std::vector<double> times_;    ///< of the instants, ascending [s]
    std::uint64_t       done_ = 0; ///< of them
    FlankReader         read_flanks_;
    Log                &log_;
    InstantPressure     pressure_;
    PressureTables      tables_;
    CsvStream           teeth_file_, cells_file_;
  };
} // namespace vfife

#endif
