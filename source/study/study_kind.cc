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
    throw InputError(
      "Study/kind",
      "--restart is not available for this kind (available: run, reduced, sweep, compare, waves)");
  }
} // namespace vfife
