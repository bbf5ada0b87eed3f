// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "../statics/dual_means.h"
#include "nodes_around.h"
#include "sector_strip.h"

#include <vfife/base/errors.h>
#include <vfife/contact/surface/facet_quadrature.h>
#include <vfife/fem/statics/facet_parts.h>
#include <vfife/fem/submodel/sector_submodel.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/model/load_shares.h>

#include <limits>

namespace vfife
{
  namespace
  {
    /** Nodes of the flank of tooth 0. */
    std::vector<unsigned int> flank_nodes(const FacetSurface &surface)
    {
      std::vector<unsigned int> nodes = list_group_nodes(surface, 0);
      for (unsigned int &node : nodes)
        node = surface.nodes[node];
      return nodes;
    }

    Vector3 on_quadrilateral(const std::array<Vector3, 4> &corners, const Vector2 &place)
    {
      const auto weights = bilinear_weights(place[0], place[1]);
      Vector3    x       = Vector3::Zero();
      for (unsigned int k = 0; k < 4; ++k)
        x += weights[k] * corners[k];
      return x;
    }

    /** Shape functions of a face's points at a place. */
    Eigen::VectorXd face_shapes(const unsigned int degree, const Vector2 &place)
    {
      const std::vector<double> knots = places_along(degree);
      const auto                along = [&knots](const double x) {
        Eigen::VectorXd values = Eigen::VectorXd::Ones(knots.size());
        for (std::size_t i = 0; i < knots.size(); ++i)
          for (std::size_t j = 0; j < knots.size(); ++j)
            if (j != i)
              values[i] *= (x - knots[j]) / (knots[i] - knots[j]);
        return values;
      };
      const Eigen::VectorXd first = along(place[0]), second = along(place[1]);
      Eigen::VectorXd       shapes(first.size() * second.size());
      for (Eigen::Index j = 0; j < second.size(); ++j)
        shapes.segment(j * first.size(), first.size()) = second[j] * first;
      return shapes;
    }
  } // namespace

  SectorSubmodel::SectorSubmodel(const SubmodelPart               part,
                                 const FemSpace                  &sector,
                                 const Body                      &followed,
                                 const std::vector<PointReading> &readings)
    : followed_(&followed)
  {
    const Body &fine = sector.model().bodies[sector.parts().front().body];
    if (fine.structure().n_sectors() != followed.structure().n_sectors())
      throw InputError("body \"" + followed.name() + "\" has " +
                       std::to_string(followed.structure().n_sectors()) +
                       " sectors, the fine mesh of its submodel has " +
                       std::to_string(fine.structure().n_sectors()));
    const SectorStrip            strip(sector, part);
    const SectorStrip::Influence influence = strip.find_influence(readings);
    n_unknowns_                            = strip.n_unknowns();
    of_spin_                               = influence.of_forces * strip.compute_spin_forces();
    if (fine.has_initial_strains())
      for (unsigned int tooth = 0; tooth < fine.structure().n_sectors(); ++tooth)
        of_initial_strains_.push_back(influence.of_forces * strip.compute_expanding_forces(tooth));
    if (part == SubmodelPart::teeth)
      {
        find_flanks(sector);
        find_node_shares();
        for (int turned = -1; turned <= 1; ++turned)
          {
            Eigen::MatrixXd of_forces =
              Eigen::MatrixXd::Zero(readings.size(), 3 * flank_points_.size());
            for (std::size_t i = 0; i < flank_points_.size(); ++i)
              if (const unsigned int p = strip.number(turned, flank_points_[i]);
                  p != SectorStrip::none)
                of_forces.middleCols<3>(3 * i) =
                  influence.of_forces.middleCols<3>(3 * p) * followed.structure().turn(turned);
            of_forces_.push_back(std::move(of_forces));
          }
      }

    // The cut follows the nodes.
    const NodesAround                       around(followed);
    std::map<unsigned int, Eigen::MatrixXd> by_node;
    for (std::size_t i = 0; i < strip.cut().size(); ++i)
      for (const auto &[node, weight] : around.find(strip.points()[strip.cut()[i]]))
        {
          auto &columns =
            by_node.try_emplace(node, Eigen::MatrixXd::Zero(readings.size(), 3)).first->second;
          columns += weight * influence.of_cut.middleCols<3>(3 * i);
        }
    of_displacements_.resize(readings.size(), 3 * by_node.size());
    for (const auto &[node, columns] : by_node)
      {
        of_displacements_.middleCols<3>(3 * nodes_.size()) = columns;
        nodes_.push_back(node);
      }
  }

  void SectorSubmodel::find_flanks(const FemSpace &sector)
  {
    const FemSpace::Part                &part    = sector.parts().front();
    const Body                          &fine    = sector.model().bodies[part.body];
    const Matrix3                        to_body = fine.placement.rotation.transpose();
    std::map<unsigned int, unsigned int> places;
    for (const char *name : {surface_name::concave, surface_name::convex})
      for (const BoundaryFace &face :
           find_boundary_faces(fine, flank_nodes(fine.mesh().surfaces.at(name))))
        for (const auto &[points, X] : points_of_face(sector, part, face))
          {
            const unsigned int n = sector.degree() + 1;
            FlankFace          flank;
            unsigned int       k = 0;
            for (const unsigned int corner : {0u, n - 1, n * n - 1, n * (n - 1)})
              flank.corners[k++] = to_body * (X.col(corner) - fine.placement.translation);
            for (const unsigned int point : points)
              {
                const auto [place, is_new] =
                  places.try_emplace(point, static_cast<unsigned int>(flank_points_.size()));
                if (is_new)
                  flank_points_.push_back(point);
                flank.points.push_back(place->second);
              }
            flanks_[name].push_back(std::move(flank));
          }
  }

