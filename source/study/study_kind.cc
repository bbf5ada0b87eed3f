// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/study/study_kind.h>

namespace vfife
{
  std::vector<std::string> StudyKind::cases_taken_over() const
  {
    return {};
  }

  std::size_t
  StudyKind::resume(const std::string &, const DeclaredSection &, const Communicator &, Log &)
  {
    throw InputError("Study/kind",
                     "--restart goes on from checkpoints, and this kind has none; kinds run, "
                     "reduced, sweep, compare and waves have");
  }
} // namespace vfife
