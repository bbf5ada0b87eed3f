// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/surface/edge_sides.h>
#include <vfife/fem/pressure/flank_pair.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/load_shares.h>

#include <algorithm>
#include <set>

namespace vfife
{
  FlankPair::FlankPair(const FemSpace &space, const double depth)
    : space_(space)
    , averages_(space)
    , definition_(space.model().contacts.front())
    , depth_(depth)
    , bodies_{{definition_.slave_body, definition_.master_body}}
    , facets_{{&space.model().bodies[bodies_[0]].mesh().surfaces.at(definition_.slave_surface),
               &space.model().bodies[bodies_[1]].mesh().surfaces.at(definition_.master_surface)}}
    , surfaces_{
        {{*facets_[0], definition_.options.surface, EdgeRelief(*facets_[0], definition_.options)},
         {*facets_[1], definition_.options.surface, EdgeRelief(*facets_[1], definition_.options)}}}
  {
    for (unsigned int side = 0; side < 2; ++side)
      {
        materials_[side] =
          space.model().bodies[bodies_[side]].material_under(facets_[side]->nodes, "a flank");
        held_.emplace_back(materials_[side].poissons_ratio);
      }
  }

  void FlankPair::place(const unsigned int  side,
                        std::vector<double> positions,
                        const RigidMotion  &motion)
  {
    const Body &body = space_.model().bodies[bodies_[side]];
    positions_[side] = std::move(positions);
    rotations_[side] = motion.rotation * body.placement.rotation.transpose();
    surfaces_[side].bind({positions_[side].data(), nullptr, motion});
  }

  double FlankPair::torque_arm(const Vector3 &position, const Vector3 &normal) const
  {
    // The load turns the driven body against its sense and so closes the gap, n . (x_s - y).
    const Transmission &t     = *space_.model().transmission;
    const Axis         &axis  = space_.model().bodies[t.driven].axis;
    const double        sense = bodies_[1] == t.driven ? -t.driven_sense : t.driven_sense;
    return sense * normal.dot(axis.direction.cross(position - axis.point));
  }

  FacingSurfaces FlankPair::facing(const unsigned int slave_group,
                                   const unsigned int master_group,
                                   const double       depth_limit)
  {
    return {&surfaces_[0], &surfaces_[1], slave_group, master_group, depth_limit};
  }

  std::vector<unsigned int> FlankPair::nodes_of(const unsigned int side,
                                                const unsigned int group) const
  {
    std::set<unsigned int> nodes;
    for (std::size_t f = 0; f < facets_[side]->facets.size(); ++f)
      if (facets_[side]->group[f] == group)
        nodes.insert(facets_[side]->facets[f].begin(), facets_[side]->facets[f].end());
    return {nodes.begin(), nodes.end()};
  }

  unsigned int FlankPair::copy_of(const unsigned int side,
                                  const unsigned int node,
                                  const unsigned int group,
                                  const unsigned int copied) const
  {
    // Nodes of a surface are numbered tooth by tooth, each tooth's in the same order.
    const unsigned int n = facets_[side]->nodes.size() / facets_[side]->n_groups;
    return node - group * n + copied * n;
  }

  unsigned int FlankPair::point_of(const unsigned int side, const unsigned int node) const
  {
    return space_.find_part(bodies_[side])->first_point + facets_[side]->nodes[node];
  }

  const NearLayer &FlankPair::near_layer(const unsigned int side, const unsigned int group)
  {
    const auto known = near_.find({side, group});
    if (known != near_.end())
      return known->second;
    const FacetSurface       &facets = *facets_[side];
    std::vector<unsigned int> patch, others;
    for (const unsigned int node : nodes_of(side, group))
      patch.push_back(point_of(side, node));
    std::sort(patch.begin(), patch.end());
    const unsigned int first = space_.find_part(bodies_[side])->first_point;
    for (const auto &[name, other] : space_.model().bodies[bodies_[side]].mesh().surfaces)
      if (&other != &facets)
        for (const unsigned int node : other.nodes)
          others.push_back(first + node);
    return near_
      .emplace(
        std::make_pair(side, group),
        find_near_layer(space_, std::move(patch), averages_, others, depth_, edges_of(side, group)))
      .first->second;
  }

