// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_run_length_h
#define vfife_study_cases_run_length_h

namespace vfife
{
  struct Transmission;

  /** The end of a run that is to last for @p time, with samples in intervals of @p sample [s]: of
   * a gear pair the first sample that is not before it. @p pair may be nullptr. */
  double find_end(const Transmission *pair, double time, double sample);

  /** Whole tooth meshes up to a time. */
  unsigned int count_meshes(const Transmission &pair, double time);
} // namespace vfife

#endif
