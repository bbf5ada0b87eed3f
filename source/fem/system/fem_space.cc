// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "refined_mesh.h"

#include <vfife/base/errors.h>
#include <vfife/fem/system/fem_space.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <sstream>

namespace vfife
{
  namespace
  {
    constexpr unsigned int none = static_cast<unsigned int>(-1);

    /** Marks the points of a face, n along each side, on edges whose ends are marked, and all where
     * its corners are. */
    void add_face_points(const std::vector<unsigned int> &points,
                         const unsigned int               n,
                         std::vector<bool>               &inside)
    {
      const auto at = [&](const unsigned int i,
                          const unsigned int j) -> std::vector<bool>::reference {
        return inside[points[i + n * j]];
      };
      const unsigned int last    = n - 1;
      const bool         corners = at(0, 0) && at(last, 0) && at(0, last) && at(last, last);
      for (unsigned int k = 1; k < last; ++k)
        {
          for (const unsigned int side : {0u, last})
            {
              if (at(0, side) && at(last, side))
                at(k, side) = true;
              if (at(side, 0) && at(side, last))
                at(side, k) = true;
            }
          for (unsigned int j = 1; corners && j < last; ++j)
            at(k, j) = true;
        }
    }

    /** Place of a part, or a copy of it, in the list. */
    std::size_t index_of(const std::vector<FemSpace::Part> &parts, const FemSpace::Part &part)
    {
      std::size_t i = 0;
      while (parts[i].first_point != part.first_point)
        ++i;
      return i;
    }

    /** Marks the middles of divided edges and faces whose corners are marked (by vertex). */
    void add_middles(const dealii::Triangulation<3>::face_iterator &face, std::vector<bool> &inside)
    {
      if (!face->has_children())
        return;
      bool all = true;
      for (unsigned int k = 0; k < 4; ++k)
        {
          const auto edge = face->line(k);
          all             = all && inside[face->vertex_index(k)];
          if (inside[edge->vertex_index(0)] && inside[edge->vertex_index(1)])
            inside[edge->child(0)->vertex_index(1)] = true;
        }
      if (all)
        inside[face->child(0)->vertex_index(3)] = true;
      for (unsigned int k = 0; k < 4; ++k)
        add_middles(face->child(k), inside);
    }
  } // namespace

  FemSpace::FemSpace(const Model &model, const FemSpaceOptions &options)
    : model_(&model)
    , options_(options)
    , refinements_(read_local_refinements(options.local_refinement))
    , n_local_((degree() + 1) * (degree() + 1) * (degree() + 1))
  {
    check_refinements(model, refinements_);
  }

  FemSpace::FemSpace(const Model                     &model,
                     const std::vector<unsigned int> &bodies,
                     const FemSpaceOptions           &options)
    : FemSpace(model, options)
  {
    for (const unsigned int b : bodies)
      {
        const Body                            &body = model.bodies[b];
        std::vector<std::vector<unsigned int>> divisions;
        for (const FemSpaceOptions::Division &division : options.divisions)
          {
            const auto found = division.find(b);
            divisions.push_back(found == division.end() ? std::vector<unsigned int>()
                                                        : found->second);
          }
        const auto mesh = std::make_shared<const RefinedMesh>(body, refinements_, divisions);
        add_part(b, mesh, *mesh, body.node_positions(), body.n_nodes());
      }
  }

