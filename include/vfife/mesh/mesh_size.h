// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_mesh_size_h
#define vfife_mesh_mesh_size_h

#include <string>

namespace vfife
{
  /**
   * Throws InputError, about the section or entry @p place, unless a mesh of @p n_cells hexahedra
   * can be numbered and fits into the memory that this process can still have: what the machine has
   * free, within the limits of its control group and of the process. Asked before anything is
   * meshed. Other ranks on the machine are not counted.
   */
  void check_mesh_size(const std::string &place, double n_cells);
} // namespace vfife

#endif
