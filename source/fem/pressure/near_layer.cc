// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/sample_measures.h>
#include <vfife/fem/pressure/near_layer.h>
#include <vfife/model/model.h>

#include <algorithm>
#include <limits>
#include <set>

namespace vfife
{
  namespace
  {
    /** How far a layer goes on beyond an edge, in depths: what it does there is gone then. */
    constexpr double reach = 2.;

    /** Elements under a patch of points, layer by layer. */
    class LayeredElements
    {
    public:
      LayeredElements(const FemSpace &space, const std::vector<unsigned int> &patch)
        : space_(space)
        , part_(space.part_of_point(patch.front()))
        , reached_(part_.n_points, false)
        , used_(space.n_body_elements(part_), false)
      {
        for (const unsigned int point : patch)
          reached_[point - part_.first_point] = true;
      }

      /** The elements that share a point with what has been reached and have none of @p others;
       * says whether there are new ones. */
      bool add_layer(const std::vector<bool> &others)
      {
        std::vector<bool> now = used_;
        for (unsigned int e = 0; e < part_.n_elements; ++e)
          if (has_point(e, reached_))
            now[parent(e)] = true;
        for (unsigned int e = 0; e < part_.n_elements; ++e)
          if (now[parent(e)] && !is_used(e) && has_point(e, others))
            now[parent(e)] = false;
        if (now == used_)
          return false;
        used_ = std::move(now);
        for (unsigned int e = 0; e < part_.n_elements; ++e)
          if (is_used(e))
            for_points(e, [this](const unsigned int p) { reached_[p] = true; });
        return true;
      }

      /** 0: not in the layers, 1: free, 2: held, since elements outside have it too. By point of
       * the part. */
      std::vector<unsigned char> find_states() const
      {
        std::vector<unsigned char> states(part_.n_points, 0);
        for (unsigned int e = 0; e < part_.n_elements; ++e)
          if (is_used(e))
            for_points(e, [&states](const unsigned int p) { states[p] = 1; });
        const auto hold = [&states](const unsigned int p) {
          if (states[p] != 0)
            states[p] = 2;
        };
        const auto hold_all = [&](const unsigned int p) {
          hold(p);
          // Points that move one outside, of larger elements inside.
          if (const auto hanging = space_.hanging().find(part_.first_point + p);
              hanging != space_.hanging().end())
            for (const auto &master : hanging->second)
              hold(master.first - part_.first_point);
        };
        for (unsigned int e = 0; e < part_.n_elements; ++e)
          if (!is_used(e))
            for_points(e, hold_all);
        return states;
      }

      /** The elements by themselves; @p numbers: of their points, by point of the part. */
      LayerElements make_elements(const std::vector<unsigned char> &states,
                                  std::vector<unsigned int>        &numbers) const;

      const FemSpace::Part &part() const
      {
        return part_;
      }

      /** Of the elements in the layers. Throws InputError where they have several. */
      const Material &material() const
      {
        const Material *found = nullptr;
        for (unsigned int e = 0; e < part_.n_elements; ++e)
          if (is_used(e))
            {
              const Material &here = space_.material(part_.first_element + e);
              if (found != nullptr && found != &here)
                throw InputError("the layers of elements under a surface in contact have the "
                                 "materials \"" +
                                 found->name + "\" and \"" + here.name +
                                 "\". The pressure on its own grid requires one material");
              found = &here;
            }
        return *found;
      }

    private:
      template <typename Function>
      void for_points(const unsigned int e, const Function &function) const
      {
        const unsigned int *points = space_.element_points(part_.first_element + e);
        for (unsigned int a = 0; a < space_.points_per_element(); ++a)
          function(points[a] - part_.first_point);
      }
      /** The body's element of an element of the part. */
      unsigned int parent(const unsigned int e) const
      {
        return space_.body_element(part_.first_element + e);
      }
      bool is_used(const unsigned int e) const
      {
        return used_[parent(e)];
      }
      bool has_point(const unsigned int e, const std::vector<bool> &which) const
      {
        bool found = false;
        for_points(e, [&](const unsigned int p) { found = found || which[p]; });
        return found;
      }

      const FemSpace       &space_;
      const FemSpace::Part &part_;
      std::vector<bool>     reached_;
      std::vector<bool>     used_; ///< elements of the body
    };