  void FemSpace::add_part(const unsigned int                        b,
                          const std::shared_ptr<const RefinedMesh> &mesh,
                          const RefinedMesh                        &whole,
                          const std::vector<Vector3>               &nodes,
                          const unsigned int                        n_nodes)
  {
    const Body &body = model_->bodies[b];
    Part        part{b, n_points(), 0, n_nodes, n_elements(), unsigned(mesh->elements().size())};
    for (const Vector3 &x : nodes)
      points_.push_back(body.placement(x));

    // 1. Points by the degrees of freedom of a scalar field.
    const dealii::FE_Q<3> element(degree());
    dealii::DoFHandler<3> dofs(mesh->triangulation());
    dofs.distribute_dofs(element);
    const auto numbers = dealii::FETools::lexicographic_to_hierarchic_numbering<3>(degree());
    std::vector<unsigned int> point_of(dofs.n_dofs(), none);
    std::vector<unsigned int> point_of_vertex(mesh->triangulation().n_vertices());
    std::vector<dealii::types::global_dof_index> of_cell(n_local_);
    for (const RefinedMesh::Element &e : mesh->elements())
      {
        const dealii::DoFHandler<3>::active_cell_iterator cell(&mesh->triangulation(),
                                                               e.cell->level(),
                                                               e.cell->index(),
                                                               &dofs);
        cell->get_dof_indices(of_cell);
        for (const unsigned int a : numbers)
          {
            unsigned int &point = point_of[of_cell[a]];
            if (point == none && a < 8 && cell->vertex_index(a) < nodes.size())
              point = part.first_point + cell->vertex_index(a);
            else if (point == none)
              {
                point = n_points();
                points_.emplace_back(Vector3::Zero());
              }
            if (a < 8)
              point_of_vertex[cell->vertex_index(a)] = point;
            element_points_.push_back(point);
          }
        parents_.push_back(e.parent);
      }
    part.n_points = n_points() - part.first_point;
    parts_.push_back(part);
    meshes_.push_back(mesh);
    point_of_vertex_.push_back(std::move(point_of_vertex));

    // 2. What hangs, and where all lie.
    if (mesh->is_refined())
      {
        dealii::AffineConstraints<double> lines;
        dealii::DoFTools::make_hanging_node_constraints(dofs, lines);
        lines.close();
        for (const auto &line : lines.get_lines())
          {
            auto &masters = hanging_[point_of[line.index]];
            for (const auto &[dof, weight] : line.entries)
              masters.emplace_back(point_of[dof], weight);
          }
      }
    place_points(whole, nodes.size());
  }

  void FemSpace::place_points(const RefinedMesh &whole, const unsigned int n_given)
  {
    const Part               &part      = parts_.back();
    const RigidMotion        &placement = model_->bodies[part.body].placement;
    const RefinedMesh        &mesh      = *meshes_.back();
    const bool                is_curved = degree() > 1 && options_.geometry == FemGeometry::curved;
    const dealii::FE_Q<3>     element(degree());
    const auto               &places = element.get_unit_support_points();
    const dealii::MappingQ<3> mapping(degree());
    dealii::FEValues<3>       values(mapping,
                               element,
                               dealii::Quadrature<3>(places),
                               dealii::update_quadrature_points);
    const auto numbers  = dealii::FETools::lexicographic_to_hierarchic_numbering<3>(degree());
    const auto to_fixed = [&](const dealii::Point<3> &x) {
      return placement(Vector3(x[0], x[1], x[2]));
    };
    std::vector<bool> is_placed(part.n_points, false);
    std::fill_n(is_placed.begin(), n_given, true);
    // What hangs has its masters in coarser elements.
    const auto take = [&](const unsigned int point, const Vector3 &place) {
      const auto found = hanging_.find(point);
      points_[point]   = place;
      if (found != hanging_.end())
        {
          points_[point].setZero();
          for (const auto &[master, weight] : found->second)
            points_[point] += weight * points_[master];
        }
      is_placed[point - part.first_point] = true;
    };
    for (unsigned int level = 0; level < mesh.triangulation().n_levels(); ++level)
      for (unsigned int e = 0; e < part.n_elements; ++e)
        {
          if (mesh.elements()[e].cell->level() != static_cast<int>(level))
            continue;
          const unsigned int *points  = element_points(part.first_element + e);
          const auto          is_open = [&](const unsigned int a) {
            return !is_placed[points[a] - part.first_point];
          };
          // The elements of a sector are the first ones of the whole mesh, which has the true
          // surfaces.
          const RefinedMesh::Cell &cell = whole.elements()[e].cell;
          bool                     any  = false;
          for (unsigned int a = 0; a < n_local_; ++a)
            if (is_open(a) && numbers[a] < 8)
              take(points[a], to_fixed(cell->vertex(numbers[a])));
            else
              any = any || is_open(a);
          if (any && is_curved)
            values.reinit(cell);
          for (unsigned int a = 0; any && a < n_local_; ++a)
            if (is_open(a))
              {
                Vector3 place = Vector3::Zero();
                if (is_curved)
                  place = to_fixed(values.quadrature_point(numbers[a]));
                else
                  for (unsigned int v = 0; v < 8; ++v)
                    place +=
                      dealii::GeometryInfo<3>::d_linear_shape_function(places[numbers[a]], v) *
                      points_[corner(part.first_element + e, v)];
                take(points[a], place);
              }
        }
    if (is_curved || mesh.is_refined())
      check_folds(part);
  }

  Vector3 compute_mean(const PointWeights &weights, const std::vector<double> &u)
  {
    Vector3 mean = Vector3::Zero();
    for (const auto &[point, weight] : weights)
      mean += weight * Eigen::Map<const Vector3>(u.data() + 3 * std::size_t(point));
    return mean;
  }

