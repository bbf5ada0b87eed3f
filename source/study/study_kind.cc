// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/study/study_kind.h>

namespace vfife
{
  std::size_t
  StudyKind::resume(const std::string &, const DeclaredSection &, const Communicator &, Log &)
  {
    throw InputError("Study/kind",
                     "--restart is for kinds run, sweep and compare: this one has no checkpoints");
  }
} // namespace vfife
