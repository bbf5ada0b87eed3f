// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/observer.h>

namespace vfife
{
  void Observer::serialize(ByteStream &)
  {
  }

  void Observer::finish(const Model &, const State &)
  {
  }
} // namespace vfife
