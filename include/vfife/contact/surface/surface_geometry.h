// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_surface_surface_geometry_h
#define vfife_contact_surface_surface_geometry_h

#include <vfife/base/facet_surface.h>
#include <vfife/base/types.h>
#include <vfife/contact/law/contact_options.h>
#include <vfife/contact/surface/edge_relief.h>
#include <vfife/contact/surface/facet_quadrature.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vfife
{
  /** The current state of a surface in the fixed frame; only the nodes of active groups need be
   * valid. */
  struct SurfaceMotion
  {
    const double *positions;  ///< 3 per surface node [mm]
    const double *velocities; ///< 3 per surface node [mm/s]
    RigidMotion   body;       ///< mean rigid motion, undeformed body frame to fixed frame
    /** Of a step of explicit dynamics: after it, without contact. */
    const double *later_velocities = nullptr;
  };

  /** A facet in its current state: bilinear position and (not normalized) normal field as
   * polynomials. */
  struct FacetState
  {
    Vector3 y[4]; ///< y = y0 + y1 xi + y2 eta + y3 xi eta [mm]
    Vector3 m[4]; ///< sum N_k n_k in the same form

    Vector3 position(const double xi, const double eta) const
    {
      return y[0] + xi * y[1] + eta * (y[2] + xi * y[3]);
    }
    /** Derivatives of the position with respect to xi and eta [mm]. */
    Vector3 along_xi(const double eta) const
    {
      return y[1] + eta * y[3];
    }
    Vector3 along_eta(const double xi) const
    {
      return y[2] + xi * y[3];
    }
    Vector3 normal(const double xi, const double eta) const
    {
      return m[0] + xi * m[1] + eta * (m[2] + xi * m[3]);
    }
  };

  /**
   * A surface in contact: connectivity, offsets, and its current state, computed for a facet when
   * it is first asked for after bind(). The normal at a node is n = normalize(R (N_true - N_facets)
   * + n_facets), N_facets and n_facets being the normalized sums of the vector areas of the node's
   * facets in the undeformed and in the current state, R the body's mean rotation: exact under
   * rigid motion, following deformation.
   */
  class SurfaceGeometry
  {
  public:
    /** Copies what it needs. The relief belongs to the surface from then on, as part of its offset.
     * Throws InputError when arrays do not fit together. */
    SurfaceGeometry(const FacetSurface &surface, ContactSurfaceKind kind, EdgeRelief relief = {});

    /** Sets the current state; the arrays must stay valid until the next call. */
    void bind(const SurfaceMotion &motion);

    const FacetState &state(const unsigned int facet)
    {
      if (facet_stamps_[facet] != stamp_)
        prepare(facet);
      return states_[facet];
    }

    Vector3 node(const unsigned int n) const
    {
      return Eigen::Map<const Vector3>(motion_.positions + 3 * static_cast<std::size_t>(n));
    }
    Vector3 velocity(const unsigned int n) const
    {
      return Eigen::Map<const Vector3>(motion_.velocities + 3 * static_cast<std::size_t>(n));
    }
    /** Only where the motion has them. */
    Vector3 later_velocity(const unsigned int n) const
    {
      return Eigen::Map<const Vector3>(motion_.later_velocities + 3 * static_cast<std::size_t>(n));
    }

    /** Current vector area [mm^2]: half the cross product of the diagonals, exact for a bilinear
     * facet. */
    Vector3 vector_area(const unsigned int facet) const
    {
      const auto &k = facets_[facet];
      return 0.5 * (node(k[2]) - node(k[0])).cross(node(k[3]) - node(k[1]));
    }

    /** Offset of the true surface [mm], 0 for plain facets, less the relief of its edges. */
    double offset(const unsigned int facet, const double xi, const double eta) const
    {
      const double offset = offsets_.empty() ? 0. : offsets_.value(offset_rows_[facet], xi, eta);
      return relief_.empty() ? offset : offset - relief_.value(facet, xi, eta);
    }

    /** Derivatives of the offset with respect to xi and eta [mm]. */
    std::array<double, 2>
    offset_gradient(const unsigned int facet, const double xi, const double eta) const
    {
      std::array<double, 2> gradient = {{0., 0.}};
      if (!offsets_.empty())
        gradient = offsets_.gradient(offset_rows_[facet], xi, eta);
      if (!relief_.empty())
        {
          const auto slope = relief_.gradient(facet, xi, eta);
          gradient[0] -= slope[0];
          gradient[1] -= slope[1];
        }
      return gradient;
    }

    /** Largest offset of the table in magnitude at a 5 x 5 grid of each row, and relief [mm]. */
    double largest_offset() const
    {
      return largest_offset_;
    }

    /** Undeformed area elements |y_xi x y_eta| [mm^2] at (xi, eta) of the unit square. */
    double area_element(unsigned int facet, double xi, double eta) const;

    /** Of an undeformed facet the shorter one of the mean lengths of opposite sides [mm]. */
    double facet_width(unsigned int facet) const;

    /** Integrals of the corners' shape functions over the undeformed facet [mm^2]. */
    std::array<double, 4> corner_areas(unsigned int facet) const;

    /** What lies across a side: neighbour facet and the side by which it is entered. */
    struct Crossing
    {
      unsigned int facet;
      unsigned int side;
    };
    const Crossing &crossing(const unsigned int facet, const unsigned int side) const
    {
      return crossings_[facet][side];
    }

    /** Bit s is set when side s lies on the surface's border. */
    unsigned int border_sides(const unsigned int facet) const
    {
      return border_sides_[facet];
    }

    const std::array<unsigned int, 4> &corners(const unsigned int facet) const
    {
      return facets_[facet];
    }
    unsigned int n_facets() const
    {
      return static_cast<unsigned int>(facets_.size());
    }
    unsigned int n_nodes() const
    {
      return static_cast<unsigned int>(reference_.size());
    }
    unsigned int n_groups() const
    {
      return static_cast<unsigned int>(group_facets_.size());
    }
    const std::vector<unsigned int> &group_facets(const unsigned int g) const
    {
      return group_facets_[g];
    }
    /** Nodes of a group's facets and of all facets that touch them (their normals need those),
     * sorted. */
    const std::vector<unsigned int> &group_nodes(const unsigned int g) const
    {
      return group_nodes_[g];
    }
    const Vector3 &reference(const unsigned int n) const
    {
      return reference_[n];
    }
    /** Square root of the mean undeformed facet area [mm]. */
    double mean_facet_size() const
    {
      return mean_facet_size_;
    }
    /** Undeformed tributary areas of the nodes, integral of N_k [mm^2]. */
    const std::vector<double> &node_areas() const
    {
      return node_areas_;
    }
    const SurfaceMotion &motion() const
    {
      return motion_;
    }

  private:
    /** @p curved: the facets stand for the surface given by offsets and normals. */
    SurfaceGeometry(const FacetSurface &surface, bool curved, EdgeRelief relief);

    /** The surface. Throws InputError where its arrays do not fit each other. */
    static const FacetSurface &checked(const FacetSurface &surface);

    void           collect_groups(const FacetSurface &surface);
    void           connect(const FacetSurface &surface);
    void           compute_areas();
    void           compute_true_normals(const FacetSurface &surface);
    void           prepare(unsigned int facet);
    const Vector3 &node_normal(unsigned int node);

    std::vector<Vector3>                     reference_;
    std::vector<std::array<unsigned int, 4>> facets_;
    std::vector<std::array<Crossing, 4>>     crossings_;
    std::vector<unsigned char>               border_sides_;
    std::vector<unsigned int>                node_facet_starts_, node_facets_;
    std::vector<std::vector<unsigned int>>   group_facets_, group_nodes_;
    OffsetPolynomials                        offsets_;
    EdgeRelief                               relief_;
    std::vector<unsigned int>                offset_rows_;
    double                                   largest_offset_ = 0., mean_facet_size_ = 0.;
    std::vector<double>                      node_areas_;
    std::vector<Vector3>                     normal_corrections_; ///< N_true - N_facets

    SurfaceMotion              motion_ = {nullptr, nullptr, {}};
    std::uint64_t              stamp_  = 0;
    std::vector<FacetState>    states_;
    std::vector<Vector3>       node_normals_;
    std::vector<std::uint64_t> facet_stamps_, node_stamps_;
  };
} // namespace vfife

#endif
