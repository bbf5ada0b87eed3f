// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_start_summary_h
#define vfife_study_start_summary_h

#include <vfife/output/files/summary.h>

#include <string>

namespace vfife
{
  class ExplicitSolver;
  class OutputFolder;
  struct Model;

  /** What is known of any study of a model before it begins: parameter file and ranks, which the
   * folder of its results knows, program, bodies. @p study: the word of its kind. */
  RunSummary
  start_summary(const std::string &study, const Model &model, const OutputFolder &folder);

  /** What is known of any run before its first step: program, bodies, step @p dt [s]. @p study: the
   * word of its kind. */
  RunSummary start_summary(const std::string  &study,
                           const Model        &model,
                           ExplicitSolver     &solver,
                           double              dt,
                           const OutputFolder &folder);
} // namespace vfife

#endif
