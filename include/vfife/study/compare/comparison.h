// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_comparison_h
#define vfife_study_compare_comparison_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/text/table.h>
#include <vfife/base/types.h>
#include <vfife/study/compare/compared_case.h>

#include <optional>
#include <string>
#include <vector>

namespace vfife
{
  /** One number beside another that should be the same. */
  struct ComparisonRow
  {
    std::string quantity, unit;
    double      value     = not_known;
    double      reference = not_known;
    std::string reference_kind; ///< "FEM", "lumped", "balance"
    /** Of the difference's magnitude, in `unit`; nothing: the row is not judged. */
    std::optional<double> tolerance;
    std::string           reason; ///< why this tolerance, or why there is none

    /** Value less reference; NaN where either is missing. */
    double difference() const;
    /** "agrees", "differs", or "not judged" where tolerance or a number is missing. */
    std::string verdict() const;
  };

  using ComparisonRows = std::vector<ComparisonRow>;

  /** comparison.json as doc/reference/report.md, Comparison ledger, has it. */
  Json comparison_json(const std::string              &title,
                       const ComparedCases            &cases,
                       const std::vector<std::string> &remarks,
                       const ComparisonRows           &rows);

  /** A row a row: quantity, unit, value, reference, reference kind, difference, tolerance, verdict,
   * reason; numbers have the unit of their row. */
  Table comparison_table(const ComparisonRows &rows);

  /** How far numbers may be apart, relative to the reference. */
  struct ComparisonTolerances
  {
    double frequency    = 0.01;
    double error        = 0.01; ///< mean transmission error of a slow pair
    double force        = 0.005;
    double displacement = 0.005; ///< at rest
    double stress       = 0.03;  ///< at rest, at probes
    // Of a run against the reduced pair:
    double reduced_error  = 0.001; ///< of the mean transmission error
    double reduced_ripple = 0.03;  ///< of curves over the mesh cycle, of their peak to peak
    double reduced_order  = 0.05;  ///< of amplitudes of mesh orders
    /** Pinion speed up to which a run follows the static pair [rad/s]. */
    double slow = 1000 * pi / 30;

    /** Declares the entries in the section entered. */
    void declare(dealii::ParameterHandler &prm);
  };
} // namespace vfife

#endif
