// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "sector_strip.h"

#include <vfife/base/process/communicator.h>
#include <vfife/element/hexahedron.h>
#include <vfife/fem/solvers/direct_solver.h>
#include <vfife/fem/system/fem_matrix.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/gear/sector/gear_sector.h>
#include <vfife/mesh/node_set_names.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vfife
{
  namespace
  {
    /** Readings that are solved for together. */
    constexpr Eigen::Index solved_at_once = 96;

    /** Sectors on either side of a web's, which is narrow at the hub. */
    constexpr int beside_web = 5;

    /** Whether an element of the body belongs to one of two regions. */
    bool is_of(const Body        &body,
               const unsigned int element,
               const GearRegion   one,
               const GearRegion   other)
    {
      const auto region =
        std::next(body.mesh().triangulation.begin_active(), element)->material_id();
      return region == static_cast<unsigned int>(one) || region == static_cast<unsigned int>(other);
    }

    /** Nodes by which a body may be held or turned. */
    std::vector<unsigned int> held_nodes(const Body &body)
    {
      for (const char *name : {node_set::bore, node_set::rim_underside})
        if (body.has_node_set(name))
          return body.node_set(name);
      return {};
    }
  } // namespace

  SectorStrip::SectorStrip(const FemSpace &sector, const SubmodelPart part)
    : sector_(sector)
    , beside_(part == SubmodelPart::web ? beside_web : 1)
    , body_(sector.model().bodies[sector.parts().front().body])
    , originals_(sector.images().begin(), sector.images().end())
  {
    const Chosen chosen = part == SubmodelPart::web ? choose_web() : choose_teeth();
    add_elements(chosen);
    number_unknowns(chosen);
  }

  Vector3 SectorStrip::body_place(const unsigned int point) const
  {
    const RigidMotion &placement = body_.placement;
    return placement.rotation.transpose() * (sector_.points()[point] - placement.translation);
  }

  SectorStrip::Key SectorStrip::key_of(const int turned, const unsigned int point) const
  {
    const auto image = originals_.find(point);
    return image == originals_.end() ? Key(turned, point) : Key(turned + 1, image->second);
  }

  unsigned int SectorStrip::number(const int turned, const unsigned int point) const
  {
    const auto found = numbers_.find(key_of(turned, point));
    return found == numbers_.end() ? none : found->second;
  }

  SectorStrip::Chosen SectorStrip::choose_teeth() const
  {
    // An element is of the half of the tooth whose flank is nearer.
    std::array<std::vector<Vector3>, 2> flanks;
    for (unsigned int k = 0; k < 2; ++k)
      {
        const FacetSurface &surface =
          body_.mesh().surfaces.at(k == 0 ? surface_name::concave : surface_name::convex);
        for (const unsigned int node : list_group_nodes(surface, 0))
          flanks[k].push_back(surface.positions[node]);
      }
    const auto distance = [](const std::vector<Vector3> &points, const Vector3 &x) {
      double least = std::numeric_limits<double>::infinity();
      for (const Vector3 &point : points)
        least = std::min(least, (point - x).squaredNorm());
      return least;
    };
    // Sectors follow each other in the sense of rising angles.
    const auto angle = [](const std::vector<Vector3> &points) {
      const Vector3 sum = std::accumulate(points.begin(), points.end(), Vector3(0., 0., 0.));
      return std::atan2(sum[1], sum[0]);
    };
    if (std::remainder(angle(flanks[1]) - angle(flanks[0]), 2. * pi) < 0.)
      std::swap(flanks[0], flanks[1]);

    Chosen chosen(sector_.n_elements(), {false, false, false});
    for (unsigned int e = 0; e < sector_.n_elements(); ++e)
      if (is_of(body_, sector_.body_element(e), GearRegion::tooth, GearRegion::rim))
        {
          Vector3 middle = Vector3::Zero();
          for (unsigned int a = 0; a < sector_.points_per_element(); ++a)
            middle += body_place(sector_.element_points(e)[a]) / sector_.points_per_element();
          const bool is_lower = distance(flanks[0], middle) < distance(flanks[1], middle);
          chosen[e]           = {!is_lower, true, is_lower};
        }
    return chosen;
  }

  SectorStrip::Chosen SectorStrip::choose_web() const
  {
    Chosen chosen;
    for (unsigned int e = 0; e < sector_.n_elements(); ++e)
      chosen.emplace_back(2 * beside_ + 1,
                          is_of(body_, sector_.body_element(e), GearRegion::web, GearRegion::hub));
    return chosen;
  }

  void SectorStrip::add_elements(const Chosen &chosen)
  {
    for (int turned = -beside_; turned <= beside_; ++turned)
      for (unsigned int e = 0; e < sector_.n_elements(); ++e)
        {
          if (!chosen[e][beside_ + turned])
            continue;
          Element element{e, turned, {}};
          for (unsigned int a = 0; a < sector_.points_per_element(); ++a)
            {
              const Key key = key_of(turned, sector_.element_points(e)[a]);
              const auto [place, is_new] =
                numbers_.try_emplace(key, static_cast<unsigned int>(points_.size()));
              if (is_new)
                points_.push_back(body_.structure().turn(key.first) * body_place(key.second));
              element.points.push_back(place->second);
            }
          elements_.push_back(std::move(element));
        }
    stiffness_.resize(sector_.n_elements());
    for (const Element &element : elements_)
      if (element.turned == 0)
        stiffness_[element.of_sector] = compute_fem_stiffness(places_of(element),
                                                              sector_.material(element.of_sector),
                                                              sector_.element());
  }

  void SectorStrip::number_unknowns(const Chosen &chosen)
  {
    // What the rest of the body has as well, in all sectors that points may be turned to; and what
    // is held or turned.
    std::vector<bool> cut(points_.size(), false);
    const auto        cut_here = [&](const int turned, const unsigned int point) {
      if (const unsigned int p = number(turned, point); p != none)
        cut[p] = true;
    };
    for (unsigned int e = 0; e < sector_.n_elements(); ++e)
      for (int turned = -beside_ - 1; turned <= beside_ + 1; ++turned)
        if (std::abs(turned) > beside_ || !chosen[e][beside_ + turned])
          for (unsigned int a = 0; a < sector_.points_per_element(); ++a)
            cut_here(turned, sector_.element_points(e)[a]);
    for (const unsigned int point : sector_.points_of(sector_.parts().front(), held_nodes(body_)))
      for (int turned = -beside_; turned <= beside_ + 1; ++turned)
        cut_here(turned, point);
    first_unknown_.assign(points_.size(), -1);
    for (unsigned int p = 0; p < points_.size(); ++p)
      if (cut[p])
        cut_.push_back(p);
      else
        {
          first_unknown_[p] = n_unknowns_;
          n_unknowns_ += 3;
        }
  }

  ElementNodes SectorStrip::places_of(const Element &element) const
  {
    ElementNodes X(3, element.points.size());
    for (std::size_t a = 0; a < element.points.size(); ++a)
      X.col(a) = points_[element.points[a]];
    return X;
  }

  Eigen::MatrixXd SectorStrip::stiffness_of(const Element &element) const
  {
    const Matrix3   Q = body_.structure().turn(element.turned);
    Eigen::MatrixXd K = stiffness_[element.of_sector];
    for (Eigen::Index a = 0; a < K.rows(); a += 3)
      K.middleRows<3>(a) = (Q * K.middleRows<3>(a)).eval();
    for (Eigen::Index a = 0; a < K.cols(); a += 3)
      K.middleCols<3>(a) = (K.middleCols<3>(a) * Q.transpose()).eval();
    return K;
  }

  namespace
  {
    /** Rows of all unknowns; each point couples to its @p neighbours, which are ascending. */
    std::shared_ptr<SparsePattern> make_pattern(const std::vector<std::vector<int>> &neighbours,
                                                const Communicator                  &communicator)
    {
      auto pattern          = std::make_shared<SparsePattern>();
      pattern->communicator = &communicator;
      pattern->n            = 3 * neighbours.size();
      pattern->begin        = {0};
      for (const std::vector<int> &own : neighbours)
        for (unsigned int c = 0; c < 3; ++c)
          {
            for (const int first : own)
              pattern->columns.insert(pattern->columns.end(), {first, first + 1, first + 2});
            pattern->begin.push_back(pattern->columns.size());
          }
      return pattern;
    }
  } // namespace

  FemMatrix SectorStrip::make_matrix(const Communicator &communicator) const
  {
    std::vector<std::vector<int>> neighbours(n_unknowns_ / 3);
    for (const Element &element : elements_)
      for (const unsigned int a : element.points)
        for (const unsigned int b : element.points)
          if (!is_cut(a) && !is_cut(b))
            neighbours[first_unknown_[a] / 3].push_back(first_unknown_[b]);
    for (std::vector<int> &own : neighbours)
      {
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
      }
    FemMatrix matrix(make_pattern(neighbours, communicator));
    for (const Element &element : elements_)
      {
        const Eigen::MatrixXd K = stiffness_of(element);
        for (std::size_t a = 0; a < element.points.size(); ++a)
          for (std::size_t b = 0; b < element.points.size(); ++b)
            {
              const int row    = first_unknown_[element.points[a]],
                        column = first_unknown_[element.points[b]];
              for (unsigned int c = 0; row >= 0 && column >= 0 && c < 3; ++c)
                {
                  double *values = &matrix.at(row + c, column);
                  for (unsigned int d = 0; d < 3; ++d)
                    values[d] += K(3 * a + c, 3 * b + d);
                }
            }
      }
    return matrix;
  }

  SectorStrip::Influence
  SectorStrip::find_influence(const std::vector<PointReading> &readings) const
  {
    // Of displacements u of the unknowns and v at the cut a reading is a u + b v. K u = f - C v, so
    // it is y f + (b - y C) v with K y = a.
    std::vector<int> place_in_cut(points_.size(), -1);
    for (std::size_t i = 0; i < cut_.size(); ++i)
      place_in_cut[cut_[i]] = i;
    Influence influence;
    influence.of_forces.setZero(readings.size(), 3 * points_.size());
    influence.of_cut.setZero(readings.size(), 3 * cut_.size());
    const Communicator alone(MPI_COMM_SELF);
    const DirectSolver solver(make_matrix(alone));
    for (Eigen::Index begin = 0; begin < influence.of_forces.rows(); begin += solved_at_once)
      {
        const Eigen::Index n = std::min(solved_at_once, influence.of_forces.rows() - begin);
        Eigen::MatrixXd    y = Eigen::MatrixXd::Zero(n_unknowns_, n);
        for (Eigen::Index k = 0; k < n; ++k)
          for (const auto &[point, weight] : readings[begin + k])
            if (const unsigned int p = number(0, point); is_cut(p))
              influence.of_cut.row(begin + k).segment<3>(3 * place_in_cut[p]) += weight.transpose();
            else
              y.col(k).segment<3>(first_unknown_[p]) += weight;
        solver.solve(y.data(), n);
        for (std::size_t p = 0; p < points_.size(); ++p)
          if (!is_cut(p))
            influence.of_forces.block(begin, 3 * p, n, 3) =
              y.middleRows<3>(first_unknown_[p]).transpose();
      }
    for (const Element &element : elements_)
      {
        if (std::none_of(element.points.begin(), element.points.end(), [this](const auto p) {
              return is_cut(p);
            }))
          continue;
        const Eigen::MatrixXd K = stiffness_of(element);
        for (std::size_t b = 0; b < element.points.size(); ++b)
          if (const int place = place_in_cut[element.points[b]]; place >= 0)
            for (std::size_t a = 0; a < element.points.size(); ++a)
              // Columns of points at the cut are zero.
              influence.of_cut.middleCols<3>(3 * place).noalias() -=
                influence.of_forces.middleCols<3>(3 * element.points[a]) *
                K.block<3, 3>(3 * a, 3 * b);
      }
    return influence;
  }

  Eigen::VectorXd SectorStrip::compute_expanding_forces(const unsigned int tooth) const
  {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(3 * points_.size());
    for (const Element &element : elements_)
      {
        const double strain = body_.initial_strain(
          body_.structure().copy_of_element(sector_.body_element(element.of_sector),
                                            static_cast<int>(tooth) + element.turned));
        const ElementNodes    X    = places_of(element);
        const ElementNodes    free = expand_nodes(X, strain) - X;
        const Eigen::VectorXd f =
          stiffness_of(element) * Eigen::Map<const Eigen::VectorXd>(free.data(), free.size());
        for (std::size_t a = 0; a < element.points.size(); ++a)
          forces.segment<3>(3 * element.points[a]) += f.segment<3>(3 * a);
      }
    return forces;
  }

  Eigen::VectorXd SectorStrip::compute_spin_forces() const
  {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(3 * points_.size());
    for (const Element &element : elements_)
      {
        const ElementNodes X       = places_of(element);
        const double       density = sector_.material(element.of_sector).density;
        for (const ElementPoint &at : compute_element_points(X))
          {
            Vector3 outward = X * at.N;
            outward[2]      = 0.;
            for (std::size_t a = 0; a < element.points.size(); ++a)
              forces.segment<3>(3 * element.points[a]) += density * at.weight * at.N[a] * outward;
          }
      }
    return forces;
  }
} // namespace vfife