  void FemSpace::move_to_masters(std::vector<double> &forces) const
  {
    for (const auto &[point, masters] : hanging_)
      {
        Eigen::Map<Vector3> own(forces.data() + 3 * std::size_t(point));
        for (const auto &[master, weight] : masters)
          Eigen::Map<Vector3>(forces.data() + 3 * std::size_t(master)) += weight * own;
        own.setZero();
      }
  }

  unsigned int FemSpace::n_body_elements(const Part &part) const
  {
    return meshes_[index_of(parts_, part)]->n_parents();
  }

  unsigned int FemSpace::corner(const unsigned int e, const unsigned int v) const
  {
    const unsigned int n = degree() + 1, last = degree();
    return element_points(
      e)[(v & 1u) * last + n * ((v >> 1 & 1u) * last + n * (v >> 2 & 1u) * last)];
  }

  void FemSpace::check_folds(const Part &part) const
  {
    for (unsigned int e = part.first_element; e < part.first_element + part.n_elements; ++e)
      {
        const ElementNodes  X     = element_nodes(e);
        const JacobianPoint least = find_least_jacobian(X);
        if (!(least.determinant > 0.))
          {
            const Body   &body = model_->bodies[part.body];
            const Vector3 place =
              body.placement.rotation.transpose() * (least.place - body.placement.translation);
            std::ostringstream text;
            text << "body \"" << body.name() << "\": element " << parents_[e]
                 << " is folded where its edges follow the true surfaces: its Jacobian determinant "
                    "is "
                 << least.determinant << " mm^3 at (" << place[0] << ", " << place[1] << ", "
                 << place[2] << ") mm. Make the mesh finer there, or set Fem/geometry = straight.";
            throw NumericalError(text.str());
          }
      }
  }

  FemSpace
  FemSpace::sector_of(const Model &model, const unsigned int b, const FemSpaceOptions &options)
  {
    const Body          &body      = model.bodies[b];
    const BodyStructure &structure = body.structure();
    if (structure.n_sectors() < 3)
      throw InputError("body \"" + body.name() + "\" is not made of three or more equal sectors");
    if (!turns_about_sector_axis(body))
      throw InputError("body \"" + body.name() +
                       "\": cyclic symmetry requires the axis of its sectors, but its axis (axis "
                       "point, axis direction) differs. Set it along the mesh's z, in either "
                       "sense, or set cyclic symmetry = no");

    // Temperatures are formulas of places, which differ by round-off.
    constexpr double round_off = 1e-12;
    for (unsigned int e = 0; e < body.n_elements(); ++e)
      {
        const ElementKind kind    = body.kind_of(e),
                          first   = body.kind_of(structure.first_copy_of_element(e));
        const bool other_material = kind.material != first.material;
        if (other_material || std::abs(kind.initial_strain - first.initial_strain) > round_off)
          throw InputError("body \"" + body.name() + "\": cyclic symmetry needs the same " +
                           (other_material ? "materials" : "temperature") + " in all sectors");
      }

    FemSpace           sector(model, options);
    const unsigned int n_nodes    = structure.nodes_per_sector(),
                       n_elements = structure.elements_per_sector();
    //   n_nodes + i  *---*---*       Nodes are those of sector 0 and, of sector 1, those on the
    //               / sector 0       common border (*): images of nodes i of sector 0, a pitch
    //            i o---o---o         further on. All other nodes are left out.
    //
    sector.sector_angle_ = structure.pitch();
    // Sector 1 must be sector 0 turned; the others are made in the same way.
    const auto          &X    = body.node_positions();
    const Matrix3        turn = structure.turn(1);
    std::vector<Vector3> nodes(X.begin(), X.begin() + n_nodes);
    double               size = 0;
    for (const Vector3 &x : nodes)
      size = std::max(size, x.norm());
    for (unsigned int i = 0; i < n_nodes; ++i)
      if ((turn * X[i] - X[n_nodes + i]).norm() > 1e-9 * size)
        throw InputError("body \"" + body.name() + "\": its sectors are not rotated copies");
    // Of nodes of sector 1: their points here.
    std::map<unsigned int, unsigned int> copies;
    std::vector<CellNodes>               cells;
    for (unsigned int e = 0; e < n_elements; ++e)
      {
        CellNodes cell;
        for (unsigned int v = 0; v < 8; ++v)
          {
            // Elements of sector 0 reach into sector 1 at most, whose nodes become images of those
            // of sector 0.
            const std::uint32_t node = body.elements()[e][v];
            cell[v]                  = node;
            if (node < n_nodes)
              continue;
            if (node >= 2 * n_nodes)
              throw InputError("body \"" + body.name() +
                               "\": a sector adjoins other sectors than the next");
            const auto found = copies.emplace(node, nodes.size());
            if (found.second)
              {
                nodes.push_back(X[node]);
                sector.images_.emplace_back(found.first->second, node - n_nodes);
              }
            cell[v] = found.first->second;
          }
        cells.push_back(cell);
      }
    const RefinedMesh whole(body, sector.refinements_);
    sector.add_part(
      b, std::make_shared<const RefinedMesh>(nodes, cells, whole), whole, nodes, n_nodes);
    sector.add_images_between();
    return sector;
  }

