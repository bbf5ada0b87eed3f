// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_sweep_error_bars_h
#define vfife_study_sweep_error_bars_h

#include <vfife/base/text/table.h>
#include <vfife/output/files/figures.h>
#include <vfife/study/sweep/error_estimate.h>

#include <cstddef>
#include <string>
#include <vector>

namespace vfife
{
  /** Runs of a variant that differ in one numerical parameter alone. */
  struct NumericalSequence
  {
    std::string              parameter;
    std::vector<std::size_t> runs;  ///< the last one is that of the variant itself
    std::vector<double>      sizes; ///< relative sizes h, or none where they are not known
  };

  /** One combination of the physical parameters of a sweep. */
  struct SweepVariant
  {
    std::string                    name; ///< "thickness = 5 mm, angle = 70 deg"
    std::size_t                    run;  ///< with the finest numerical parameters
    std::vector<NumericalSequence> sequences;
  };

  /** A figure with its numerical error, the sum of those by each numerical parameter. */
  struct ErrorBar
  {
    double                     value = 0; ///< of the variant's own run
    double                     error = 0; ///< NaN where one of the sum is not known
    std::vector<ErrorEstimate> by;        ///< of each sequence
  };

  /** @param values of all runs of the sweep, NaN for those without one. */
  ErrorBar compute_error_bar(const SweepVariant &variant, const std::vector<double> &values);

  /**
   * The same of the difference, @p first less @p second. It is a figure itself: what numerical
   * parameters do to both variants alike is no error of it.
   */
  ErrorBar compute_difference(const SweepVariant        &first,
                              const SweepVariant        &second,
                              const std::vector<double> &values);

  /** Whether two variants differ by more than their errors. */
  enum class Verdict
  {
    significant,      ///< the difference is larger than its error and than the sum of both errors
    sign_significant, ///< than its error alone: which one is larger is known
    not_significant,  ///< neither, or no more than round-off
    not_known         ///< a value or an error is missing
  };

  /** "significant", "sign significant", "not significant", "not known". */
  std::string word_for(Verdict verdict);

  /** Up to 1e-9 of the larger value a difference is round-off, also where both errors are zero. */
  Verdict
  judge_difference(const ErrorBar &first, const ErrorBar &second, const ErrorBar &difference);

  /** Tables of a sweep with numerical parameters. */
  struct ErrorTables
  {
    Table bars;        ///< error_bars.csv: a row a figure and variant
    Table differences; ///< differences.csv: a row a figure and pair of variants
  };

  /** Without rows. */
  ErrorTables make_error_tables(const std::vector<std::string> &numerical_parameters);

  /** @param runs names of the runs; @param all figures of each, as many and with the same names,
   * NaN where it has none. A figure that no run has is left out. */
  ErrorTables compute_error_tables(const std::vector<SweepVariant> &variants,
                                   const std::vector<std::string>  &runs,
                                   const std::vector<NamedFigures> &all);
} // namespace vfife

#endif
