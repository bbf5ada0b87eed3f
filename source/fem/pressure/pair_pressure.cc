// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/surface/edge_sides.h>
#include <vfife/fem/pressure/pair_pressure.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/load_torque.h>
#include <vfife/model/model.h>

#include <algorithm>
#include <set>

namespace vfife
{
  namespace
  {
    std::vector<unsigned int> nodes_of_group(const FacetSurface &surface, const unsigned int group)
    {
      std::set<unsigned int> nodes;
      for (std::size_t f = 0; f < surface.facets.size(); ++f)
        if (surface.group[f] == group)
          for (const unsigned int corner : surface.facets[f])
            nodes.insert(surface.nodes[corner]);
      return {nodes.begin(), nodes.end()};
    }
  } // namespace

  /** Both surfaces of a contact pair where they have come to. */
  struct PairPressure::Flanks
  {
    const ContactPair                  &definition;
    std::array<unsigned int, 2>         bodies;
    std::array<const FacetSurface *, 2> facets;
    std::array<SurfaceGeometry, 2>      surfaces; ///< slave, master
    std::array<std::vector<double>, 2>  positions;
    std::array<Matrix3, 2>              rotations; ///< since time zero

    Flanks(const Model &model, const ContactPair &pair)
      : definition(pair)
      , bodies{{pair.slave_body, pair.master_body}}
      , facets{{&model.bodies[pair.slave_body].mesh().surfaces.at(pair.slave_surface),
                &model.bodies[pair.master_body].mesh().surfaces.at(pair.master_surface)}}
      , surfaces{{{*facets[0], pair.options.surface, EdgeRelief(*facets[0], pair.options)},
                  {*facets[1], pair.options.surface, EdgeRelief(*facets[1], pair.options)}}}
    {
    }
  };

  PairPressure::PairPressure(Compliance        &compliance,
                             const double       depth,
                             const unsigned int cells_across)
    : compliance_(compliance)
    , model_(compliance.discretization().model())
    , depth_(depth)
    , cells_across_(cells_across)
    , places_(compliance.discretization().n_points(), ElasticFlank::no_place)
  {
    flanks_ = std::make_unique<Flanks>(model_, model_.contacts.front());
    for (const unsigned int body : flanks_->bodies)
      held_.emplace_back(model_.bodies[body].material().poissons_ratio);
    for (std::size_t i = 0; i < compliance.watched().size(); ++i)
      places_[compliance.watched()[i]] = i;
  }

  PairPressure::~PairPressure() = default;

  const NearLayer &PairPressure::near_layer(const unsigned int body,
                                            const std::string &surface,
                                            const unsigned int group)
  {
    const auto key   = std::make_tuple(body, surface, group);
    const auto known = near_.find(key);
    if (known != near_.end())
      return known->second;
    const Discretization     &d      = compliance_.discretization();
    const unsigned int        first  = d.find_part(body)->first_point;
    const FacetSurface       &facets = model_.bodies[body].mesh().surfaces.at(surface);
    std::vector<unsigned int> patch, others;
    for (const unsigned int node : nodes_of_group(facets, group))
      patch.push_back(first + node);
    PointPairs edges; // tip, toe and heel
    for (std::size_t f = 0; f < facets.facets.size(); ++f)
      for (unsigned int side = 0; side < 4; ++side)
        if (facets.group[f] == group && edge_number(facets, f, side) != 0)
          {
            const auto point = [&](const unsigned int corner) {
              return first + facets.nodes[facets.facets[f][corner % 4]];
            };
            edges.push_back({{point(side), point(side + 1)}});
          }
    for (const auto &[name, other] : model_.bodies[body].mesh().surfaces)
      if (name != surface)
        for (const unsigned int node : other.nodes)
          others.push_back(first + node);
    return near_.emplace(key, find_near_layer(d, std::move(patch), others, depth_, edges))
      .first->second;
  }

  ElasticFlank PairPressure::make_flank(const unsigned int side, const unsigned int group)
  {
    const Flanks       &flanks = *flanks_;
    const unsigned int  body   = flanks.bodies[side];
    const FacetSurface &facets = *flanks.facets[side];
    const unsigned int  first  = compliance_.discretization().find_part(body)->first_point;
    ElasticFlank        flank;
    flank.near =
      &near_layer(body,
                  side == 0 ? flanks.definition.slave_surface : flanks.definition.master_surface,
                  group);
    flank.rotation       = flanks.rotations[side];
    flank.youngs_modulus = model_.bodies[body].material().youngs_modulus;
    flank.poissons_ratio = model_.bodies[body].material().poissons_ratio;
    flank.held           = &held_[side];
    for (const unsigned int node : facets.nodes)
      {
        flank.places.push_back(places_[first + node]);
        const auto &points = flank.near->points;
        const auto  near   = std::lower_bound(points.begin(), points.end(), first + node);
        flank.near_places.push_back(near != points.end() && *near == first + node
                                      ? near - points.begin()
                                      : ElasticFlank::no_place);
      }
    return flank;
  }