  void FemSpace::add_images_between()
  {
    if (degree() == 1 && !meshes_[0]->is_refined())
      return;
    // A face of the body whose corners are images is the turned copy of the face of their
    // originals.
    const std::map<unsigned int, unsigned int> originals(images_.begin(), images_.end());
    using Corners = std::array<unsigned int, 4>;
    std::map<Corners, std::vector<unsigned int>> lower, upper; // points of faces by corners
    for (const auto &cell : meshes_[0]->triangulation().cell_iterators_on_level(0))
      for (unsigned int f = 0; f < 6; ++f)
        if (cell->face(f)->at_boundary())
          {
            Corners      corners;
            unsigned int n_images = 0;
            for (unsigned int k = 0; k < 4; ++k)
              {
                const auto found = originals.find(cell->face(f)->vertex_index(k));
                n_images += found != originals.end() ? 1 : 0;
                corners[k] =
                  found != originals.end() ? found->second : cell->face(f)->vertex_index(k);
              }
            std::sort(corners.begin(), corners.end());
            auto &points = (n_images == 4 ? upper : lower)[corners];
            for (const auto &face : points_on_face(parts_[0], cell->index(), f))
              points.insert(points.end(), face.begin(), face.end());
          }
    const Axis        axis = compute_sector_axis(model_->bodies[parts_[0].body]);
    const Matrix3     back = rotation_about(axis.direction, -sector_angle_);
    std::vector<bool> is_image(n_points(), false);
    for (const auto &image : images_)
      is_image[image.first] = true;
    for (const auto &[corners, points] : upper)
      for (const unsigned int p : points)
        if (!is_image[p])
          {
            const Vector3 place    = axis.point + back * (points_[p] - axis.point);
            const auto   &among    = lower.at(corners);
            const auto    distance = [&](const unsigned int i) {
              return (points_[i] - place).squaredNorm();
            };
            const unsigned int original =
              *std::min_element(among.begin(),
                                among.end(),
                                [&](const unsigned int i, const unsigned int j) {
                                  return distance(i) < distance(j);
                                });
            if ((hanging_.count(p) != 0) != (hanging_.count(original) != 0))
              throw NumericalError("the two borders of a sector are divided differently");
            is_image[p] = true;
            images_.emplace_back(p, original);
          }
  }

  std::vector<unsigned int> FemSpace::face_points(const unsigned int e, const unsigned int f) const
  {
    std::vector<unsigned int> points = numbers_on_face(degree(), f);
    for (unsigned int &point : points)
      point = element_points(e)[point];
    return points;
  }

  std::vector<std::vector<unsigned int>>
  FemSpace::points_on_face(const Part &part, const unsigned int element, const unsigned int f) const
  {
    const RefinedMesh                     &mesh = *meshes_[index_of(parts_, part)];
    std::vector<std::vector<unsigned int>> faces;
    for (unsigned int e = mesh.first_of(element); e < mesh.first_of(element + 1); ++e)
      if ((mesh.elements()[e].faces >> f & 1u) != 0)
        faces.push_back(face_points(part.first_element + e, f));
    return faces;
  }

  ElementNodes FemSpace::element_nodes(const unsigned int e) const
  {
    ElementNodes        X(3, n_local_);
    const unsigned int *p = element_points(e);
    for (unsigned int a = 0; a < n_local_; ++a)
      X.col(a) = points_[p[a]];
    return X;
  }

  ElementNodes FemSpace::stress_free_nodes(const unsigned int e) const
  {
    const Part        &part = part_of_element(e);
    const Body        &body = model_->bodies[part.body];
    const ElementNodes X    = element_nodes(e);
    return body.has_initial_strains() ? expand_nodes(X, body.initial_strain(parents_[e])) : X;
  }

  Eigen::VectorXd FemSpace::gather_from_stress_free(const unsigned int         e,
                                                    const std::vector<double> &u) const
  {
    Eigen::VectorXd v = gather(e, u);
    if (model_->bodies[part_of_element(e).body].has_initial_strains())
      {
        const ElementNodes free = stress_free_nodes(e) - element_nodes(e);
        v -= Eigen::Map<const Eigen::VectorXd>(free.data(), free.size());
      }
    return v;
  }

