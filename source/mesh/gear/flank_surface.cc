// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/gear/flank_surface.h>
#include <vfife/mesh/node_set_names.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Far below the offsets (micrometres) and above round-off of coordinates of 100 mm. */
    constexpr double offset_tolerance = 1e-11;

    /** Where the line from a facet meets the flank without deviations. */
    struct FlankFoot
    {
      double       distance = 0; ///< from the facet [mm]
      double       cosine   = 1; ///< of the line to the flank's normal out of the metal
      SurfacePoint point;
    };

    /** The flank at (L, h); a chord of a facet may lead under the start of the flank, where the
     * cutter leaves nothing of it: then the flank's first point at L, and @p is_beyond. */
    SurfacePoint nearest_flank_point(const GearGeometry &gear,
                                     const FlankSide     side,
                                     const Vector2      &L_h,
                                     bool               &is_beyond)
    {
      is_beyond = false;
      try
        {
          return gear.flank_point(side, L_h[0], L_h[1]);
        }
      catch (const InputError &)
        {
          const Vector3 end   = gear.fillet_point(side, L_h[0], gear.fillet_end(side)).position;
          const double  start = gear.blank().coordinates_of(end)[1];
          is_beyond           = L_h[1] < start;
          if (!is_beyond)
            throw;
          return gear.flank_point(side, L_h[0], start);
        }
    }

    /**
     * From @p point along the unit vector @p direction to the flank. Newton: intersect the tangent
     * plane, then take the flank point at the (L, h) reached.
     */
    FlankFoot find_foot(const GearGeometry &gear,
                        const FlankSide     side,
                        const Vector3      &point,
                        const Vector3      &direction)
    {
      double delta = 0.;
      for (unsigned int iteration = 0; iteration < 20; ++iteration)
        {
          const Vector3      y         = point + delta * direction;
          const Vector2      L_h       = gear.blank().coordinates_of(y);
          bool               is_beyond = false;
          const SurfacePoint x         = nearest_flank_point(gear, side, L_h, is_beyond);
          const double       step      = (x.position - y).dot(x.normal) / direction.dot(x.normal);
          delta += step;
          // Beyond the flank's start its tangent plane goes on.
          if (is_beyond || std::abs(step) < offset_tolerance)
            return {delta, -direction.dot(x.normal), x};
        }
      throw NumericalError(gear.name() +
                           ": the offset from a facet to the true flank did not converge");
    }

    /** Bilinear weights in the order of FacetSurface. */
    std::array<double, 4> bilinear_weights(const double xi, const double eta)
    {
      return {{(1. - xi) * (1. - eta), xi * (1. - eta), xi * eta, (1. - xi) * eta}};
    }

    /** Nodes, facets and rows of tooth 0. */
    FacetSurface make_first_tooth(const GearGeometry &gear, const FlankGrid &grid)
    {
      FacetSurface tooth;
      tooth.nodes = grid.nodes;
      for (const Vector2 &L_h : grid.L_h)
        {
          const SurfacePoint point = gear.flank_point(grid.side, L_h[0], L_h[1]);
          tooth.positions.push_back(point.position);
          tooth.normals.push_back(-point.normal); // out of the metal
        }
      tooth.facets = grid.facets;
      return tooth;
    }

    /** Numbers of the edges of a flank. */
    enum Edge : unsigned char
    {
      no_edge,
      tip,
      toe,
      heel
    };

    /** Sides 0 and 2 of a facet run along the tooth: at the border the higher is the tip, the lower
     * goes on into the fillet. The ends are sides 1 and 3. */
    std::vector<std::array<unsigned char, 4>> find_edges(const FlankGrid    &grid,
                                                         const FacetSurface &tooth)
    {
      std::vector<std::array<unsigned char, 4>> edges;
      for (std::size_t f = 0; f < grid.facets.size(); ++f)
        {
          edges.push_back({{no_edge, no_edge, no_edge, no_edge}});
          const auto &k = grid.facets[f];
          for (unsigned int side = 0; side < 4; ++side)
            {
              if (tooth.neighbours[f][side] != FacetSurface::no_facet)
                continue;
              // middle of this side against that of the opposite one
              const Vector2 here  = grid.L_h[k[side]] + grid.L_h[k[(side + 1) % 4]];
              const Vector2 there = grid.L_h[k[(side + 2) % 4]] + grid.L_h[k[(side + 3) % 4]];
              if (side % 2 == 0)
                edges[f][side] = here[1] > there[1] ? tip : no_edge;
              else
                edges[f][side] = here[0] > there[0] ? heel : toe;
            }
        }
      return edges;
    }

    /** The points of the flank that the offsets of tooth 0 lead to, in the order of the table. */
    std::vector<FlankFoot>
    find_feet(const GearGeometry &gear, const FlankSide side, const FacetSurface &tooth)
    {
      std::vector<FlankFoot>    feet;
      const std::vector<double> abscissae = offset_abscissae();
      for (const auto &facet : tooth.facets)
        for (const double eta : abscissae)
          for (const double xi : abscissae)
            {
              // point of the facet and direction of its normal field
              const auto weights = bilinear_weights(xi, eta);
              Vector3    point = Vector3::Zero(), normal = Vector3::Zero();
              for (unsigned int k = 0; k < 4; ++k)
                {
                  point += weights[k] * tooth.positions[facet[k]];
                  normal += weights[k] * tooth.normals[facet[k]];
                }
              // nodes lie on the flank: no round-off there
              const bool corner = (xi == 0. || xi == 1.) && (eta == 0. || eta == 1.);
              feet.push_back(corner ? FlankFoot{0., 1., {point, -normal.normalized()}}
                                    : find_foot(gear, side, point, normal.normalized()));
            }
      return feet;
    }

    /** Adds the offsets of a tooth: to the flank, and along its normal by which it deviates. */
    void add_offsets(const GearGeometry           &gear,
                     const FlankSide               side,
                     const unsigned int            k,
                     const std::vector<FlankFoot> &feet,
                     FacetSurface                 &surface)
    {
      for (const FlankFoot &foot : feet)
        surface.offsets.push_back(
          foot.distance +
          (gear.has_deviations() ? gear.deviation(side, k, foot.point) / foot.cosine : 0.));
    }
  } // namespace

  std::vector<double> offset_abscissae()
  {
    const dealii::QGaussLobatto<1> quadrature(5);
    std::vector<double>            abscissae;
    for (const dealii::Point<1> &point : quadrature.get_points())
      abscissae.push_back(point[0]);
    return abscissae;
  }

  FacetSurface make_flank_surface(const GearGeometry &gear,
                                  const FlankGrid    &grid,
                                  const unsigned int  nodes_per_sector)
  {
    // Tooth 0 once: nodes, ways to the flank, which sides are edges of the flank.
    FacetSurface                 tooth = make_first_tooth(gear, grid);
    const std::vector<FlankFoot> feet  = find_feet(gear, grid.side, tooth);
    find_neighbours(tooth);
    const auto edges = find_edges(grid, tooth);

    FacetSurface surface;
    surface.name = grid.side == FlankSide::concave ? surface_name::concave : surface_name::convex;
    surface.n_groups      = gear.blank().teeth;
    surface.offset_points = offset_abscissae().size();

    // Its copies; those that deviate alike share the rows of offsets.
    const unsigned int per_tooth = tooth.nodes.size();
    for (unsigned int k = 0; k < surface.n_groups; ++k)
      {
        const Matrix3 rotation = rotation_about(Vector3::UnitZ(), 2. * pi * k / surface.n_groups);
        const bool    own_rows = k == 0 || !gear.has_equal_teeth();
        if (own_rows)
          add_offsets(gear, grid.side, k, feet, surface);
        const unsigned int first_row = own_rows ? k * tooth.facets.size() : 0;
        for (unsigned int i = 0; i < per_tooth; ++i)
          {
            surface.nodes.push_back(tooth.nodes[i] + k * nodes_per_sector);
            surface.positions.push_back(rotation * tooth.positions[i]);
            surface.normals.push_back(rotation * tooth.normals[i]);
          }
        for (unsigned int f = 0; f < tooth.facets.size(); ++f)
          {
            auto facet = tooth.facets[f];
            for (unsigned int &corner : facet)
              corner += k * per_tooth;
            surface.facets.push_back(facet);
            surface.group.push_back(k);
            surface.offset_row.push_back(first_row + f);
            surface.edges.push_back(edges[f]);
          }
      }
    find_neighbours(surface);
    return surface;
  }
} // namespace vfife
