// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_statics_probe_values_h
#define vfife_fem_statics_probe_values_h

#include <vfife/element/stress.h>
#include <vfife/fem/system/discretization.h>
#include <vfife/model/state.h>

#include <vector>

namespace vfife
{
  /**
   * What a probe shows of displacements of all points (3 a point) and stresses of the model's
   * nodes, both in the fixed frame at time zero: in the axes in which a run records it. Bodies that
   * are not part of the discretization show zeros.
   */
  ProbeValue compute_probe_value(const Probe               &probe,
                                 const Discretization      &discretization,
                                 const std::vector<double> &displacements,
                                 const std::vector<Stress> &stresses);
} // namespace vfife

#endif