    LayerElements LayeredElements::make_elements(const std::vector<unsigned char> &states,
                                                 std::vector<unsigned int>        &numbers) const
    {
      LayerElements layer;
      numbers.assign(states.size(), 0);
      for (std::size_t p = 0; p < states.size(); ++p)
        if (states[p] != 0)
          {
            numbers[p] = layer.points.size();
            layer.points.push_back(space_.points()[part_.first_point + p]);
            layer.held.push_back(states[p] == 2);
          }
      for (unsigned int e = 0; e < part_.n_elements; ++e)
        if (is_used(e))
          {
            layer.elements.emplace_back();
            for_points(e,
                       [&](const unsigned int p) { layer.elements.back().push_back(numbers[p]); });
          }
      for (const auto &[point, masters] : space_.hanging())
        if (point >= part_.first_point && point < part_.first_point + part_.n_points &&
            states[point - part_.first_point] != 0)
          {
            PointWeights &own = layer.hanging[numbers[point - part_.first_point]];
            for (const auto &[master, weight] : masters)
              if (states[master - part_.first_point] != 0) // those outside are held
                own.emplace_back(numbers[master - part_.first_point], weight);
          }
      return layer;
    }

    /** From each point of the patch to the nearest one that is held; none: infinite. */
    std::vector<double> find_depths(const FemSpace                   &space,
                                    const FemSpace::Part             &part,
                                    const std::vector<unsigned char> &states,
                                    const std::vector<unsigned int>  &patch)
    {
      std::vector<double> depths;
      for (const unsigned int point : patch)
        {
          double nearest = std::numeric_limits<double>::infinity();
          for (std::size_t p = 0; p < states.size(); ++p)
            if (states[p] == 2)
              nearest =
                std::min(nearest,
                         (space.points()[part.first_point + p] - space.points()[point]).norm());
          depths.push_back(nearest);
        }
      return depths;
    }
  } // namespace

  double NearLayer::mean_depth() const
  {
    return mean_of(depths);
  }

  NearLayer find_near_layer(const FemSpace                  &space,
                            std::vector<unsigned int>        patch,
                            std::vector<PointWeights>        means,
                            const std::vector<unsigned int> &others,
                            const double                     depth,
                            const PointPairs                &edges)
  {
    std::set<unsigned int> surface;
    for (const PointWeights &mean : means)
      for (const auto &weight : mean)
        surface.insert(weight.first);
    LayeredElements       elements(space, {surface.begin(), surface.end()});
    const FemSpace::Part &part = elements.part();
    std::vector<bool>     is_other(part.n_points, false);
    for (const unsigned int point : others)
      is_other[point - part.first_point] = true;

    NearLayer                  layer;
    std::vector<unsigned char> states;
    while (elements.add_layer(is_other))
      {
        std::vector<unsigned char> now    = elements.find_states();
        std::vector<double>        depths = find_depths(space, part, now, patch);
        // Nothing is left that would hold these.
        if (depths.front() == std::numeric_limits<double>::infinity())
          break;
        ++layer.n_layers;
        states       = std::move(now);
        layer.depths = std::move(depths);
        if (layer.mean_depth() >= depth)
          break;
      }
    // A point of the surface that is held itself has no flexibility of its own.
    for (const unsigned int point : surface)
      if (states.empty() || states[point - part.first_point] != 1)
        throw InputError(
          "body \"" + space.model().bodies[part.body].name() +
          "\": no layer of elements under the surface in contact adjoins other elements. The "
          "pressure on its own grid requires two elements across a tooth");
    std::vector<unsigned int> numbers, of_surface;
    LayerElements             by_itself = elements.make_elements(states, numbers);
    const auto                number_of = [&](const unsigned int point) {
      return numbers[point - part.first_point];
    };
    for (const unsigned int point : surface)
      of_surface.push_back(number_of(point));
    for (PointWeights &mean : means)
      for (auto &weight : mean)
        weight.first = number_of(weight.first);
    PointPairs own_edges;
    for (const auto &edge : edges)
      own_edges.push_back({{number_of(edge[0]), number_of(edge[1])}});
    by_itself.continue_beyond(own_edges, of_surface, reach * layer.mean_depth());
    layer.flexibility = by_itself.find_flexibility(means, elements.material(), space.element());
    layer.points      = std::move(patch);
    return layer;
  }
} // namespace vfife
