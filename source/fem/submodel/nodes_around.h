// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_submodel_nodes_around_h
#define vfife_fem_submodel_nodes_around_h

#include <vfife/fem/system/fem_space.h>

#include <array>
#include <vector>

namespace vfife
{
  /** Finds by which nodes of a body a place moves: those of the element that it lies in, or next to
   * which it lies, with the element's shape functions. */
  class NodesAround
  {
  public:
    /** The body must outlive the object. */
    explicit NodesAround(const Body &body);

    /** @p place: in the body frame [mm]. Throws InputError where no element is near. */
    PointWeights find(const Vector3 &place) const;

  private:
    const Body                         &body_;
    std::vector<std::array<Vector3, 2>> boxes_; ///< lower and upper corners, by element [mm]
  };
} // namespace vfife

#endif
