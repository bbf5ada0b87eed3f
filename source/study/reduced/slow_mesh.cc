// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/study/reduced/slow_mesh.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vfife
{
  void SlowMesh::add(Eigen::MatrixXd sectors)
  {
    positions_.push_back(std::move(sectors));
  }

  Eigen::MatrixXd SlowMesh::at(const double meshes) const
  {
    const double          whole     = std::floor(meshes);
    const std::size_t     intervals = positions_.size() - 1;
    const double          place     = (meshes - whole) * intervals;
    const std::size_t     before    = std::min(static_cast<std::size_t>(place), intervals - 1);
    const double          part      = place - before;
    const Eigen::MatrixXd first_mesh =
      (1. - part) * positions_[before] + part * positions_[before + 1];

    // Sector k has come to where sector k + moved was.
    const auto      n     = first_mesh.rows();
    const auto      moved = ((static_cast<Eigen::Index>(whole) * sense_) % n + n) % n;
    Eigen::MatrixXd now(n, first_mesh.cols());
    now.topRows(n - moved) = first_mesh.bottomRows(n - moved);
    now.bottomRows(moved)  = first_mesh.topRows(moved);
    return now;
  }
} // namespace vfife
