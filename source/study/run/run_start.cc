// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/study/run/run_start.h>

namespace vfife
{
  void RunStart::serialize(ByteStream &)
  {
  }

  void RunStart::serialize_later(ByteStream &)
  {
  }

  const PairPreload *RunStart::preload() const
  {
    return nullptr;
  }
} // namespace vfife