  void PairPressure::place(const PairEquilibrium &equilibrium, const PairEquilibriumResult &result)
  {
    Flanks &flanks = *flanks_;
    for (unsigned int side = 0; side < 2; ++side)
      {
        const unsigned int body  = flanks.bodies[side];
        const Body        &b     = model_.bodies[body];
        const std::size_t  first = compliance_.discretization().find_part(body)->first_point;
        flanks.rotations[side]   = equilibrium.rotation(body);
        std::vector<double> &x   = flanks.positions[side];
        x.clear();
        for (const unsigned int node : flanks.facets[side]->nodes)
          {
            const Vector3 moved =
              equilibrium.place(body,
                                b.placement(b.node_positions()[node]) +
                                  Eigen::Map<const Vector3>(result.displacements.data() +
                                                            3 * (first + node)));
            x.insert(x.end(), moved.data(), moved.data() + 3);
          }
        flanks.surfaces[side].bind({x.data(),
                                    nullptr,
                                    {flanks.rotations[side] * b.placement.rotation,
                                     equilibrium.place(body, b.placement.translation)}});
      }
  }

  ContactLoad PairPressure::make_load(const PairEquilibrium       &equilibrium,
                                      const PairEquilibriumResult &result) const
  {
    const Transmission &t = *model_.transmission;
    ContactLoad         load;
    load.flexibility = [this](const std::vector<unsigned int> &rows) {
      return compliance_.flexibility(rows);
    };
    load.forces = Eigen::VectorXd::Zero(3 * compliance_.watched().size());
    for (const NodalForce &nodal : result.contact_forces)
      {
        const unsigned int point =
          compliance_.discretization().find_part(nodal.body)->first_point + nodal.node;
        load.forces.segment<3>(3 * places_[point]) +=
          equilibrium.rotation(nodal.body).transpose() * nodal.force;
      }
    // The load turns the driven body against its sense and so closes the gap, n . (x_s - y).
    const Axis  &axis = model_.bodies[t.driven].axis;
    const double sense =
      model_.contacts.front().master_body == t.driven ? -t.driven_sense : t.driven_sense;
    load.arm = [axis, sense](const Vector3 &x, const Vector3 &n) {
      return sense * n.dot(axis.direction.cross(x - axis.point));
    };
    load.load = load_torque(model_);
    return load;
  }

  PairPressures PairPressure::solve(const PairEquilibrium       &equilibrium,
                                    const PairEquilibriumResult &result)
  {
    // Flanks that rigid bodies would press on each other may carry.
    const double reach = std::abs(result.turn - result.touch_turn) * model_.transmission->arm;
    place(equilibrium, result);
    std::vector<ElasticContact> contacts;
    std::vector<ToothPressure>  teeth;
    for (const auto &[slave, master] : equilibrium.candidate_teeth())
      {
        const FacingSurfaces facing{
          &flanks_->surfaces[0], &flanks_->surfaces[1], slave, master, equilibrium.depth_limit()};
        if (find_least_gap(facing) > reach)
          continue;
        contacts.push_back({facing, {{make_flank(0, slave), make_flank(1, master)}}});
        teeth.push_back({slave, master, {}, {}});
      }
    const auto grids = find_grid_pressures(contacts, make_load(equilibrium, result), cells_across_);

    PairPressures found;
    for (std::size_t i = 0; i < grids.size(); ++i)
      {
        found.lead = -grids[i].closing;
        if (!grids[i].carries())
          continue;
        teeth[i].grid = grids[i];
        for (unsigned int side = 0; side < 2; ++side)
          for (const ContactCell &cell : grids[i].cells)
            {
              const CellFoot &foot = cell.feet[side];
              Vector3         x    = Vector3::Zero();
              for (unsigned int k = 0; k < 4; ++k)
                x += foot.weights[k] * flanks_->facets[side]->positions[foot.nodes[k]];
              teeth[i].places[side].push_back(x);
            }
        found.teeth.push_back(std::move(teeth[i]));
      }
    return found;
  }
} // namespace vfife
