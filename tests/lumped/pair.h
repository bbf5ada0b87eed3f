// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_lumped_pair_h
#define vfife_tests_lumped_pair_h

#include <vfife/base/types.h>
#include <vfife/lumped/lumped_solver.h>

/** A gear on a constant linear mesh spring: 2.2 MN m/rad, 800 N m, 27/79 teeth. */
inline vfife::LumpedPair linear_pair()
{
  vfife::LumpedPair pair;
  pair.driver_teeth         = 27;
  pair.driven_teeth         = 79;
  pair.driven_inertia       = 20.;
  pair.driver_inertia       = .3;
  pair.arm                  = 90.;
  pair.torque               = 8e5;
  pair.law.stiffness        = 2.2e9;
  pair.law.reference_torque = 8e5;
  return pair;
}

inline vfife::LumpedRunOptions
exact_run(const unsigned int settling, const unsigned int measured, const unsigned int samples)
{
  vfife::LumpedRunOptions options;
  options.settling_meshes = settling;
  options.measured_meshes = measured;
  options.samples         = samples;
  options.tolerance       = 1e-11;
  return options;
}

#endif
