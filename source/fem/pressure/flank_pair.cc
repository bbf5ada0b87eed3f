// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/facet_surface.h>
#include <vfife/fem/pressure/flank_pair.h>
#include <vfife/fem/statics/compliance.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/load_shares.h>

#include <algorithm>
#include <set>

namespace vfife
{
  PointPlaces::PointPlaces(const Compliance &compliance)
    : nodes(compliance.space().n_points(), ElasticFlank::no_place)
    , surface(nodes)
  {
    unsigned int place = 0;
    for (const unsigned int point : compliance.watched())
      nodes[point] = place++;
    for (const unsigned int point : compliance.surface_points())
      surface[point] = place++;
  }

  FlankPair::FlankPair(const FemSpace &space, const double depth)
    : space_(space)
    , averages_(space)
    , facet_parts_(space)
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

  void FlankPair::bend(std::vector<double> displacements)
  {
    displacements_ = std::move(displacements);
  }

  double FlankPair::torque_arm(const Vector3 &position, const Vector3 &normal) const
  {
    // The load turns the driven body against its sense and so closes the gap, n . (x_s - y).
    const Transmission &t     = *space_.model().only_transmission();
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
    return list_group_nodes(*facets_[side], group);
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
    std::set<unsigned int>    points;
    std::vector<unsigned int> others;
    for (std::size_t f = 0; f < facets.facets.size(); ++f)
      if (facets.group[f] == group)
        for (const FacetParts::Corners &part : facet_parts_.of(corners_of(side, f, group, group)))
          points.insert(part.begin(), part.end());
    std::vector<PointWeights> means;
    for (const unsigned int point : points)
      means.push_back(facet_parts_.mean_of(point));
    const unsigned int first = space_.find_part(bodies_[side])->first_point;
    for (const auto &[name, other] : space_.model().bodies[bodies_[side]].mesh().surfaces)
      if (&other != &facets)
        for (const unsigned int node : other.nodes)
          others.push_back(first + node);
    return near_
      .emplace(std::make_pair(side, group),
               find_near_layer(space_,
                               {points.begin(), points.end()},
                               std::move(means),
                               others,
                               depth_,
                               edges_of(side, group)))
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

  FacetParts::Corners FlankPair::corners_of(const unsigned int side,
                                            const unsigned int facet,
                                            const unsigned int group,
                                            const unsigned int copied) const
  {
    FacetParts::Corners corners;
    for (unsigned int k = 0; k < 4; ++k)
      corners[k] = point_of(side, copy_of(side, facets_[side]->facets[facet][k], group, copied));
    return corners;
  }

  std::vector<FlankPart> FlankPair::make_parts(const unsigned int  side,
                                               const unsigned int  facet,
                                               const unsigned int  copied,
                                               const PointPlaces  &places,
                                               const ElasticFlank &flank) const
  {
    const FacetParts::Corners nodes = corners_of(side, facet, facets_[side]->group[facet], copied);
    std::array<Vector3, 4>    x;
    for (unsigned int k = 0; k < 4; ++k)
      x[k] = space_.points()[nodes[k]];
    const std::vector<FacetParts::Corners> points = facet_parts_.of(nodes);
    const auto                            &near   = flank.near->points;
    std::vector<FlankPart>                 parts;
    for (const FacetParts::Corners &corners : points)
      {
        FlankPart part;
        for (unsigned int k = 0; k < 4; ++k)
          {
            const unsigned int point = corners[k];
            part.corners[k] =
              corners == nodes ? unit_square[k] : place_on_facet(x, space_.points()[point]);
            part.places[k] = places.surface[point] != ElasticFlank::no_place ? places.surface[point]
                                                                             : places.nodes[point];
            part.near_places[k] = std::lower_bound(near.begin(), near.end(), point) - near.begin();
            part.bulges[k].setZero();
          }
        parts.push_back(part);
      }
    if (!displacements_.empty() && points.front() != nodes)
      find_bulges(side, nodes, points, parts);
    return parts;
  }

  void FlankPair::find_bulges(const unsigned int                      side,
                              const FacetParts::Corners              &nodes,
                              const std::vector<FacetParts::Corners> &points,
                              std::vector<FlankPart>                 &parts) const
  {
    std::array<Vector3, 4> u;
    for (unsigned int k = 0; k < 4; ++k)
      u[k] = compute_mean(averages_.of(nodes[k]), displacements_);
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (unsigned int k = 0; k < 4; ++k)
        {
          const auto N     = bilinear_weights(parts[i].corners[k][0], parts[i].corners[k][1]);
          Vector3    bulge = compute_mean(facet_parts_.mean_of(points[i][k]), displacements_);
          for (unsigned int j = 0; j < 4; ++j)
            bulge -= N[j] * u[j];
          parts[i].bulges[k] = rotations_[side] * bulge;
        }
  }

  ElasticFlank FlankPair::make_flank(const unsigned int side,
                                     const unsigned int group,
                                     const unsigned int copied,
                                     const PointPlaces &places)
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
    for (const unsigned int node : nodes_of(side, group))
      flank.places[node] = places.nodes[point_of(side, copy_of(side, node, group, copied))];
    flank.parts.resize(facets_[side]->facets.size());
    for (std::size_t f = 0; f < flank.parts.size(); ++f)
      if (facets_[side]->group[f] == group)
        flank.parts[f] = make_parts(side, f, copied, places, flank);
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