  PointPairs FlankPair::edges_of(const unsigned int side, const unsigned int group) const
  {
    const FacetSurface                             &facets = *facets_[side];
    const Body                                     &body   = space_.model().bodies[bodies_[side]];
    const FemSpace::Part                           &part   = *space_.find_part(bodies_[side]);
    std::set<std::pair<unsigned int, unsigned int>> on_edges; // nodes of the body
    for (std::size_t f = 0; f < facets.facets.size(); ++f)
      for (unsigned int k = 0; k < 4; ++k)
        if (facets.group[f] == group && edge_number(facets, f, k) != 0) // tip, toe and heel
          {
            const unsigned int a = facets.nodes[facets.facets[f][k]],
                               b = facets.nodes[facets.facets[f][(k + 1) % 4]];
            on_edges.emplace(std::min(a, b), std::max(a, b));
          }
    std::vector<unsigned int> nodes;
    for (const unsigned int node : nodes_of(side, group))
      nodes.push_back(facets.nodes[node]);
    PointPairs         edges;
    const unsigned int n = space_.degree() + 1;
    for (const BoundaryFace &face : find_boundary_faces(body, nodes, faces_of(facets)))
      for (unsigned int k = 0; k < 4; ++k)
        {
          const unsigned int a = face.nodes[k], b = face.nodes[(k + 1) % 4];
          if (on_edges.count({std::min(a, b), std::max(a, b)}) == 0)
            continue;
          // From a to b along the same sides of the elements' faces.
          const std::array<unsigned int, 5>    corners = {{0, n - 1, n * n - 1, n * (n - 1), 0}};
          std::map<unsigned int, unsigned int> next;
          for (const auto &points : space_.points_on_face(part, face.element, face.number))
            next[points[corners[k]]] = points[corners[k + 1]];
          for (unsigned int at = part.first_point + a; at != part.first_point + b; at = next.at(at))
            edges.push_back({{at, next.at(at)}});
        }
    return edges;
  }

  ElasticFlank FlankPair::make_flank(const unsigned int               side,
                                     const unsigned int               group,
                                     const unsigned int               copied,
                                     const std::vector<unsigned int> &places)
  {
    const Body  &body = space_.model().bodies[bodies_[side]];
    ElasticFlank flank;
    flank.near = &near_layer(side, copied);
    // The copied tooth stands at time zero where the axes of the flexibility do; this one has been
    // turned by so many pitches besides.
    flank.rotation       = rotations_[side] * rotation_about(compute_sector_axis(body).direction,
                                                       2. * pi * (double(group) - double(copied)) /
                                                         facets_[side]->n_groups);
    flank.youngs_modulus = materials_[side].youngs_modulus;
    flank.poissons_ratio = materials_[side].poissons_ratio;
    flank.held           = &held_[side];
    flank.places.assign(facets_[side]->nodes.size(), ElasticFlank::no_place);
    flank.near_places = flank.places;
    for (const unsigned int node : nodes_of(side, group))
      {
        const unsigned int point = point_of(side, copy_of(side, node, group, copied));
        const auto        &near  = flank.near->points;
        flank.places[node]       = places[point];
        flank.near_places[node]  = std::lower_bound(near.begin(), near.end(), point) - near.begin();
      }
    return flank;
  }

  ToothPressure FlankPair::describe(const unsigned int slave_group,
                                    const unsigned int master_group,
                                    GridPressure       grid) const
  {
    ToothPressure tooth{slave_group, master_group, std::move(grid), {}};
    for (unsigned int side = 0; side < 2; ++side)
      tooth.places[side] = places_of(side, tooth.grid.cells);
    return tooth;
  }

  std::vector<Vector3> FlankPair::places_of(const unsigned int              side,
                                            const std::vector<ContactCell> &cells) const
  {
    std::vector<Vector3> places;
    for (const ContactCell &cell : cells)
      {
        Vector3 x = Vector3::Zero();
        for (unsigned int k = 0; k < 4; ++k)
          x += cell.feet[side].weights[k] * facets_[side]->positions[cell.feet[side].nodes[k]];
        places.push_back(x);
      }
    return places;
  }
} // namespace vfife
