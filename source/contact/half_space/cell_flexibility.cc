// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/half_space/cell_flexibility.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vfife
{
  namespace
  {
    using Places = std::vector<std::array<int, 2>>;

    /** integrate_inverse_distance() by the steps between two cells. */
    Eigen::MatrixXd tabulate_half_space(const Places &places, const Vector2 &sides)
    {
      std::array<int, 2> low = places.front(), high = places.front();
      for (const auto &place : places)
        for (unsigned int d = 0; d < 2; ++d)
          {
            low[d]  = std::min(low[d], place[d]);
            high[d] = std::max(high[d], place[d]);
          }
      Eigen::MatrixXd table(high[0] - low[0] + 1, high[1] - low[1] + 1);
      for (Eigen::Index i = 0; i < table.rows(); ++i)
        for (Eigen::Index j = 0; j < table.cols(); ++j)
          table(i, j) = integrate_inverse_distance(Vector2(i * sides[0], j * sides[1]), sides);
      return table;
    }

    /** Mean over a cell of the layer's correction at a point that lies @p from_middle. */
    double mean_correction(const BondedLayer &layer,
                           const Vector2     &from_middle,
                           const Vector2     &sides,
                           const double       depth)
    {
      // Gauss points: the correction varies over the depth, of which a cell is a small part.
      const double at  = .5 / std::sqrt(3.);
      double       sum = 0.;
      for (const double u : {-at, at})
        for (const double v : {-at, at})
          sum +=
            layer.correction((from_middle + Vector2(u * sides[0], v * sides[1])).norm(), depth);
      return .25 * sum;
    }

    void add_layer(const ElasticLayer &body,
                   const BondedLayer  &layer,
                   const double        modulus,
                   const Places       &places,
                   const Vector2      &sides,
                   Eigen::MatrixXd    &flexibility)
    {
      for (Eigen::Index j = 0; j < flexibility.cols(); ++j)
        for (Eigen::Index i = 0; i <= j; ++i)
          {
            const Vector2 apart((places[i][0] - places[j][0]) * sides[0],
                                (places[i][1] - places[j][1]) * sides[1]);
            const double  change =
              modulus *
              mean_correction(layer, apart, sides, .5 * (body.depths[i] + body.depths[j]));
            flexibility(i, j) += change;
            if (i != j)
              flexibility(j, i) += change;
          }
    }
  } // namespace

  Eigen::MatrixXd compute_cell_flexibility(const Places                      &places,
                                           const Vector2                     &sides,
                                           const std::array<ElasticLayer, 2> &bodies)
  {
    const Eigen::Index n           = places.size();
    Eigen::MatrixXd    flexibility = Eigen::MatrixXd::Zero(n, n);
    if (n == 0)
      return flexibility;
    const Eigen::MatrixXd table = tabulate_half_space(places, sides);
    // Of 1 N on a cell, over pi: (1 - nu^2)/(pi E) times the integral over the cell's area.
    std::array<double, 2> moduli;
    for (unsigned int side = 0; side < 2; ++side)
      moduli[side] =
        (1. - std::pow(bodies[side].poissons_ratio, 2)) / (pi * bodies[side].youngs_modulus);
    const double by_table = (moduli[0] + moduli[1]) / (sides[0] * sides[1]);
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::Index i = 0; i < n; ++i)
        flexibility(i, j) = by_table * table(std::abs(places[i][0] - places[j][0]),
                                             std::abs(places[i][1] - places[j][1]));
    for (unsigned int side = 0; side < 2; ++side)
      if (!bodies[side].depths.empty())
        {
          if (bodies[side].depths.size() != places.size())
            throw InputError("a layer needs a depth for each cell of its surface");
          const auto add = [&](const BondedLayer &layer) {
            add_layer(bodies[side], layer, moduli[side], places, sides, flexibility);
          };
          if (bodies[side].held != nullptr)
            add(*bodies[side].held);
          else
            add(BondedLayer(bodies[side].poissons_ratio));
        }
    return flexibility;
  }
} // namespace vfife
