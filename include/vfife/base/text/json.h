// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_json_h
#define vfife_base_text_json_h

#include <nlohmann/json_fwd.hpp>

namespace vfife
{
  /** JSON that keeps the order of its members; a source file that uses it includes
   * <nlohmann/json.hpp>. */
  using Json = nlohmann::ordered_json;
} // namespace vfife

#endif
