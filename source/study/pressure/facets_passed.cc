// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>
#include <vfife/study/pressure/facets_passed.h>

#include <Eigen/QR>

namespace vfife
{
  namespace
  {
    /** Sides of the facet with these corners, through its middle; that along the face leads away
     * from the apex, the origin. */
    Eigen::Matrix<double, 3, 2> find_sides(const FacetSurface                &surface,
                                           const std::array<unsigned int, 4> &corners)
    {
      const auto x = [&](const unsigned int k) -> const Vector3 & {
        return surface.positions[corners[k]];
      };
      Eigen::Matrix<double, 3, 2> sides;
      sides.col(0)         = .5 * (x(1) - x(0) + x(2) - x(3));
      sides.col(1)         = .5 * (x(3) - x(0) + x(2) - x(1));
      const Vector3 apex   = x(0) + x(1) + x(2) + x(3);
      const auto    cosine = [&](const unsigned int c) {
        return std::abs(sides.col(c).normalized().dot(apex));
      };
      if (cosine(1) > cosine(0))
        sides.col(0).swap(sides.col(1));
      return sides;
    }
  } // namespace


  FacetsPassed::FacetsPassed(const Model &model, const double spacing)
    : model_(model)
    , spacing_(spacing)
    , sums_{{Vector2::Zero(), Vector2::Zero()}}
  {
  }


  void FacetsPassed::add(const std::vector<ToothPressure> &teeth)
  {
    const ContactPair &pair = model_.contacts.front();
    std::map<std::pair<unsigned int, unsigned int>, std::array<Place, 2>> now;
    for (const ToothPressure &tooth : teeth)
      {
        const auto            groups = std::make_pair(tooth.slave_group, tooth.master_group);
        std::array<Place, 2> &places = now[groups];
        for (unsigned int side = 0; side < 2; ++side)
          {
            const Body &body = model_.bodies[side == 0 ? pair.slave_body : pair.master_body];
            const FacetSurface &surface =
              body.mesh().surfaces.at(side == 0 ? pair.slave_surface : pair.master_surface);
            double sum = 0;
            for (std::size_t k = 0; k < tooth.grid.cells.size(); ++k)
              {
                places[side].middle += tooth.grid.force_of(k) * tooth.places[side][k];
                sum += tooth.grid.force_of(k);
              }
            places[side].middle /= sum;
            std::size_t nearest = 0;
            for (std::size_t k = 0; k < tooth.grid.cells.size(); ++k)
              if ((tooth.places[side][k] - places[side].middle).norm() <
                  (tooth.places[side][nearest] - places[side].middle).norm())
                nearest = k;
            places[side].sides = find_sides(surface, tooth.grid.cells[nearest].feet[side].nodes);
          }
        const auto before = last_.find(groups);
        if (before == last_.end())
          continue;
        for (unsigned int side = 0; side < 2; ++side)
          {
            const Eigen::Matrix<double, 3, 2> sides =
              .5 * (places[side].sides + before->second[side].sides);
            const Vector3 way = places[side].middle - before->second[side].middle;
            sums_[side] += Vector2(sides.colPivHouseholderQr().solve(way)).cwiseAbs();
          }
        ++n_;
      }
    last_ = std::move(now);
  }


  Vector2 FacetsPassed::find(const unsigned int side) const
  {
    return n_ == 0 ? Vector2(Vector2::Zero()) : Vector2(sums_[side] / (n_ * spacing_));
  }
} // namespace vfife
