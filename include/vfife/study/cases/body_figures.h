// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_body_figures_h
#define vfife_study_cases_body_figures_h

#include <vfife/base/text/table.h>
#include <vfife/gear/gear_geometry.h>
#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/mesh/solid_integrals.h>
#include <vfife/model/body.h>

#include <string>
#include <vector>

namespace vfife
{
  class Log;

  /** What a user wants to know about the mesh of a gear body: quality, and mass and inertias beside
   * those of the true body. */
  struct BodyFigures
  {
    std::string    name;
    bool           has_one_material;
    double         density; ///< of the first material [t/mm^3]
    MeshQuality    quality;
    SolidIntegrals mesh, exact;
    SolidIntegrals weighted; ///< of the mesh, by the density of each element over `density`

    BodyFigures(const Body &body, const GearGeometry &gear, const GearBodyOptions &options);

    void write_to(Log &log) const;
  };

  /** A row for each body: mesh.csv. Masses and inertias of the true body are not known for several
   * materials. Differences are mesh over true body less one [%]. */
  Table body_figures_table(const std::vector<BodyFigures> &bodies);
} // namespace vfife

#endif
