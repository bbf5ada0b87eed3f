// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/types.h>
#include <vfife/fem/pressure/layer_elements.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace vfife
{
  namespace
  {
    /** Sides whose normals differ by less go on from each other: cosine of 45 deg. */
    constexpr double smooth = 0.7071;

    /** The side of an element at the low or high end of one of its axes. */
    struct Side
    {
      unsigned int element, axis;
      bool         high;
    };

    /** Nodes of an element along each axis. */
    unsigned int nodes_along(const std::vector<unsigned int> &element)
    {
      return std::lround(std::cbrt(element.size()));
    }

    unsigned int stride_of(const unsigned int n, const unsigned int axis)
    {
      return axis == 0 ? 1 : (axis == 1 ? n : n * n);
    }

    /** Of the node @p a along an axis. */
    unsigned int step_of(const unsigned int a, const unsigned int n, const unsigned int axis)
    {
      return a / stride_of(n, axis) % n;
    }

    /** The node with another step along an axis. */
    unsigned int replace_step(const unsigned int a,
                              const unsigned int n,
                              const unsigned int axis,
                              const unsigned int step)
    {
      return a + stride_of(n, axis) * step - stride_of(n, axis) * step_of(a, n, axis);
    }

    /** Corners of a side in turn. */
    std::array<unsigned int, 4> corners_of(const std::vector<unsigned int> &element,
                                           const Side                      &side)
    {
      const unsigned int          n = nodes_along(element), last = n - 1;
      const unsigned int          u = (side.axis + 1) % 3, v = (side.axis + 2) % 3;
      std::array<unsigned int, 4> corners;
      for (unsigned int k = 0; k < 4; ++k)
        {
          unsigned int a = replace_step(0, n, side.axis, side.high ? last : 0);
          a              = replace_step(a, n, u, k == 1 || k == 2 ? last : 0);
          a              = replace_step(a, n, v, k >= 2 ? last : 0);
          corners[k]     = element[a];
        }
      return corners;
    }

    bool all_of(const std::array<unsigned int, 4> &points, const std::vector<char> &which)
    {
      return std::all_of(points.begin(), points.end(), [&which](const unsigned int p) {
        return which[p];
      });
    }

    using Edge = std::pair<unsigned int, unsigned int>;

    Edge make_edge(const unsigned int a, const unsigned int b)
    {
      return {std::min(a, b), std::max(a, b)};
    }

    /** By edges of the surface: the side beyond which the element under the surface ends there. */
    using SurfaceEnds = std::map<Edge, Side>;

    SurfaceEnds
    find_ends(const LayerElements &layer, const std::vector<char> &surface, const PointPairs &edges)
    {
      std::set<Edge> wanted;
      for (const auto &edge : edges)
        wanted.insert(make_edge(edge[0], edge[1]));
      SurfaceEnds ends;
      for (unsigned int e = 0; e < layer.elements.size(); ++e)
        for (unsigned int axis = 0; axis < 3; ++axis)
          for (const bool high : {false, true})
            {
              const auto corners = corners_of(layer.elements[e], {e, axis, high});
              if (!all_of(corners, surface))
                continue;
              // Corners 0, 1 and 2, 3 run along the axis after this one, at both ends of the next.
              const unsigned int        u = (axis + 1) % 3, v = (axis + 2) % 3;
              const std::array<Side, 4> ends_of = {
                {{e, v, false}, {e, u, true}, {e, v, true}, {e, u, false}}};
              for (unsigned int k = 0; k < 4; ++k)
                if (const Edge edge = make_edge(corners[k], corners[(k + 1) % 4]);
                    wanted.count(edge) != 0)
                  ends.emplace(edge, ends_of[k]);
            }
      return ends;
    }

    /** Sides that no other element has, that are not all held and no facets of the surface. */
    class FreeSides
    {
    public:
      /** @p surface: of the points, whether they are on it. */
      FreeSides(const LayerElements &layer, const std::vector<char> &surface)
      {
        std::map<std::array<unsigned int, 4>, std::vector<Side>> all;
        for (unsigned int e = 0; e < layer.elements.size(); ++e)
          for (unsigned int axis = 0; axis < 3; ++axis)
            for (const bool high : {false, true})
              {
                auto corners = corners_of(layer.elements[e], {e, axis, high});
                std::sort(corners.begin(), corners.end());
                all[corners].push_back({e, axis, high});
              }
        for (const auto &[corners, sides] : all)
          if (sides.size() == 1 && !all_of(corners, layer.held) && !all_of(corners, surface))
            add(layer, sides.front());
      }

      /** Those at an edge with what goes on from them smoothly. */
      std::vector<Side> find_at(const std::array<unsigned int, 2> &edge) const
      {
        std::vector<char>        found(sides_.size(), false);
        std::vector<std::size_t> next;
        if (const auto at = at_.find(make_edge(edge[0], edge[1])); at != at_.end())
          next = at->second;
        std::vector<Side> sides;
        while (!next.empty())
          {
            const std::size_t i = next.back();
            next.pop_back();
            if (found[i])
              continue;
            found[i] = true;
            sides.push_back(sides_[i]);
            const auto visit = [&](const std::vector<std::size_t> &others) {
              for (const std::size_t j : others)
                if (normals_[i].dot(normals_[j]) > smooth)
                  next.push_back(j);
            };
            for (unsigned int k = 0; k < 4; ++k)
              {
                visit(at_.at(edge_of(i, k)));
                // Sides of elements of other sizes have no whole edge in common.
                if (of_corner_.count(corners_[i][k]) != 0)
                  visit(of_corner_.at(corners_[i][k]));
              }
          }
        return sides;
      }

    private:
      Edge edge_of(const std::size_t i, const unsigned int k) const
      {
        return make_edge(corners_[i][k], corners_[i][(k + 1) % 4]);
      }
      void add(const LayerElements &layer, const Side &side)
      {
        const auto corners = corners_of(layer.elements[side.element], side);
        const auto x       = [&](const unsigned int k) { return layer.points[corners[k]]; };
        // Elements are right-handed: the normal is along the axis.
        const Vector3 along = (x(2) - x(0)).cross(x(3) - x(1)).normalized();
        sides_.push_back(side);
        corners_.push_back(corners);
        normals_.push_back((side.high ? 1. : -1.) * along);
        for (unsigned int k = 0; k < 4; ++k)
          {
            at_[edge_of(sides_.size() - 1, k)].push_back(sides_.size() - 1);
            if (!layer.hanging.empty())
              of_corner_[corners[k]].push_back(sides_.size() - 1);
          }
      }

      std::vector<Side>                        sides_;
      std::vector<std::array<unsigned int, 4>> corners_;
      std::vector<Vector3>                     normals_; ///< outward
      std::map<Edge, std::vector<std::size_t>> at_;      ///< the sides at an edge
      /** The sides at a corner, of layers with elements of several sizes. */
      std::map<unsigned int, std::vector<std::size_t>> of_corner_;
    };

    /** Adds elements beyond sides that go on from each other, row by row. */
    class Continuation
    {
    public:
      /** @p surface: of the points, whether they are on it, with those that are added. @p alike:
       * all points go on by the mean step of the edge. */
      Continuation(LayerElements           &layer,
                   const std::vector<Side> &sides,
                   const SurfaceEnds       &ends,
                   std::vector<char>       &surface,
                   const bool               alike)
        : layer_(layer)
        , surface_(surface)
      {
        // How the surface comes to the edge: the last step of its lines. The sides beyond the edge
        // may be those of other elements, as at a chamfer.
        std::map<unsigned int, Vector3> steps;
        for (const Side &side : sides)
          {
            const auto corners = corners_of(layer.elements[side.element], side);
            for (unsigned int k = 0; k < 4; ++k)
              if (const auto end = ends.find(make_edge(corners[k], corners[(k + 1) % 4]));
                  end != ends.end())
                {
                  const std::vector<unsigned int> &own = layer.elements[end->second.element];
                  for (unsigned int a = 0; a < own.size(); ++a)
                    if (own[a] == end->first.first || own[a] == end->first.second)
                      steps[own[a]] = layer.points[own[a]] - layer.points[opposite(end->second, a)];
                }
          }
        width        = std::numeric_limits<double>::infinity();
        Vector3 mean = Vector3::Zero();
        for (const auto &step : steps)
          {
            width = std::min(width, step.second.norm());
            mean += step.second / steps.size();
          }
        if (alike)
          {
            width = mean.norm();
            for (auto &step : steps)
              step.second = mean;
          }
        // All that is below a point of the edge goes on as it does.
        for (const Side &side : sides)
          for (unsigned int a = 0; a < layer.elements[side.element].size(); ++a)
            if (is_on(side, a))
              {
                const unsigned int point = layer.elements[side.element][a];
                const auto         nearest =
                  std::min_element(steps.begin(),
                                   steps.end(),
                                   [&](const auto &one, const auto &other) {
                                     const auto distance = [&](const unsigned int p) {
                                       return (layer.points[p] - layer.points[point]).norm();
                                     };
                                     return distance(one.first) < distance(other.first);
                                   });
                steps_[point] = nearest->second;
              }
      }

      /** Adds an element; its outer side. */
      Side add_element(const Side &side)
      {
        const std::vector<unsigned int> inner  = layer_.elements[side.element];
        const unsigned int              n      = nodes_along(inner);
        const std::vector<double>       places = places_along(n - 1);
        std::vector<unsigned int>       outer(inner.size());
        for (unsigned int a = 0; a < inner.size(); ++a)
          {
            const unsigned int step = step_of(a, n, side.axis), beyond = n - 1 - step;
            const unsigned int steps = side.high ? beyond : step; // from the side to this node
            const unsigned int foot  = inner[replace_step(a, n, side.axis, side.high ? n - 1 : 0)];
            outer[replace_step(a, n, side.axis, beyond)] = point_beyond(foot, steps, places[steps]);
          }
        layer_.elements.push_back(std::move(outer));
        return {static_cast<unsigned int>(layer_.elements.size() - 1), side.axis, side.high};
      }

      /** Lets what continues points that hang move with what continues those that move them. */
      void tie_row()
      {
        for (const auto &[from, point] : known_)
          {
            const auto found = layer_.hanging.find(from.first);
            if (found == layer_.hanging.end() || layer_.hanging.count(point) != 0)
              continue;
            PointWeights masters;
            for (const auto &[master, weight] : found->second)
              if (const auto beyond = known_.find({master, from.second}); beyond != known_.end())
                masters.emplace_back(beyond->second, weight);
            if (masters.size() == found->second.size())
              layer_.hanging[point] = std::move(masters);
          }
      }

      double width; ///< of the narrowest row [mm]

    private:
      bool is_on(const Side &side, const unsigned int a) const
      {
        const unsigned int n = nodes_along(layer_.elements[side.element]);
        return step_of(a, n, side.axis) == (side.high ? n - 1 : 0);
      }
      unsigned int opposite(const Side &side, const unsigned int a) const
      {
        const std::vector<unsigned int> &own = layer_.elements[side.element];
        const unsigned int               n   = nodes_along(own);
        return own[replace_step(a, n, side.axis, side.high ? 0 : n - 1)];
      }
      unsigned int point_beyond(const unsigned int foot, const unsigned int steps, double part)
      {
        if (steps == 0)
          return foot;
        const auto [place, is_new] =
          known_.try_emplace({foot, steps}, static_cast<unsigned int>(layer_.points.size()));
        if (is_new)
          {
            layer_.points.push_back(layer_.points[foot] + part * steps_.at(foot));
            layer_.held.push_back(layer_.held[foot]);
            surface_.push_back(surface_[foot]);
            steps_[place->second] = steps_.at(foot);
          }
        return place->second;
      }

      LayerElements                  &layer_;
      std::vector<char>              &surface_;
      std::map<unsigned int, Vector3> steps_; ///< from a point to that of the next row [mm]
      std::map<std::pair<unsigned int, unsigned int>, unsigned int> known_; ///< by foot and steps
    };
  } // namespace

  ElementNodes LayerElements::nodes_of(const std::vector<unsigned int> &element) const
  {
    ElementNodes X(3, element.size());
    for (std::size_t a = 0; a < element.size(); ++a)
      X.col(a) = points[element[a]];
    return X;
  }

  bool LayerElements::is_folded(const std::size_t first) const
  {
    try
      {
        for (std::size_t e = first; e < elements.size(); ++e)
          compute_element_points(nodes_of(elements[e]));
      }
    catch (const NumericalError &)
      {
        return true;
      }
    return false;
  }

  void LayerElements::continue_beyond(const PointPairs                &edges,
                                      const std::vector<unsigned int> &of_surface,
                                      const double                     length)
  {
    // What has been added beyond one edge goes on beyond the next one as well, or the quarter at
    // the corner of both would be missing. The added surface is no side to go on from.
    std::vector<char> surface(points.size(), false);
    for (const unsigned int point : of_surface)
      surface[point] = true;
    const SurfaceEnds ends = find_ends(*this, surface, edges);
    for (const auto &edge : edges)
      {
        const std::vector<Side> sides = FreeSides(*this, surface).find_at(edge);
        if (sides.empty())
          continue; // beyond which it goes on already
        const auto continue_by = [&](const bool alike) {
          std::vector<Side> row = sides;
          Continuation      beyond(*this, sides, ends, surface, alike);
          for (double done = 0.; done < length; done += beyond.width)
            {
              for (Side &side : row)
                side = beyond.add_element(side);
              beyond.tie_row();
            }
        };
        // Elements between small and large ones would fold, and so may rows whose lines converge:
        // then all go on alike.
        if (!hanging.empty())
          {
            continue_by(true);
            continue;
          }
        const LayerElements     before         = *this;
        const std::vector<char> surface_before = surface;
        continue_by(false);
        if (is_folded(before.elements.size()))
          {
            *this   = before;
            surface = surface_before;
            continue_by(true);
          }
      }
  }

  Eigen::MatrixXd LayerElements::find_flexibility(const std::vector<PointWeights> &means,
                                                  const Material                  &material,
                                                  const FemElement                 element) const
  {
    std::vector<int> first(points.size(), -1);
    int              n = 0;
    for (std::size_t p = 0; p < points.size(); ++p)
      if (!held[p] && hanging.count(p) == 0)
        {
          first[p] = n;
          n += 3;
        }
    // The unknowns by which a point moves.
    const auto unknowns_of = [&](const unsigned int point) {
      const auto         found = hanging.find(point);
      const PointWeights all   = found != hanging.end() ? found->second : PointWeights{{point, 1.}};
      std::vector<std::pair<int, double>> unknowns;
      for (const auto &[p, weight] : all)
        if (first[p] >= 0)
          unknowns.emplace_back(first[p], weight);
      return unknowns;
    };
    std::vector<Eigen::Triplet<double>> entries;
    for (const std::vector<unsigned int> &own : elements)
      {
        std::vector<std::vector<std::pair<int, double>>> unknowns;
        for (const unsigned int point : own)
          unknowns.push_back(unknowns_of(point));
        const Eigen::MatrixXd K = compute_fem_stiffness(nodes_of(own), material, element);
        for (Eigen::Index r = 0; r < K.rows(); ++r)
          for (Eigen::Index c = 0; c < K.cols(); ++c)
            for (const auto &[row, of_row] : unknowns[r / 3])
              for (const auto &[column, of_column] : unknowns[c / 3])
                entries.emplace_back(row + r % 3, column + c % 3, of_row * of_column * K(r, c));
      }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);

    // A column per unit force; the means are the products with the forces.
    const Eigen::Index          size = 3 * means.size();
    Eigen::SparseMatrix<double> forces(n, size);
    entries.clear();
    for (std::size_t k = 0; k < means.size(); ++k)
      for (const auto &[point, weight] : means[k])
        for (const auto &[unknown, part] : unknowns_of(point))
          for (unsigned int c = 0; c < 3; ++c)
            entries.emplace_back(unknown + c, 3 * k + c, weight * part);
    forces.setFromTriplets(entries.begin(), entries.end());
    Eigen::MatrixXd flexibility(size, size);
    for (Eigen::Index k = 0; k < size; ++k)
      flexibility.col(k) = forces.transpose() * solver.solve(Eigen::VectorXd(forces.col(k)));
    // Symmetric to the last digit, as conjugate gradients take it to be.
    return .5 * (flexibility + flexibility.transpose());
  }
} // namespace vfife
