// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/pressure/near_layer.h>
#include <vfife/model/model.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <limits>
#include <numeric>

namespace vfife
{
  namespace
  {
    /** Elements under a patch of points, layer by layer. */
    class LayeredElements
    {
    public:
      LayeredElements(const Discretization &discretization, const std::vector<unsigned int> &patch)
        : discretization_(discretization)
        , part_(discretization.part_of_point(patch.front()))
        , reached_(part_.n_points, false)
        , used_(part_.n_elements, false)
      {
        for (const unsigned int point : patch)
          reached_[point - part_.first_point] = true;
      }

      /** The elements that share a point with what has been reached; says whether there are new
       * ones and none of them has one of @p others. */
      bool add_layer(const std::vector<bool> &others)
      {
        std::vector<unsigned int> found;
        for (unsigned int e = 0; e < part_.n_elements; ++e)
          if (!used_[e] && has_point(e, reached_))
            {
              if (has_point(e, others))
                return false;
              found.push_back(e);
            }
        for (const unsigned int e : found)
          {
            used_[e] = true;
            for_points(e, [this](const unsigned int p) { reached_[p] = true; });
          }
        return !found.empty();
      }

      /** 0: not in the layers, 1: free, 2: held, since elements outside have it too. By point of
       * the part. */
      std::vector<unsigned char> find_states() const
      {
        std::vector<unsigned char> states(part_.n_points, 0);
        for (unsigned int e = 0; e < part_.n_elements; ++e)
          if (used_[e])
            for_points(e, [&states](const unsigned int p) { states[p] = 1; });
        for (unsigned int e = 0; e < part_.n_elements; ++e)
          if (!used_[e])
            for_points(e, [&states](const unsigned int p) { states[p] *= 2; });
        for (unsigned char &state : states)
          state = std::min<unsigned char>(state, 2);
        return states;
      }

      /** Displacements at @p patch under unit forces there. */
      Eigen::MatrixXd find_flexibility(const std::vector<unsigned char> &states,
                                       const std::vector<unsigned int>  &patch) const;

      const Discretization::Part &part() const
      {
        return part_;
      }

    private:
      template <typename Function>
      void for_points(const unsigned int e, const Function &function) const
      {
        const unsigned int *points = discretization_.element_points(part_.first_element + e);
        for (unsigned int a = 0; a < discretization_.points_per_element(); ++a)
          function(points[a] - part_.first_point);
      }
      bool has_point(const unsigned int e, const std::vector<bool> &which) const
      {
        bool found = false;
        for_points(e, [&](const unsigned int p) { found = found || which[p]; });
        return found;
      }

      const Discretization       &discretization_;
      const Discretization::Part &part_;
      std::vector<bool>           reached_, used_;
    };

    Eigen::MatrixXd LayeredElements::find_flexibility(const std::vector<unsigned char> &states,
                                                      const std::vector<unsigned int>  &patch) const
    {
      std::vector<int> first(states.size(), -1);
      int              n = 0;
      for (std::size_t p = 0; p < states.size(); ++p)
        if (states[p] == 1)
          {
            first[p] = n;
            n += 3;
          }
      std::vector<Eigen::Triplet<double>> entries;
      for (unsigned int e = 0; e < part_.n_elements; ++e)
        {
          if (!used_[e])
            continue;
          const unsigned int    element = part_.first_element + e;
          const Eigen::MatrixXd K = compute_fem_stiffness(discretization_.element_nodes(element),
                                                          discretization_.material(element),
                                                          discretization_.element());
          const unsigned int   *points = discretization_.element_points(element);
          for (Eigen::Index r = 0; r < K.rows(); ++r)
            for (Eigen::Index c = 0; c < K.cols(); ++c)
              {
                const int row    = first[points[r / 3] - part_.first_point],
                          column = first[points[c / 3] - part_.first_point];
                if (row >= 0 && column >= 0)
                  entries.emplace_back(row + r % 3, column + c % 3, K(r, c));
              }
        }
      Eigen::SparseMatrix<double> matrix(n, n);
      matrix.setFromTriplets(entries.begin(), entries.end());
      const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);

      const Eigen::Index size = 3 * patch.size();
      Eigen::MatrixXd    flexibility(size, size);
      for (Eigen::Index k = 0; k < size; ++k)
        {
          const int             row = first[patch[k / 3] - part_.first_point];
          const Eigen::VectorXd u   = solver.solve(Eigen::VectorXd::Unit(n, row + k % 3));
          for (Eigen::Index i = 0; i < size; ++i)
            flexibility(i, k) = u[first[patch[i / 3] - part_.first_point] + i % 3];
        }
      // Symmetric to the last digit, as conjugate gradients take it to be.
      return .5 * (flexibility + flexibility.transpose());
    }

    /** From each point of the patch to the nearest one that is held; none: infinite. */
    std::vector<double> find_depths(const Discretization             &discretization,
                                    const Discretization::Part       &part,
                                    const std::vector<unsigned char> &states,
                                    const std::vector<unsigned int>  &patch)
    {
      std::vector<double> depths;
      for (const unsigned int point : patch)
        {
          double nearest = std::numeric_limits<double>::infinity();
          for (std::size_t p = 0; p < states.size(); ++p)
            if (states[p] == 2)
              nearest = std::min(nearest,
                                 (discretization.points()[part.first_point + p] -
                                  discretization.points()[point])
                                   .norm());
          depths.push_back(nearest);
        }
      return depths;
    }
  } // namespace


  double NearLayer::mean_depth() const
  {
    return std::accumulate(depths.begin(), depths.end(), 0.) / depths.size();
  }


  NearLayer find_near_layer(const Discretization            &discretization,
                            std::vector<unsigned int>        patch,
                            const std::vector<unsigned int> &others,
                            const double                     depth)
  {
    LayeredElements             elements(discretization, patch);
    const Discretization::Part &part = elements.part();
    std::vector<bool>           is_other(part.n_points, false);
    for (const unsigned int point : others)
      is_other[point - part.first_point] = true;

    NearLayer                  layer;
    std::vector<unsigned char> states;
    while (elements.add_layer(is_other))
      {
        std::vector<unsigned char> now    = elements.find_states();
        std::vector<double>        depths = find_depths(discretization, part, now, patch);
        // Nothing is left that would hold these.
        if (depths.front() == std::numeric_limits<double>::infinity())
          break;
        ++layer.n_layers;
        states       = std::move(now);
        layer.depths = std::move(depths);
        if (layer.mean_depth() >= depth)
          break;
      }
    // A point of the patch that is held itself has no flexibility of its own.
    for (const unsigned int point : patch)
      if (states.empty() || states[point - part.first_point] != 1)
        throw InputError("body \"" + discretization.model().bodies[part.body].name() +
                         "\": no layer of elements under the surface in contact leads to others "
                         "that would hold it; the pressure on its own grid needs two elements "
                         "across a tooth");
    layer.flexibility = elements.find_flexibility(states, patch);
    layer.points      = std::move(patch);
    return layer;
  }
} // namespace vfife
