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

/** A response whose numbers all differ: 11 to 13 arcsec, 14 to 17 N, 18 losses... */
inline vfife::LumpedResponse made_up_response()
{
  vfife::LumpedResponse r;
  r.mean_error    = 11 * vfife::arcsecond;
  r.rms_error     = 12 * vfife::arcsecond;
  r.pp_error      = 13 * vfife::arcsecond;
  r.mean_force    = 14;
  r.rms_force     = 15;
  r.pp_force      = 16;
  r.largest_force = 17;
  r.losses        = 18;
  r.time_apart    = .19;
  r.time_coast    = .2;
  r.energy_error  = .21;
  return r;
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
