// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/search/local_search.h>
#include <vfife/contact/touch_geometry.h>
#include <vfife/fem/pressure/contact_cells.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace vfife
{
  namespace
  {
    /** Samples of a facet each way, by which the plane is placed, and the part of them with the
     * smallest gaps that counts as near. */
    constexpr unsigned int n_samples = 8;
    constexpr double       near_part = 0.1;
    /** A cell whose middle lies this little outside a facet belongs to it. */
    constexpr double side_tolerance = 1e-9;

    CellFoot
    foot_of(const SurfaceGeometry &surface, const unsigned int facet, double xi, double eta)
    {
      return {facet, Vector2(xi, eta), surface.corners(facet), bilinear_weights(xi, eta)};
    }

    /** Looks for the master's point under points of the slave that lie near each other. */
    class MasterSearch
    {
    public:
      explicit MasterSearch(const FacingSurfaces &surfaces)
        : surfaces_(surfaces)
      {
      }

      /** The cell (but for its place) at a point of the slave; says whether the master is there. */
      bool find(const unsigned int facet, const double xi, const double eta, ContactCell &cell)
      {
        cell.position = surfaces_.slave->state(facet).position(xi, eta);
        // From where the last one was, to which it need not have been inside; otherwise from
        // everywhere.
        if (last_.facet == FacetSurface::no_facet ||
            !project_walking(*surfaces_.master, cell.position, last_))
          search_everywhere(cell.position);
        if (!last_.inside)
          return false;
        SurfaceGeometry  &master  = *surfaces_.master;
        const FacetState &under   = master.state(last_.facet);
        const Vector3     m       = under.normal(last_.xi, last_.eta);
        const Vector3     towards = surfaces_.slave->state(facet).normal(xi, eta);
        cell.normal               = m.normalized();
        cell.gap = last_.lambda * m.norm() - master.offset(last_.facet, last_.xi, last_.eta) -
                   surfaces_.slave->offset(facet, xi, eta);
        cell.feet = {{foot_of(*surfaces_.slave, facet, xi, eta),
                      foot_of(master, last_.facet, last_.xi, last_.eta)}};
        return towards.dot(cell.normal) < 0. && cell.gap > -surfaces_.depth_limit;
      }

      /** Of the point found last. */
      double find_fading(const double width) const
      {
        return width > 0. ? Fading(*surfaces_.master, last_, width).weight : 1.;
      }

    private:
      void search_everywhere(const Vector3 &x)
      {
        Projection best;
        double     nearest = std::numeric_limits<double>::infinity();
        for (const unsigned int facet : surfaces_.master->group_facets(surfaces_.master_group))
          {
            Projection trial;
            trial.facet = facet;
            if (project_on_facet(surfaces_.master->state(facet),
                                 surfaces_.master->border_sides(facet),
                                 x,
                                 trial) &&
                trial.inside && std::abs(trial.lambda) < nearest)
              {
                nearest = std::abs(trial.lambda);
                best    = trial;
              }
          }
        last_ = best;
      }

      const FacingSurfaces &surfaces_;
      Projection            last_;
    };

    /** Cells without place all over the slave, where the master is under them. */
    std::vector<ContactCell> sample(const FacingSurfaces &surfaces)
    {
      MasterSearch             search(surfaces);
      std::vector<ContactCell> samples;
      for (const unsigned int facet : surfaces.slave->group_facets(surfaces.slave_group))
        for (unsigned int j = 0; j < n_samples; ++j)
          for (unsigned int i = 0; i < n_samples; ++i)
            {
              ContactCell cell;
              if (search.find(facet, (i + .5) / n_samples, (j + .5) / n_samples, cell))
                samples.push_back(cell);
            }
      return samples;
    }

    /** Coordinates along the axes of a plane over its cells' sides. */
    Vector2 on_plane(const ContactPlane &plane, const Vector3 &x)
    {
      return Vector2(plane.along.dot(x - plane.origin) / plane.sides[0],
                     plane.across.dot(x - plane.origin) / plane.sides[1]);
    }
  } // namespace

  bool
  find_in_quadrilateral(const std::array<Vector2, 4> &corners, const Vector2 &target, Vector2 &xi)
  {
    xi = Vector2(.5, .5);
    for (unsigned int i = 0; i < 20; ++i)
      {
        const auto N = bilinear_weights(xi[0], xi[1]);
        Vector2    r = target;
        for (unsigned int k = 0; k < 4; ++k)
          r -= N[k] * corners[k];
        Eigen::Matrix2d slope;
        slope.col(0) = (1. - xi[1]) * (corners[1] - corners[0]) + xi[1] * (corners[2] - corners[3]);
        slope.col(1) = (1. - xi[0]) * (corners[3] - corners[0]) + xi[0] * (corners[2] - corners[1]);
        const Vector2 step = slope.inverse() * r;
        if (!step.allFinite())
          return false;
        xi += step;
        if (step.norm() < 1e-12)
          break;
      }
    return xi.minCoeff() >= -side_tolerance && xi.maxCoeff() <= 1. + side_tolerance;
  }

  std::vector<FacingPoint> find_facing_points(const FacingSurfaces                    &surfaces,
                                              const std::vector<FacetQuadraturePoint> &rule,
                                              const double                             edge_fading,
                                              const double                             reach)
  {
    MasterSearch                     search(surfaces);
    std::vector<FacingPoint>         points;
    const std::vector<unsigned int> &facets = surfaces.slave->group_facets(surfaces.slave_group);
    for (std::size_t k = 0; k < facets.size(); ++k)
      for (std::size_t i = 0; i < rule.size(); ++i)
        {
          FacingPoint point;
          point.cell.place = {{int(k), int(i)}};
          if (!search.find(facets[k], rule[i].xi, rule[i].eta, point.cell) ||
              point.cell.gap >= reach)
            continue;
          point.area = rule[i].weight * search.find_fading(edge_fading) *
                       surfaces.slave->area_element(facets[k], rule[i].xi, rule[i].eta);
          if (point.area > 0.)
            points.push_back(point);
        }
    return points;
  }

  double find_least_gap(const FacingSurfaces &surfaces)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const ContactCell &cell : sample(surfaces))
      least = std::min(least, cell.gap);
    return least;
  }

  ContactPlane place_contact_plane(const FacingSurfaces &surfaces, const unsigned int n)
  {
    std::vector<ContactCell> samples = sample(surfaces);
    if (samples.empty())
      throw NumericalError("two surfaces in contact do not face each other");
    std::sort(samples.begin(), samples.end(), [](const ContactCell &a, const ContactCell &b) {
      return a.gap < b.gap;
    });
    samples.resize(std::max<std::size_t>(std::ceil(near_part * samples.size()), 1));

    ContactPlane plane;
    Vector3      normal = Vector3::Zero();
    plane.origin.setZero();
    for (const ContactCell &cell : samples)
      {
        plane.origin += cell.position / samples.size();
        normal += cell.normal;
      }
    plane.normal   = normal.normalized();
    Matrix3 spread = 1e-12 * Matrix3::Identity();
    for (const ContactCell &cell : samples)
      {
        const Vector3 d = cell.position - plane.origin;
        const Vector3 t = d - plane.normal * plane.normal.dot(d);
        spread += t * t.transpose() / samples.size();
      }
    // Eigenvalues ascend: the normal, the shorter and the longer way.
    const Eigen::SelfAdjointEigenSolver<Matrix3> ways(spread);
    plane.along =
      (ways.eigenvectors().col(2) - plane.normal * plane.normal.dot(ways.eigenvectors().col(2)))
        .normalized();
    plane.across = plane.normal.cross(plane.along);
    // A uniform strip of the half width w has the deviation w/sqrt 3; samples stand for strips.
    const double strip = std::pow(surfaces.slave->mean_facet_size() / n_samples, 2) / 12.;
    plane.sides        = Vector2(2. / n * std::sqrt(3. * (ways.eigenvalues()[2] + strip)),
                          2. / n * std::sqrt(3. * (ways.eigenvalues()[1] + strip)));
    return plane;
  }

  std::vector<ContactCell> find_contact_cells(const FacingSurfaces &surfaces,
                                              const ContactPlane   &plane)
  {
    MasterSearch                              search(surfaces);
    std::map<std::array<int, 2>, ContactCell> cells;
    for (const unsigned int facet : surfaces.slave->group_facets(surfaces.slave_group))
      {
        std::array<Vector2, 4> corners;
        Vector2 low = Vector2::Constant(std::numeric_limits<double>::infinity()), high = -low;
        for (unsigned int k = 0; k < 4; ++k)
          {
            corners[k] = on_plane(plane, surfaces.slave->node(surfaces.slave->corners(facet)[k]));
            low        = low.cwiseMin(corners[k]);
            high       = high.cwiseMax(corners[k]);
          }
        low  = low.cwiseMax(-plane.reach);
        high = high.cwiseMin(plane.reach);
        for (int i = std::ceil(low[0]); i <= std::floor(high[0]); ++i)
          for (int j = std::ceil(low[1]); j <= std::floor(high[1]); ++j)
            {
              Vector2     xi;
              ContactCell cell;
              cell.place = {{i, j}};
              if (find_in_quadrilateral(corners, Vector2(i, j), xi) &&
                  cells.count(cell.place) == 0 && search.find(facet, xi[0], xi[1], cell))
                cells.emplace(cell.place, cell);
            }
      }
    std::vector<ContactCell> sorted;
    for (const auto &entry : cells)
      sorted.push_back(entry.second);
    return sorted;
  }
} // namespace vfife
