// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/observer.h>

namespace vfife
{
  // For observers that keep nothing from sample to sample, or have nothing to write at the end.
  std::string Observer::part_name() const
  {
    return "";
  }

  void Observer::serialize(ByteStream &)
  {
  }

  void Observer::finish(const Model &, const State &)
  {
  }
} // namespace vfife
