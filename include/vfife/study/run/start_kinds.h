// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_start_kinds_h
#define vfife_study_run_start_kinds_h

#include <vfife/study/run/run_start.h>

#include <memory>

namespace vfife
{
  /** The start that Dynamics/start asks for. */
  std::unique_ptr<RunStart> make_start(const StartMeans &means);
} // namespace vfife

#endif
