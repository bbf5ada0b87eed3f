// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/revision.h>
#include <vfife/revision.h>

namespace vfife
{
  std::string program_version()
  {
    return VFIFE_VERSION;
  }

  std::string program_revision()
  {
    return VFIFE_REVISION;
  }
} // namespace vfife
