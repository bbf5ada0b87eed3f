// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_element_frame_kind_h
#define vfife_element_frame_kind_h

namespace vfife
{
  /** How the rotation of an element is taken from its nodes; see frame.h. */
  enum class FrameKind
  {
    polar,
    three_nodes
  };

  constexpr unsigned int n_frame_kinds = 2;
} // namespace vfife

#endif
