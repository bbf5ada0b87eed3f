// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/surface/facet_integrals.h>
#include <vfife/contact/surface/smooth_patch.h>
#include <vfife/contact/surface/surface_geometry.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vfife
{
  SurfaceGeometry::SurfaceGeometry(const FacetSurface      &surface,
                                   const ContactSurfaceKind kind,
                                   EdgeRelief               relief)
    : SurfaceGeometry(kind == ContactSurfaceKind::smooth_patches
                        ? with_smooth_patches(checked(surface))
                        : checked(surface),
                      kind != ContactSurfaceKind::flat_facets,
                      std::move(relief))
  {
  }

  SurfaceGeometry::SurfaceGeometry(const FacetSurface &surface,
                                   const bool          curved,
                                   EdgeRelief          relief)
    : reference_(surface.positions)
    , facets_(surface.facets)
    , relief_(std::move(relief))
  {
    collect_groups(surface);
    connect(surface);
    compute_areas();
    if (curved && surface.offset_points > 0)
      {
        offsets_     = OffsetPolynomials(surface.offset_points, surface.offsets);
        offset_rows_ = surface.offset_row;
        for (const unsigned int row : offset_rows_)
          if (row >= offsets_.n_rows())
            throw InputError("surface \"" + surface.name + "\": an offset row does not exist");
        for (unsigned int row = 0; row < offsets_.n_rows(); ++row)
          for (unsigned int i = 0; i < 25; ++i)
            largest_offset_ =
              std::max(largest_offset_,
                       std::abs(offsets_.value(row, 0.25 * (i % 5), 0.25 * (i / 5))));
      }
    // Searches reach so much farther than the facets.
    largest_offset_ += relief_.largest();
    normal_corrections_.assign(n_nodes(), Vector3::Zero());
    if (curved)
      compute_true_normals(surface);
    states_.resize(n_facets());
    facet_stamps_.assign(n_facets(), 0);
    node_normals_.resize(n_nodes());
    node_stamps_.assign(n_nodes(), 0);
  }

  const FacetSurface &SurfaceGeometry::checked(const FacetSurface &surface)
  {
    const std::string name = "surface \"" + surface.name + "\": ";
    if (surface.facets.empty())
      throw InputError(name + "expected facets, got none");
    if (surface.neighbours.size() != surface.facets.size())
      throw InputError(name + "the facets' neighbours are missing (find_neighbours)");
    if (!surface.group.empty() && surface.group.size() != surface.facets.size())
      throw InputError(name + "every facet needs a group, or none");
    if (surface.normals.size() != surface.positions.size())
      throw InputError(name + "expected one normal per node");
    if (surface.offset_points > 0 && surface.offset_row.size() != surface.facets.size())
      throw InputError(name + "every facet needs a row of offsets");
    for (const auto &facet : surface.facets)
      for (const unsigned int n : facet)
        if (n >= surface.positions.size())
          throw InputError(name + "a facet refers to a node that does not exist");
    for (const unsigned int g : surface.group)
      if (g >= surface.n_groups)
        throw InputError(name + "a facet refers to a group that does not exist");
    return surface;
  }

  void SurfaceGeometry::collect_groups(const FacetSurface &surface)
  {
    // Facets of every node, one after the other.
    std::vector<std::vector<unsigned int>> facets_of_node(n_nodes());
    for (unsigned int f = 0; f < n_facets(); ++f)
      for (const unsigned int n : facets_[f])
        facets_of_node[n].push_back(f);
    node_facet_starts_.push_back(0);
    for (const auto &list : facets_of_node)
      {
        node_facets_.insert(node_facets_.end(), list.begin(), list.end());
        node_facet_starts_.push_back(static_cast<unsigned int>(node_facets_.size()));
      }

    // Facets of every group; without groups all are one.
    group_facets_.resize(surface.group.empty() ? 1 : surface.n_groups);
    for (unsigned int f = 0; f < n_facets(); ++f)
      group_facets_[surface.group.empty() ? 0 : surface.group[f]].push_back(f);

    // Nodes of every group, with those of all facets that touch them: normals are sums over facets.
    group_nodes_.resize(n_groups());
    for (unsigned int g = 0; g < n_groups(); ++g)
      {
        auto &nodes = group_nodes_[g];
        for (const unsigned int f : group_facets_[g])
          for (const unsigned int n : facets_[f])
            for (const unsigned int f2 : facets_of_node[n])
              nodes.insert(nodes.end(), facets_[f2].begin(), facets_[f2].end());
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      }
  }

  void SurfaceGeometry::connect(const FacetSurface &surface)
  {
    crossings_.resize(n_facets());
    border_sides_.assign(n_facets(), 0);
    for (unsigned int f = 0; f < n_facets(); ++f)
      for (unsigned int s = 0; s < 4; ++s)
        {
          const unsigned int other = surface.neighbours[f][s];
          crossings_[f][s]         = {FacetSurface::no_facet, 0};
          // A walk must stay in its group: results are kept by pairs of groups.
          if (other == FacetSurface::no_facet ||
              (!surface.group.empty() && surface.group[other] != surface.group[f]))
            {
              border_sides_[f] |= static_cast<unsigned char>(1u << s);
              continue;
            }
          // The neighbour has the common edge a-b as b-a: by which of its sides it is entered.
          const unsigned int a = facets_[f][s], b = facets_[f][(s + 1) % 4];
          for (unsigned int t = 0; t < 4; ++t)
            if (facets_[other][t] == b && facets_[other][(t + 1) % 4] == a)
              crossings_[f][s] = {other, t};
          if (crossings_[f][s].facet == FacetSurface::no_facet)
            throw InputError(
              "surface \"" + surface.name + "\": facets " + std::to_string(f) + " and " +
              std::to_string(other) +
              " are neighbours but not oriented alike (corners counter-clockwise from outside)");
        }
  }

  double
  SurfaceGeometry::area_element(const unsigned int facet, const double xi, const double eta) const
  {
    const auto   &k    = facets_[facet];
    const Vector3 y_xi = (1. - eta) * (reference_[k[1]] - reference_[k[0]]) +
                         eta * (reference_[k[2]] - reference_[k[3]]);
    const Vector3 y_eta = (1. - xi) * (reference_[k[3]] - reference_[k[0]]) +
                          xi * (reference_[k[2]] - reference_[k[1]]);
    return y_xi.cross(y_eta).norm();
  }

  double SurfaceGeometry::facet_width(const unsigned int facet) const
  {
    const auto &k = facets_[facet];
    return vfife::facet_width(
      {{reference_[k[0]], reference_[k[1]], reference_[k[2]], reference_[k[3]]}});
  }

  std::array<double, 4> SurfaceGeometry::corner_areas(const unsigned int facet) const
  {
    // Functions are counted along the sides: the third is that of the corner across.
    const auto &k = facets_[facet];
    const auto  areas =
      integrate_areas({{reference_[k[0]], reference_[k[1]], reference_[k[2]], reference_[k[3]]}});
    return {{areas[0], areas[1], areas[3], areas[2]}};
  }

  void SurfaceGeometry::compute_areas()
  {
    // A_k = sum over facets of the integral of N_k |y_xi x y_eta|.
    node_areas_.assign(n_nodes(), 0.);
    double total = 0.;
    for (unsigned int f = 0; f < n_facets(); ++f)
      {
        const std::array<double, 4> areas = corner_areas(f);
        for (unsigned int k = 0; k < 4; ++k)
          {
            node_areas_[facets_[f][k]] += areas[k];
            total += areas[k];
          }
      }
    mean_facet_size_ = std::sqrt(total / n_facets());
    if (!(mean_facet_size_ > 0.))
      throw InputError("a contact surface has no area");
  }

  void SurfaceGeometry::compute_true_normals(const FacetSurface &surface)
  {
    for (unsigned int n = 0; n < n_nodes(); ++n)
      {
        // How much the true normal N differs from that of the facets around, N_f.
        Vector3 sum = Vector3::Zero();
        for (unsigned int i = node_facet_starts_[n]; i < node_facet_starts_[n + 1]; ++i)
          {
            const auto &k = facets_[node_facets_[i]];
            sum += (reference_[k[2]] - reference_[k[0]]).cross(reference_[k[3]] - reference_[k[1]]);
          }
        if (!(sum.norm() > 0.))
          continue; // a node without facets is never asked for
        normal_corrections_[n] = surface.normals[n].normalized() - sum.normalized();
        if (normal_corrections_[n].norm() > 1.)
          throw InputError("surface \"" + surface.name + "\": the normal of surface node " +
                           std::to_string(n) +
                           " differs by more than 60 degrees from the facets around it");
      }
  }

  void SurfaceGeometry::bind(const SurfaceMotion &motion)
  {
    motion_ = motion;
    ++stamp_;
  }

  const Vector3 &SurfaceGeometry::node_normal(const unsigned int n)
  {
    if (node_stamps_[n] != stamp_)
      {
        // n = normalize(R (N - N_f) + n_f): the difference turns with the body.
        Vector3 sum = Vector3::Zero();
        for (unsigned int i = node_facet_starts_[n]; i < node_facet_starts_[n + 1]; ++i)
          sum += vector_area(node_facets_[i]);
        node_normals_[n] =
          (motion_.body.rotation * normal_corrections_[n] + sum.normalized()).normalized();
        node_stamps_[n] = stamp_;
      }
    return node_normals_[n];
  }

  void SurfaceGeometry::prepare(const unsigned int facet)
  {
    // From corner values to coefficients of 1, xi, eta, xi eta.
    const auto   &k  = facets_[facet];
    FacetState   &s  = states_[facet];
    const Vector3 y0 = node(k[0]), y1 = node(k[1]), y2 = node(k[2]), y3 = node(k[3]);
    s.y[0]            = y0;
    s.y[1]            = y1 - y0;
    s.y[2]            = y3 - y0;
    s.y[3]            = (y0 - y1) + (y2 - y3);
    const Vector3 &n0 = node_normal(k[0]), &n1 = node_normal(k[1]), &n2 = node_normal(k[2]),
                  &n3    = node_normal(k[3]);
    s.m[0]               = n0;
    s.m[1]               = n1 - n0;
    s.m[2]               = n3 - n0;
    s.m[3]               = (n0 - n1) + (n2 - n3);
    facet_stamps_[facet] = stamp_;
  }
} // namespace vfife