  SectorSubmodel::FacePlace SectorSubmodel::find_on_flank(const std::string &surface,
                                                          const Vector3     &place) const
  {
    double           least = std::numeric_limits<double>::infinity();
    const FlankFace *found = nullptr;
    Vector2          at    = Vector2::Zero();
    for (const FlankFace &face : flanks_.at(surface))
      {
        const Vector2 here     = place_on_facet(face.corners, place);
        const double  distance = (on_quadrilateral(face.corners, here) - place).norm();
        if (distance < least)
          {
            least = distance;
            found = &face;
            at    = here;
          }
      }
    const unsigned int degree =
      static_cast<unsigned int>(std::lround(std::sqrt(found->points.size()))) - 1;
    return {found, face_shapes(degree, at)};
  }

  void SectorSubmodel::find_node_shares()
  {
    // The meshes do not match, so many points.
    constexpr unsigned int points_per_facet = 6;
    const auto rule = facet_quadrature(ContactDiscretization::surface_points, points_per_facet);
    DualMeans  means;
    for (const char *name : {surface_name::concave, surface_name::convex})
      {
        const FacetSurface &surface = followed_->mesh().surfaces.at(name);
        for (std::size_t f = 0; f < surface.facets.size(); ++f)
          {
            if (surface.group[f] != 0)
              continue;
            std::array<unsigned int, 4> nodes;
            std::array<Vector3, 4>      X;
            for (unsigned int k = 0; k < 4; ++k)
              {
                nodes[k] = surface.nodes[surface.facets[f][k]];
                X[k]     = followed_->node_positions()[nodes[k]];
              }
            DualMeans::Quadrilateral facet;
            for (const FacetQuadraturePoint &at : rule)
              {
                const Vector3 along  = (1. - at.eta) * (X[1] - X[0]) + at.eta * (X[2] - X[3]),
                              across = (1. - at.xi) * (X[3] - X[0]) + at.xi * (X[2] - X[1]);
                const FacePlace foot = find_on_flank(name, on_quadrilateral(X, {at.xi, at.eta}));
                facet.add(at.weight * along.cross(across).norm(),
                          Eigen::Map<const Eigen::Vector4d>(at.shape.data()),
                          foot.first->points,
                          foot.second);
              }
            means.add(facet, nodes);
          }
      }
    node_shares_ = means.find();
  }

  Eigen::VectorXd &SectorSubmodel::forces_of(const unsigned int tooth, ToothForces &forces) const
  {
    return forces.try_emplace(tooth, Eigen::VectorXd::Zero(3 * flank_points_.size())).first->second;
  }

  void SectorSubmodel::add_force(const std::string &surface,
                                 const unsigned int tooth,
                                 const Vector3     &place,
                                 const Vector3     &force,
                                 ToothForces       &forces) const
  {
    const Matrix3    back = followed_->structure().turn(-static_cast<int>(tooth));
    const FacePlace  foot = find_on_flank(surface, back * place);
    Eigen::VectorXd &own  = forces_of(tooth, forces);
    for (std::size_t a = 0; a < foot.first->points.size(); ++a)
      own.segment<3>(3 * foot.first->points[a]) += foot.second[a] * (back * force);
  }

  void SectorSubmodel::add_nodal_force(const unsigned int node,
                                       const Vector3     &force,
                                       ToothForces       &forces) const
  {
    const BodyStructure &structure = followed_->structure();
    const auto           shares    = node_shares_.find(structure.first_copy(node));
    if (shares == node_shares_.end())
      return;
    const unsigned int tooth = structure.sector_of(node);
    const Vector3      own   = structure.turn(-static_cast<int>(tooth)) * force;
    Eigen::VectorXd   &all   = forces_of(tooth, forces);
    for (const auto &[point, weight] : shares->second)
      all.segment<3>(3 * point) += weight * own;
  }

  std::vector<unsigned int> SectorSubmodel::list_flank_nodes() const
  {
    std::vector<unsigned int> nodes;
    for (unsigned int tooth = 0; tooth < followed_->structure().n_sectors(); ++tooth)
      for (const auto &shares : node_shares_)
        nodes.push_back(followed_->structure().copy(shares.first, tooth));
    return nodes;
  }

  Eigen::VectorXd SectorSubmodel::follow(const unsigned int tooth, const NodeDisplacement &u) const
  {
    const Matrix3   back = followed_->structure().turn(-static_cast<int>(tooth));
    Eigen::VectorXd own(3 * nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      own.segment<3>(3 * i) = back * u(followed_->structure().copy(nodes_[i], tooth));
    return of_displacements_ * own;
  }

  Eigen::VectorXd
  SectorSubmodel::load(const unsigned int tooth, const ToothForces &forces, const double rate) const
  {
    Eigen::VectorXd values = rate * rate * of_spin_;
    if (!of_initial_strains_.empty())
      values += of_initial_strains_[tooth];
    const unsigned int n = followed_->structure().n_sectors();
    for (unsigned int k = 0; k < of_forces_.size(); ++k)
      if (const auto found = forces.find((tooth + n + k - 1) % n); found != forces.end())
        values += of_forces_[k] * found->second;
    return values;
  }
} // namespace vfife
