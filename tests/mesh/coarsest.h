// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_mesh_coarsest_h
#define vfife_tests_mesh_coarsest_h

#include <vfife/base/types.h>
#include <vfife/mesh/gear/gear_body_options.h>

#include <deal.II/base/point.h>

/** For meshes that are refined afterwards. */
inline vfife::GearBodyOptions coarsest(vfife::GearBodyOptions options)
{
  options                  = coarse(options);
  options.flank_rows       = 2;
  options.cells_lengthwise = 3;
  options.web_rows         = 3;
  return options;
}

inline vfife::Vector3 vector_of(const dealii::Point<3> &x)
{
  return {x[0], x[1], x[2]};
}

#endif
