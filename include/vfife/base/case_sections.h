// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_case_sections_h
#define vfife_base_case_sections_h

#include <algorithm>
#include <array>

namespace vfife
{
  // Sections at the top of a parameter file that say what a study is of.

  constexpr const char *model_section        = "Model";
  constexpr const char *spiral_bevel_section = "Gear pair";
  /** Of gear pairs, one for each kind of gears. */
  constexpr std::array<const char *, 1> pair_sections = {{spiral_bevel_section}};

  /** Whether a file has one of a gear pair; @p contains: whether it has a section of a
   * name. */
  template <typename Contains>
  bool has_pair_section(const Contains &contains)
  {
    return std::any_of(pair_sections.begin(), pair_sections.end(), contains);
  }

  /** Whether a file describes a general model. One that says nothing of either is one of a gear
   * pair, as most kinds of studies want it. */
  template <typename Contains>
  bool describes_model(const Contains &contains)
  {
    return contains(model_section) && !has_pair_section(contains);
  }
} // namespace vfife

#endif
