// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_process_revision_h
#define vfife_base_process_revision_h

#include <string>

namespace vfife
{
  /** Version number of the program, e.g. "0.1.0". */
  std::string program_version();

  /** Git revision that was built, "-dirty" with uncommitted changes, or "unknown". */
  std::string program_revision();
} // namespace vfife

#endif
