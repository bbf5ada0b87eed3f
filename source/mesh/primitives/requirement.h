// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_source_mesh_primitives_requirement_h
#define vfife_source_mesh_primitives_requirement_h

#include <vfife/base/errors.h>

#include <array>
#include <string>

namespace vfife
{
  /** Numbers of cells along three directions. */
  using Counts = std::array<unsigned int, 3>;

  /** Throws InputError with @p message where a shape cannot be made. */
  inline void require(const bool condition, const std::string &message)
  {
    if (!condition)
      throw InputError(message);
  }
} // namespace vfife

#endif
