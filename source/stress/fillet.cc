// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/boundary_surface.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/model/body.h>
#include <vfife/model/load_shares.h>
#include <vfife/stress/fillet.h>

#include <algorithm>
#include <map>

namespace vfife
{
  namespace
  {
    const char *fillet_set(const std::string &side)
    {
      return side == surface_name::concave ? node_set::concave_fillet : node_set::convex_fillet;
    }

    bool contains(const std::vector<unsigned int> &sorted, const unsigned int node)
    {
      return std::binary_search(sorted.begin(), sorted.end(), node);
    }

    /** Facets of the fillet of tooth 0 and of what lies beside it. */
    class FilletSurface
    {
    public:
      FilletSurface(const Body &body, const std::string &side)
        : fillet_(first_sectors(body, fillet_set(side), 1))
        , flank_(first_sectors(body, side, 1))
        , toe_(first_sectors(body, node_set::toe, 1))
        , surface_(surface_of_boundary(body.mesh().triangulation, side, all_nodes(body)))
      {
      }

      /** Profiles of nodes from toe to heel, each from the root land up. Throws InputError where
       * fillet and flank do not meet at the toe. */
      std::vector<std::vector<unsigned int>> find_profiles() const
      {
        std::vector<std::vector<unsigned int>> profiles;
        Edge                                   start = find_first_edge();
        profiles.push_back(walk(start, true));
        for (bool more = true; more;)
          {
            profiles.push_back(walk(start, false));
            more = find_next_edge(start);
          }
        return profiles;
      }

      /** Whether the toe is on the right, seen from outside with the flank above. */
      bool has_toe_on_right() const
      {
        // Round a facet its upper side runs from right to left.
        return find_first_edge().forward;
      }

    private:
      /** A side of a facet of the fillet at the start of the flank; whether it runs from toe to
       * heel in the facet's own sense. */
      struct Edge
      {
        unsigned int facet = 0, side = 0;
        bool         forward = true;
      };

      /** The nodes of a set in the first sectors. */
      static std::vector<unsigned int>
      first_sectors(const Body &body, const std::string &set, const unsigned int n_sectors)
      {
        std::vector<unsigned int> nodes = body.node_set(set);
        nodes.erase(std::remove_if(nodes.begin(),
                                   nodes.end(),
                                   [&](const unsigned int node) {
                                     return body.structure().sector_of(node) >= n_sectors;
                                   }),
                    nodes.end());
        std::sort(nodes.begin(), nodes.end());
        return nodes;
      }
      std::vector<unsigned int> all_nodes(const Body &body) const
      {
        // The centre of the slot above the tooth belongs to the next sector.
        std::vector<unsigned int> all = first_sectors(body, node_set::root_land, 2);
        all.insert(all.end(), fillet_.begin(), fillet_.end());
        all.insert(all.end(), flank_.begin(), flank_.end());
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
      }

      unsigned int corner(const unsigned int facet, const unsigned int k) const
      {
        return surface_.nodes[surface_.facets[facet][k % 4]];
      }
      bool is_fillet(const unsigned int facet) const
      {
        for (unsigned int k = 0; k < 4; ++k)
          if (!contains(fillet_, corner(facet, k)))
            return false;
        return true;
      }

      /** Ends of an edge, (towards the toe, towards the heel). */
      std::pair<unsigned int, unsigned int> ends(const Edge &edge) const
      {
        const unsigned int a = corner(edge.facet, edge.side), b = corner(edge.facet, edge.side + 1);
        return edge.forward ? std::make_pair(a, b) : std::make_pair(b, a);
      }

      /** Edges of the fillet's facets that lie on the start of the flank. */
      template <typename Test>
      bool find_edge(const Test &takes, Edge &found) const
      {
        for (unsigned int f = 0; f < surface_.facets.size(); ++f)
          for (unsigned int k = 0; k < 4; ++k)
            {
              const unsigned int a = corner(f, k), b = corner(f, k + 1);
              if (contains(flank_, a) && contains(flank_, b) && is_fillet(f))
                for (const bool forward : {true, false})
                  if (takes(forward ? a : b, forward ? b : a))
                    {
                      found = {f, k, forward};
                      return true;
                    }
            }
        return false;
      }

      Edge find_first_edge() const
      {
        Edge       edge;
        const auto at_toe = [this](const unsigned int from, unsigned int) {
          return contains(toe_, from);
        };
        if (!find_edge(at_toe, edge))
          throw InputError("expected an edge between fillet and flank at the node set \"toe\", "
                           "got none. Let the set have the end of the flank.");
        return edge;
      }

      /** Goes on along the face; false at the heel. */
      bool find_next_edge(Edge &edge) const
      {
        const auto here = ends(edge);
        return find_edge(
          [&here](const unsigned int from, const unsigned int to) {
            return from == here.second && to != here.first;
          },
          edge);
      }

