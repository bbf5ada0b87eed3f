// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_sweep_sweep_study_h
#define vfife_study_sweep_sweep_study_h

#include <vfife/study/case_runner.h>
#include <vfife/study/study_kind.h>
#include <vfife/study/sweep/error_bars.h>
#include <vfife/study/sweep/history_figure.h>

#include <string>
#include <vector>

namespace vfife
{
  struct CommandLine;

  /**
   * Study kind `sweep`: the base case once for every value of some of its entries, or for every
   * combination of values. Each run has a folder of its own, run_01 and so on, in that of the
   * sweep; sweep.csv and sweep.json have the key figures of all, and those that `figures` take of
   * the histories, with errors and orders of convergence where references are known.
   *
   * Tables of folders that `beside` names are copied into the sweep's folder, for the report: the
   * coupled modes of a loaded tooth contact analysis, the sweep of speeds of a lumped model.
   *
   * Parameters that `error by` names are numerical: they are not combined with others but varied
   * one by one, and figures get errors by them (error_bars.h).
   *
   * The ranks are dealt to groups of `ranks per run`, which do runs at the same time. A run that
   * fails stops no other. With --restart finished runs of the same parameters are kept, and others
   * go on from their checkpoints.
   */
  class SweepStudy : public StudyKind
  {
  public:
    explicit SweepStudy(const CaseRunner &runner);

    void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    /** Reads the base case with the entries of every run. */
    void        check() const override;
    void        inspect(Communicator &communicator, Log &log) override;
    std::size_t resume(const std::string     &folder,
                       const DeclaredSection &now,
                       const Communicator    &communicator,
                       Log                   &log) override;
    void        run(OutputFolder &folder, Log &log) override;

  private:
    struct Parameter
    {
      std::string name, entry, values, sizes;

      std::vector<std::string> list_entries() const;
      std::vector<std::string> list_values() const;
      /** Throws InputError, see check_list_commas(). */
      void check_commas(const char *list, const std::string &text) const;
      /** What each of the entries is set to. */
      std::vector<std::string> list_parts(const std::string &value) const;
      /** Those that are stated; nothing where they are to be derived. */
      std::vector<double> list_sizes() const;
    };

    /** One run: the values of all parameters. */
    using Values = std::vector<std::string>;

    enum class Combination
    {
      list,   ///< first values together, second values together...
      product ///< each with each; the last parameter changes fastest
    };

    static std::string folder_of_run(std::size_t i);

    void declare_own(dealii::ParameterHandler &prm);
    void check_columns() const;
    void check_numerical() const;
    bool is_numerical(const Parameter &parameter) const;
    /** All combinations of the physical parameters, the numerical ones at their last values. */
    std::vector<Values> list_combinations() const;
    /** Each combination after the runs that differ from it in one numerical parameter. */
    std::vector<Values> list_runs() const;
    /** Of runs whose folders these are. */
    std::vector<SweepVariant> list_variants(const std::vector<std::string> &folders) const;
    CommandLine               command_line(const Values &values) const;
    unsigned int              count_groups(const Communicator &communicator) const;
    std::string               describe(const Values &values) const;
    /** Path of the entry that makes a run's parameters wrong, by the message of that; empty where
     * it is none of the sweep's. */
    std::string find_cause(const std::string &message) const;
    void        copy_beside(const OutputFolder &folder) const;
    /** The key figures of each run; as many and with the same names for all. */
    std::vector<NamedFigures> read_figures(const OutputFolder            &folder,
                                           const std::vector<Values>     &runs,
                                           const std::vector<CaseReport> &reports,
                                           Log                           &log) const;
    void                      write_results(const OutputFolder            &folder,
                                            const std::vector<Values>     &runs,
                                            const std::vector<CaseReport> &reports,
                                            Log                           &log) const;
    /** error_bars.csv and differences.csv; what they have as JSON. */
    Json write_errors(const OutputFolder              &folder,
                      const std::vector<CaseReport>   &reports,
                      const std::vector<NamedFigures> &all) const;

    const CaseRunner          &runner_;
    bool                       restart_ = false;
    std::string                base_, entries_;
    std::vector<std::string>   names_, figure_names_, beside_, error_by_;
    std::vector<Parameter>     parameters_;
    std::vector<HistoryFigure> figures_;
    Combination                combination_   = Combination::product;
    unsigned int               ranks_per_run_ = 0;
    bool                       pictures_      = true;
  };

  /** sweep.csv without rows: the values of parameters, and figures of the runs. */
  Table make_sweep_table(const std::vector<std::string> &parameters, const NamedFigures &figures);
} // namespace vfife

#endif
