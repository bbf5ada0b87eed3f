// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_slow_mesh_h
#define vfife_study_reduced_slow_mesh_h

#include <Eigen/Core>

#include <vector>

namespace vfife
{
  /**
   * What the sectors of a body show at all positions of the mesh cycle where nothing vibrates, a
   * row a sector: after a mesh each of them shows what the one does that was where it is now.
   */
  class SlowMesh
  {
  public:
    /** @p sense: 1 where the body turns as its sectors are numbered, or -1. */
    explicit SlowMesh(const int sense)
      : sense_(sense)
    {
    }

    /** Adds the next of equally spaced positions, the first one and the last one a mesh apart. */
    void add(Eigen::MatrixXd sectors);

    bool empty() const
    {
      return positions_.empty();
    }

    /** @p meshes after the first one (before it where negative), by straight lines between two
     * positions. */
    Eigen::MatrixXd at(double meshes) const;

  private:
    int                          sense_;
    std::vector<Eigen::MatrixXd> positions_;
  };
} // namespace vfife

#endif
