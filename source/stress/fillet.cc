// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/boundary_surface.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/model/body.h>
#include <vfife/stress/fillet.h>

#include <algorithm>

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

      /** Profiles of nodes from toe to heel, each from the root land up. */
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
        Edge edge;
        find_edge([this](const unsigned int from, unsigned int) { return contains(toe_, from); },
                  edge);
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
  } // namespace

  Fillet::Fillet(const Body &body, const std::string &side)
    : side_(side)
    , structure_(&body.structure())
  {
    find_nodes(body);
    measure(body);
    material_ = body.material_under(nodes_, side + " fillets");
  }

  unsigned int Fillet::n_teeth() const
  {
    return structure_->n_sectors();
  }

  void Fillet::find_nodes(const Body &body)
  {
    const FilletSurface surface(body, side_);
    const auto          profiles = surface.find_profiles();
    mirrored_                    = surface.has_toe_on_right();
    n_columns_                   = profiles.size() - 1;
    n_rows_                      = profiles.front().size() - 1;
    for (const auto &profile : profiles)
      nodes_.insert(nodes_.end(), profile.begin(), profile.end());
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