      /** One end of each edge across from the one before it, from the root land up, beside the
       * facets of a column. */
      std::vector<unsigned int> walk(const Edge &start, const bool at_toe) const
      {
        const auto take = [at_toe](const std::pair<unsigned int, unsigned int> &two) {
          return at_toe ? two.first : two.second;
        };
        // Down the fillet, and across one facet of the root land.
        std::vector<unsigned int> profile = {take(ends(start))};
        Edge                      edge    = start;
        for (bool inside = true; inside;)
          {
            inside = is_fillet(edge.facet);
            edge   = {edge.facet, (edge.side + 2) % 4, !edge.forward};
            profile.push_back(take(ends(edge)));
            if (inside)
              edge = across(edge);
          }
        std::reverse(profile.begin(), profile.end());
        // Up across one facet of the flank.
        edge = across(start);
        edge = {edge.facet, (edge.side + 2) % 4, !edge.forward};
        profile.push_back(take(ends(edge)));
        return profile;
      }

      /** The same edge as a side of the neighbour. */
      Edge across(const Edge &edge) const
      {
        const unsigned int a     = corner(edge.facet, edge.side);
        const unsigned int other = surface_.neighbours[edge.facet][edge.side];
        for (unsigned int k = 0; other != FacetSurface::no_facet && k < 4; ++k)
          if (corner(other, k + 1) == a)
            return {other, k, !edge.forward};
        throw InputError("the surface " + surface_.name + " has no flank next to its fillet");
      }

      std::vector<unsigned int> fillet_, flank_, toe_;
      FacetSurface              surface_;
    };

    /** Nodes of sector 0 on a circle about the axis, in the order of their angles. */
    struct Circle
    {
      Vector2                   r_z; ///< [mm]
      std::vector<unsigned int> nodes;
    };

    /** Far below the size of an element [mm]. */
    constexpr double same_circle = 1e-5;

    /** Circles on which the nodes of a set are, by rising radii. */
    std::vector<Circle> find_circles(const Body &body, const std::vector<unsigned int> &set)
    {
      const auto         &X = body.node_positions();
      std::vector<Circle> circles;
      for (const unsigned int node : set)
        {
          if (body.structure().sector_of(node) != 0)
            continue;
          const Vector2 r_z(X[node].head<2>().norm(), X[node][2]);
          const auto found = std::find_if(circles.begin(), circles.end(), [&](const Circle &one) {
            return (one.r_z - r_z).norm() < same_circle;
          });
          if (found == circles.end())
            circles.push_back({r_z, {node}});
          else
            found->nodes.push_back(node);
        }
      for (Circle &circle : circles)
        {
          const auto angle = [&,
                              first = polar_angle(X[circle.nodes.front()])](const unsigned int i) {
            return std::remainder(polar_angle(X[i]) - first, 2. * pi);
          };
          std::sort(circle.nodes.begin(), circle.nodes.end(), [&](const auto a, const auto b) {
            return angle(a) < angle(b);
          });
        }
      std::sort(circles.begin(), circles.end(), [](const Circle &a, const Circle &b) {
        return a.r_z[0] < b.r_z[0];
      });
      return circles;
    }
  } // namespace

  std::vector<std::string> Fillet::list_sides(const Body &body)
  {
    std::vector<std::string> sides = {surface_name::concave, surface_name::convex};
    for (const auto &[side, set] : {std::make_pair(hub_front, node_set::hub_fillet_front),
                                    std::make_pair(hub_back, node_set::hub_fillet_back)})
      if (body.has_node_set(set))
        sides.emplace_back(side);
    return sides;
  }

  Fillet::Fillet(const Body &body, const std::string &side)
    : side_(side)
    , structure_(&body.structure())
  {
    if (is_at_hub())
      find_nodes_at_hub(body);
    else
      find_nodes_of_tooth(body);
    measure(body);
    material_ = body.material_under(nodes_, side + " fillets");
    if (body.has_initial_strains())
      find_initial_strains(body);
  }

  void Fillet::find_initial_strains(const Body &body)
  {
    const auto sorted = [](std::array<unsigned int, 4> nodes) {
      std::sort(nodes.begin(), nodes.end());
      return nodes;
    };
    std::map<std::array<unsigned int, 4>, double> strains;
    for (const BoundaryFace &face : find_boundary_faces(body, list_nodes()))
      strains[sorted(face.nodes)] = body.initial_strain(face.element);
    for (unsigned int tooth = 0; tooth < n_teeth(); ++tooth)
      for (unsigned int column = 0; column < n_columns_; ++column)
        for (unsigned int row = 0; row < n_rows_; ++row)
          initial_strains_.push_back(strains.at(sorted(facet(column, row, tooth))));
  }

  double Fillet::initial_strain(const unsigned int column,
                                const unsigned int row,
                                const unsigned int tooth) const
  {
    return initial_strains_.empty()
             ? 0.
             : initial_strains_[(std::size_t(tooth) * n_columns_ + column) * n_rows_ + row];
  }

  SurfaceTensor Fillet::without_initial_strain(const SurfaceTensor &strain,
                                               const unsigned int   column,
                                               const unsigned int   row,
                                               const unsigned int   tooth) const
  {
    return strain - initial_strain(column, row, tooth) * SurfaceTensor(1., 1., 0.);
  }

