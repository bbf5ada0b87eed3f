// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_load_h
#define vfife_model_load_h

#include <vfife/base/parameters/parameter_history.h>
#include <vfife/base/types.h>
#include <vfife/contact/law/friction_options.h>
#include <vfife/contact/law/penalty_options.h>

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vfife
{
  class BearingLaw;

  /** The faces that belong to a set of nodes, each by its four nodes in ascending order: of the
   * surfaces that were named. Without: all faces of the boundary whose nodes are in the set. */
  using SelectedFaces = std::optional<std::set<std::array<unsigned int, 4>>>;

  enum class LoadKind
  {
    /** The vector is the sum of the nodal forces [N], fixed in space, shared out by the area that
     * belongs to each node (equally where the nodes carry no whole face). */
    force,
    /** The vector is the sum of the moments about the set's centre [N mm], fixed in space:
     * bending traction on an end face, torsion about its normal.
     * The traction turns with the mean rotation of the set (see MeanMotion); the forces
     * sum to zero. */
    moment,
    /** Pressure [MPa] on the faces within the set, on their present areas and normals (follows). */
    pressure,
    /** Acceleration field [mm/s^2], force m a on each node of the set. */
    acceleration,
    /** Springs to the ground along x, y, z: the vector is the stiffness of the whole set [N/mm],
     * shared out as for `force`; -k (x - X). Has no history. */
    spring
  };

  /** What acts on a set of nodes of a body. */
  struct Load
  {
    std::string               name;
    LoadKind                  kind = LoadKind::force;
    unsigned int              body = 0;
    std::vector<unsigned int> nodes; ///< of the body
    Vector3                   vector   = Vector3::Zero();
    double                    pressure = 0; ///< [MPa], + into the body
    ParameterHistory          history;      ///< factor
    SelectedFaces             faces = {};
  };

  /** Holds the mean motion of a ring of a body's nodes (ShaftSeat) elastically. */
  struct Bearing
  {
    std::string               name;
    unsigned int              body = 0;
    std::vector<unsigned int> nodes; ///< of the body
    /** Columns x, y, z in the fixed frame, z along the body's axis. */
    Matrix3                           axes = Matrix3::Identity();
    std::shared_ptr<const BearingLaw> law;
    SelectedFaces                     faces = {};
  };

  /** A torsional spring and damper between the mean twist of a ring of a body's nodes and the turn
   * that the body's rate prescribes; it holds nothing else. */
  struct Coupling
  {
    std::string               name;
    unsigned int              body = 0;
    std::vector<unsigned int> nodes;         ///< of the body
    double                    stiffness = 0; ///< [N mm/rad]
    double                    damping   = 0; ///< [N mm s/rad]
    SelectedFaces             faces     = {};
  };

  /**
   * A rigid plane at rest that nodes of a body must not pass: a node at the depth d > 0 behind it
   * is pushed back by A p(d) of the contact law along the normal (linear: eps A d), A being the
   * area that belongs to the node, and held along the wall by friction.
   */
  struct RigidWall
  {
    std::string               name;
    unsigned int              body = 0;
    std::vector<unsigned int> nodes;                     ///< of the body
    Vector3                   point  = Vector3::Zero();  ///< of the plane [mm]
    Vector3                   normal = Vector3::UnitX(); ///< unit, out of the wall
    PenaltyOptions            penalty{1};
    FrictionOptions           friction;
    SelectedFaces             faces = {};
  };
} // namespace vfife

#endif