  dealii::Triangulation<3>::cell_iterator FemSpace::cell(const unsigned int e) const
  {
    const Part &part = part_of_element(e);
    return meshes_[index_of(parts_, part)]->elements()[e - part.first_element].cell;
  }

  const FemSpace::Part &FemSpace::part_of_element(const unsigned int e) const
  {
    std::size_t i = 0;
    while (e >= parts_[i].first_element + parts_[i].n_elements)
      ++i;
    return parts_[i];
  }

  const FemSpace::Part &FemSpace::part_of_point(const unsigned int p) const
  {
    std::size_t i = 0;
    while (p >= parts_[i].first_point + parts_[i].n_points)
      ++i;
    return parts_[i];
  }

  const FemSpace::Part *FemSpace::find_part(const unsigned int body) const
  {
    for (const Part &part : parts_)
      if (part.body == body)
        return &part;
    return nullptr;
  }

  std::vector<unsigned int> FemSpace::points_of(const Part                      &part,
                                                const std::vector<unsigned int> &nodes) const
  {
    // Images are no own points: what holds or loads them, does so at their originals.
    std::vector<bool> inside(n_points(), false);
    for (const unsigned int node : nodes)
      if (node < part.n_nodes)
        inside[part.first_point + node] = true;
    const RefinedMesh &mesh = *meshes_[index_of(parts_, part)];
    if (degree() > 1 || mesh.is_refined())
      {
        const Body                  &body = model_->bodies[part.body];
        const std::set<unsigned int> set(nodes.begin(), nodes.end());
        for (const auto &[image, original] : images_)
          if (original < part.n_nodes)
            inside[image] = set.count(body.structure().copy(original, 1)) != 0;
        // Edges through the interior between two nodes of the set are not part of it: only boundary
        // faces and their edges are, as for the areas of the nodes.
        std::vector<std::pair<unsigned int, unsigned int>> faces; // elements of the body, numbers
        for (const auto &cell : body.mesh().triangulation.active_cell_iterators())
          for (unsigned int f = 0; f < 6 && cell->active_cell_index() < mesh.n_parents(); ++f)
            if (cell->face(f)->at_boundary())
              faces.emplace_back(cell->active_cell_index(), f);
        if (mesh.is_refined())
          {
            const auto       &point_of = point_of_vertex_[index_of(parts_, part)];
            std::vector<bool> marked(point_of.size());
            for (std::size_t v = 0; v < marked.size(); ++v)
              marked[v] = inside[point_of[v]];
            for (const auto &[e, f] : faces)
              add_middles(RefinedMesh::Cell(&mesh.triangulation(), 0, e)->face(f), marked);
            for (std::size_t v = 0; v < marked.size(); ++v)
              inside[point_of[v]] = marked[v];
          }
        for (const auto &[e, f] : faces)
          for (const auto &points : points_on_face(part, e, f))
            add_face_points(points, degree() + 1, inside);
        for (const auto &image : images_)
          inside[image.first] = false;
      }
    std::vector<unsigned int> points;
    for (unsigned int p = 0; p < inside.size(); ++p)
      if (inside[p])
        points.push_back(p);
    return points;
  }

  Eigen::VectorXd FemSpace::gather(const unsigned int e, const std::vector<double> &u) const
  {
    Eigen::VectorXd     values(3 * n_local_);
    const unsigned int *p = element_points(e);
    for (unsigned int a = 0; a < n_local_; ++a)
      for (unsigned int c = 0; c < 3; ++c)
        values[3 * a + c] = u[3 * static_cast<std::size_t>(p[a]) + c];
    return values;
  }

  std::vector<unsigned int> all_bodies(const Model &model)
  {
    std::vector<unsigned int> bodies(model.bodies.size());
    std::iota(bodies.begin(), bodies.end(), 0u);
    return bodies;
  }

  void require_all_copies(const Body                      &body,
                          const std::vector<unsigned int> &nodes,
                          const std::string               &what)
  {
    std::vector<bool> inside(body.n_nodes(), false);
    for (const unsigned int node : nodes)
      inside[node] = true;
    for (const unsigned int node : nodes)
      if (!inside[body.structure().copy(node, 1)])
        throw InputError("body \"" + body.name() + "\": " + what +
                         " differs between sectors: it has node " + std::to_string(node) +
                         " without its copy in the next sector");
  }
} // namespace vfife