  std::vector<unsigned int> Fillet::list_nodes() const
  {
    std::vector<unsigned int> nodes;
    for (unsigned int tooth = 0; tooth < n_teeth(); ++tooth)
      for (unsigned int column = 0; column <= n_columns_; ++column)
        for (unsigned int row = 0; row <= n_rows_; ++row)
          nodes.push_back(node(column, row, tooth));
    return nodes;
  }

  unsigned int Fillet::n_teeth() const
  {
    return structure_->n_sectors();
  }

  void Fillet::find_nodes_of_tooth(const Body &body)
  {
    const FilletSurface surface(body, side_);
    const auto          profiles = surface.find_profiles();
    mirrored_                    = surface.has_toe_on_right();
    n_columns_                   = profiles.size() - 1;
    n_rows_                      = profiles.front().size() - 1;
    for (const auto &profile : profiles)
      nodes_.insert(nodes_.end(), profile.begin(), profile.end());
  }

  void Fillet::find_nodes_at_hub(const Body &body)
  {
    const bool is_front = side_ == hub_front;
    const auto circles  = find_circles(body,
                                      body.node_set(is_front ? node_set::hub_fillet_front
                                                             : node_set::hub_fillet_back));
    // The fillet is tangent to the hub, of which it leaves the outside.
    const Circle &bottom  = circles.front();
    const double  outward = bottom.r_z[1] > circles[1].r_z[1] ? 1. : -1.;
    const auto    web =
      find_circles(body, body.node_set(is_front ? node_set::web_front : node_set::web_back));
    const auto    above = std::find_if(web.begin(), web.end(), [&](const Circle &circle) {
      return circle.r_z[0] > circles.back().r_z[0] + same_circle;
    });
    const Circle *below = nullptr;
    const auto    hub   = find_circles(body, body.node_set(node_set::hub));
    for (const Circle &circle : hub)
      {
        const double away = outward * (circle.r_z[1] - bottom.r_z[1]);
        if (std::abs(circle.r_z[0] - bottom.r_z[0]) < same_circle && away > same_circle &&
            (below == nullptr || away < outward * (below->r_z[1] - bottom.r_z[1])))
          below = &circle;
      }
    if (above == web.end() || below == nullptr)
      throw InputError("body \"" + body.name() + "\": the " + side_ +
                       " fillet has no row of elements beside it");
    std::vector<const Circle *> rows = {below};
    for (const Circle &circle : circles)
      rows.push_back(&circle);
    rows.push_back(&*above);
    mirrored_  = outward > 0.;
    n_columns_ = bottom.nodes.size();
    n_rows_    = rows.size() - 1;
    for (unsigned int column = 0; column <= n_columns_; ++column)
      for (const Circle *row : rows)
        nodes_.push_back(column < n_columns_ ? row->nodes[column]
                                             : structure_->copy(row->nodes.front(), 1));
  }

  void Fillet::measure(const Body &body)
  {
    const auto place = [&](const unsigned int column, const unsigned int row) {
      return body.node_positions()[node(column, row, 0)];
    };
    face_.assign(nodes_.size(), 0.);
    profile_.assign(nodes_.size(), 0.);
    for (unsigned int column = 0; column <= n_columns_; ++column)
      for (unsigned int row = 0; row <= n_rows_; ++row)
        {
          if (column > 0)
            face_[index(column, row)] =
              face_[index(column - 1, row)] + (place(column, row) - place(column - 1, row)).norm();
          if (row > 0)
            profile_[index(column, row)] = profile_[index(column, row - 1)] +
                                           (place(column, row) - place(column, row - 1)).norm();
        }
    for (unsigned int column = 0; column <= n_columns_; ++column)
      {
        const double bottom = profile_[index(column, first_row)];
        for (unsigned int row = 0; row <= n_rows_; ++row)
          profile_[index(column, row)] -= bottom;
      }
  }

  unsigned int
  Fillet::node(const unsigned int column, const unsigned int row, const unsigned int tooth) const
  {
    return structure_->copy(nodes_[index(column, row)], tooth);
  }

  std::array<unsigned int, 4>
  Fillet::facet(const unsigned int column, const unsigned int row, const unsigned int tooth) const
  {
    // Where the toe is on the right, the first side runs from heel to toe.
    const unsigned int from = mirrored_ ? column + 1 : column, to = mirrored_ ? column : column + 1;
    return {{node(from, row, tooth),
             node(to, row, tooth),
             node(to, row + 1, tooth),
             node(from, row + 1, tooth)}};
  }

  Vector2 Fillet::centre(const unsigned int column, const unsigned int row) const
  {
    Vector2 sum = Vector2::Zero();
    for (const unsigned int c : {column, column + 1})
      for (const unsigned int r : {row, row + 1})
        sum += Vector2(face_length(c, r), profile_length(c, r));
    return sum / 4.;
  }
} // namespace vfife
