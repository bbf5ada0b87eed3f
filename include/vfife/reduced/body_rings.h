// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_body_rings_h
#define vfife_reduced_body_rings_h

#include <vfife/base/types.h>

#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  struct Model;

  /** Nodes all around a body whose mean motion counts: its displacement and its turn are B u, six
   * rows in axes of the body frame (doc/theory/bearing.md, Mean motion of a ring). */
  struct MotionOfRing
  {
    std::string name;
    Vector3     centre = Vector3::Zero(); ///< undeformed, body frame [mm]
    /** B of the nodes of sector 0; the other sectors' parts are turned copies. */
    std::vector<std::pair<unsigned int, Eigen::Matrix<double, 6, 3>>> motion;
  };

  /** Names of rings, for ReducedBody::Rings::find(). */
  namespace ring
  {
    std::string              of_bearing(const std::string &bearing);
    std::string              of_coupling(const std::string &coupling);
    extern const char *const bore;  ///< of the hub, by mass
    extern const char *const whole; ///< all nodes of the body, by mass
  }                                 // namespace ring

  /**
   * The rings of a body that hangs in bearings: seats of its bearings in the order of
   * Model::bearings, then those of its couplings, the bore of its hub, and the body as a whole.
   * None for a body on an ideal bore. Throws InputError for rings that are not alike in all
   * sectors.
   */
  std::vector<MotionOfRing> list_rings(const Model &model, unsigned int body);

  /** Mass and inertia about the centre of mass for ring::whole, body frame [t, t mm^2]. */
  Eigen::Matrix<double, 6, 6> find_rigid_inertia(const Model &model, unsigned int body);
} // namespace vfife

#endif
