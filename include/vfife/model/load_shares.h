// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_load_shares_h
#define vfife_model_load_shares_h

#include <vfife/model/model.h>

#include <array>
#include <vector>

namespace vfife
{
  /**
   * What each node of a load takes of it: a share of one by the area that belongs to the node
   * (equal shares where the nodes carry no whole face), or, of an acceleration, its mass [t].
   * Throws InputError for a pressure without a face.
   */
  std::vector<double> compute_load_shares(const Load &load, const Body &body);

  /** Shares of one by the area that belongs to each node, equal ones where the nodes carry no whole
   * face. Faces as for compute_nodal_areas(). */
  std::vector<double> compute_area_shares(const Body                      &body,
                                          const std::vector<unsigned int> &nodes,
                                          const SelectedFaces             &faces = {});

  /** Masses of nodes of a body [t]. */
  std::vector<double> masses_of(const Body &body, const std::vector<unsigned int> &nodes);

  /** Where nodes of a body are in the fixed frame at time zero [mm]. */
  std::vector<Vector3> find_undeformed_places(const Body                      &body,
                                              const std::vector<unsigned int> &nodes);

  /**
   * The forces along the tangents of their circles with which nodes exert a unit torque about the
   * body's axis [1/mm]: A_i/sum A_j r_j, r the distance from the axis in the undeformed body. A
   * node on the axis has no tangent and takes nothing. Throws InputError where all lie on it or
   * carry no area.
   */
  std::vector<double> compute_torque_shares(const Torque &torque, const Body &body);

  /** A face of a body on its boundary. */
  struct BoundaryFace
  {
    unsigned int                element; ///< of the body
    unsigned int                number;  ///< of the element's six: 2 * direction + side
    std::array<unsigned int, 4> nodes;   ///< of the body, seen from outside counter-clockwise
  };

  /** The faces on the body's boundary whose nodes all are among @p nodes, of @p faces where these
   * are given. */
  std::vector<BoundaryFace> find_boundary_faces(const Body                      &body,
                                                const std::vector<unsigned int> &nodes,
                                                const SelectedFaces             &faces = {});
} // namespace vfife

#endif
