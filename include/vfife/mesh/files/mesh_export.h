// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_files_mesh_export_h
#define vfife_mesh_files_mesh_export_h

#include <vfife/mesh/files/exported_mesh.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace vfife
{
  /** "vtu", "msh", "inp": also the ends of file names. */
  std::vector<std::string> export_formats();

  /**
   * Writes bodies in a format of export_formats(); throws InputError for another. Units mm, N, MPa,
   * t, s, as the files say where they can (doc/reference/mesh-formats.md).
   */
  void write_meshes(std::ostream                    &out,
                    const std::string               &format,
                    const std::vector<ExportedBody> &bodies);
} // namespace vfife

#endif
