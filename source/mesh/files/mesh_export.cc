// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/mesh/files/mesh_export.h>

#include "mesh_writers.h"

#include <ostream>

namespace vfife
{
  namespace
  {
    using WriteMesh = void (*)(std::ostream                    &out,
                               const ExportedMesh              &mesh,
                               const std::vector<ExportedBody> &bodies);

    /** All formats. */
    const Choices<WriteMesh> written_formats = {{"vtu", &write_vtu},
                                                {"msh", &write_gmsh},
                                                {"inp", &write_abaqus}};
  } // namespace

  std::vector<std::string> export_formats()
  {
    std::vector<std::string> names;
    for (const auto &format : written_formats)
      names.push_back(format.first);
    return names;
  }

  void write_meshes(std::ostream                    &out,
                    const std::string               &format,
                    const std::vector<ExportedBody> &bodies)
  {
    for (const auto &row : written_formats)
      if (row.first == format)
        {
          // coordinates of 100 mm to 1e-13 mm
          out.precision(15);
          row.second(out, collect(bodies), bodies);
          return;
        }
    throw InputError("expected an export format, got \"" + format + "\"; allowed: " +
                     list_of(export_formats()) + did_you_mean(format, export_formats()));
  }
} // namespace vfife
