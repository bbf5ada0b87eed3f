// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/system/fem_space.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>

namespace vfife
{
  namespace
  {
    void refuse_hanging_nodes(const Body &body)
    {
      if (body.mesh().triangulation.n_levels() > 1 && body.mesh().triangulation.has_hanging_nodes())
        throw InputError("body \"" + body.name() +
                         "\": its mesh is refined locally and has hanging nodes, which the finite "
                         "element solver does not take; refine it everywhere");
    }

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
  } // namespace

  const Choices<FemGeometry> &fem_geometry_choices()
  {
    static const Choices<FemGeometry> choices = {{"straight", FemGeometry::straight},
                                                 {"curved", FemGeometry::curved}};
    return choices;
  }

  FemSpace::FemSpace(const Model &model, const FemElement element, const FemGeometry geometry)
    : model_(&model)
    , element_(element)
    , geometry_(geometry)
    , n_local_((degree() + 1) * (degree() + 1) * (degree() + 1))
  {
  }

  FemSpace::FemSpace(const Model                     &model,
                     const std::vector<unsigned int> &bodies,
                     const FemElement                 element,
                     const FemGeometry                geometry)
    : FemSpace(model, element, geometry)
  {
    for (const unsigned int b : bodies)
      {
        const Body &body = model.bodies[b];
        refuse_hanging_nodes(body);
        add_part(b, body.mesh().triangulation, body.node_positions(), body.n_nodes());
        curve(parts_.back());
      }
  }

  void FemSpace::add_part(const unsigned int              b,
                          const dealii::Triangulation<3> &triangulation,
                          const std::vector<Vector3>     &nodes,
                          const unsigned int              n_nodes)
  {
    Part part{b, n_points(), 0, n_nodes, n_elements(), triangulation.n_active_cells()};
    for (const Vector3 &x : nodes)
      points_.push_back(model_->bodies[b].placement(x));

    const dealii::FE_Q<3> element(degree());
    dealii::DoFHandler<3> dofs(triangulation);
    dofs.distribute_dofs(element);
    const auto  numbers = dealii::FETools::lexicographic_to_hierarchic_numbering<3>(degree());
    const auto &places  = element.get_unit_support_points();
    std::vector<unsigned int>                    point_of(dofs.n_dofs(), none);
    std::vector<dealii::types::global_dof_index> of_cell(n_local_);
    for (const auto &cell : dofs.active_cell_iterators())
      {
        const auto corner = [&](const unsigned int v) {
          return part.first_point + cell->vertex_index(v);
        };
        cell->get_dof_indices(of_cell);
        for (const unsigned int a : numbers)
          {
            unsigned int &point = point_of[of_cell[a]];
            if (point == none && a < 8)
              point = corner(a);
            else if (point == none)
              {
                point         = n_points();
                Vector3 place = Vector3::Zero();
                for (unsigned int v = 0; v < 8; ++v)
                  place += dealii::GeometryInfo<3>::d_linear_shape_function(places[a], v) *
                           points_[corner(v)];
                points_.push_back(place);
              }
            element_points_.push_back(point);
          }
      }
    part.n_points = n_points() - part.first_point;
    parts_.push_back(part);
  }

  void FemSpace::curve(const Part &part)
  {
    if (degree() == 1 || geometry_ == FemGeometry::straight)
      return;
    // The cells of a sector are the first ones of the whole mesh, which has the manifolds.
    const Body               &body = model_->bodies[part.body];
    const dealii::FE_Q<3>     element(degree());
    const dealii::MappingQ<3> mapping(degree());
    dealii::FEValues<3>       values(mapping,
                               element,
                               dealii::Quadrature<3>(element.get_unit_support_points()),
                               dealii::update_quadrature_points);
    const auto        numbers = dealii::FETools::lexicographic_to_hierarchic_numbering<3>(degree());
    std::vector<bool> is_placed(part.n_points, false);
    auto              cell = body.mesh().triangulation.begin_active();
    for (unsigned int e = part.first_element; e < part.first_element + part.n_elements; ++e, ++cell)
      {
        values.reinit(cell);
        for (unsigned int a = 0; a < n_local_; ++a)
          {
            const unsigned int p = element_points(e)[a] - part.first_point;
            if (numbers[a] < 8 || is_placed[p])
              continue;
            const dealii::Point<3> &x     = values.quadrature_point(numbers[a]);
            points_[part.first_point + p] = body.placement(Vector3(x[0], x[1], x[2]));
            is_placed[p]                  = true;
          }
      }
    check_folds(part);
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
            text << "body \"" << body.name() << "\": element " << e - part.first_element
                 << " is folded where its edges follow the true surfaces: its Jacobian determinant "
                    "is "
                 << least.determinant << " mm^3 at (" << place[0] << ", " << place[1] << ", "
                 << place[2] << ") mm. Make the mesh finer there, or set Fem/geometry = straight.";
            throw NumericalError(text.str());
          }
      }
  }

  FemSpace FemSpace::sector_of(const Model       &model,
                               const unsigned int b,
                               const FemElement   element,
                               const FemGeometry  geometry)
  {
    const Body          &body      = model.bodies[b];
    const BodyStructure &structure = body.structure();
    if (structure.n_sectors() < 3 || structure.n_axis_nodes() > 0)
      throw InputError("body \"" + body.name() + "\" is not made of three or more equal sectors");
    if (!turns_about_sector_axis(body))
      throw InputError("body \"" + body.name() +
                       "\": cyclic symmetry needs sectors that are all alike, and its axis (axis "
                       "point, axis direction) is not the axis of its mesh's sectors; set it along "
                       "the mesh's z, in either sense, or leave cyclic symmetry at no");

    if (body.has_initial_strains())
      for (unsigned int e = 0; e < body.n_elements(); ++e)
        if (body.initial_strain(e) != body.initial_strain(structure.first_copy_of_element(e)))
          throw InputError("body \"" + body.name() +
                           "\": cyclic symmetry needs the same temperature in all sectors");
    if (body.materials().size() > 1)
      for (unsigned int e = 0; e < body.n_elements(); ++e)
        if (structure.material_of(e) != structure.material_of(structure.first_copy_of_element(e)))
          throw InputError("body \"" + body.name() +
                           "\": cyclic symmetry needs the same materials in all sectors");

    FemSpace           sector(model, element, geometry);
    const unsigned int n_nodes    = structure.nodes_per_sector(),
                       n_elements = structure.elements_per_sector();
    //   n_nodes + i  *---*---*       Nodes are those of sector 0 and, of sector 1, those on the
    //               / sector 0       common border (*): images of nodes i of sector 0, a pitch
    //            i o---o---o         further on. All other nodes are left out.
    //
    sector.sector_angle_ = structure.pitch();
    // Sector 1 must be sector 0 turned; the others are made in the same way.
    const auto          &X    = body.node_positions();
    const Matrix3        turn = rotation_about(Vector3::UnitZ(), sector.sector_angle_);
    std::vector<Vector3> nodes(X.begin(), X.begin() + n_nodes);
    double               size = 0;
    for (const Vector3 &x : nodes)
      size = std::max(size, x.norm());
    for (unsigned int i = 0; i < n_nodes; ++i)
      if ((turn * X[i] - X[n_nodes + i]).norm() > 1e-9 * size)
        throw InputError("body \"" + body.name() + "\": its sectors are not turned copies");
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
              throw InputError("body \"" + body.name() + "\": a sector touches more than the next");
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
    BodyMesh mesh;
    create_triangulation(mesh, nodes, cells);
    sector.add_part(b, mesh.triangulation, nodes, n_nodes);
    sector.add_images_between(mesh.triangulation);
    sector.curve(sector.parts_[0]);
    return sector;
  }

  void FemSpace::add_images_between(const dealii::Triangulation<3> &triangulation)
  {
    if (degree() == 1)
      return;
    // A face whose corners are images is the turned copy of the face of their originals.
    const std::map<unsigned int, unsigned int> originals(images_.begin(), images_.end());
    using Corners = std::array<unsigned int, 4>;
    std::map<Corners, std::vector<unsigned int>> lower, upper; // points of faces by corners
    for (const auto &cell : triangulation.active_cell_iterators())
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
            (n_images == 4 ? upper : lower)[corners] = face_points(cell->active_cell_index(), f);
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
            is_image[p] = true;
            images_.emplace_back(p,
                                 *std::min_element(among.begin(),
                                                   among.end(),
                                                   [&](const unsigned int i, const unsigned int j) {
                                                     return distance(i) < distance(j);
                                                   }));
          }
  }

  std::vector<unsigned int> FemSpace::face_points(const unsigned int e, const unsigned int f) const
  {
    // Points of an element are numbered with x fastest; a face lies at one end of its normal
    // direction d and is run through along d + 1 and d + 2, on the lower side the other way round
    // (find_boundary_faces).
    const unsigned int  n         = degree() + 1;
    const unsigned int *points    = element_points(e);
    const unsigned int  direction = f / 2, side = f % 2;
    const unsigned int  first = (direction + (side == 1 ? 1 : 2)) % 3,
                       second = (direction + (side == 1 ? 2 : 1)) % 3;
    std::vector<unsigned int> of_face;
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          std::array<unsigned int, 3> at;
          at[direction] = side * (n - 1);
          at[first]     = i;
          at[second]    = j;
          of_face.push_back(points[at[0] + n * (at[1] + n * at[2])]);
        }
    return of_face;
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
    return body.has_initial_strains() ? expand_nodes(X, body.initial_strain(e - part.first_element))
                                      : X;
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
    if (degree() > 1)
      {
        const Body                  &body = model_->bodies[part.body];
        const std::set<unsigned int> set(nodes.begin(), nodes.end());
        for (const auto &[image, original] : images_)
          if (original < part.n_nodes)
            inside[image] = set.count(body.structure().copy(original, 1)) != 0;
        // Edges through the interior between two nodes of the set are not part of it: only boundary
        // faces and their edges are, as for the areas of the nodes.
        unsigned int e = part.first_element;
        for (const auto &cell : body.mesh().triangulation.active_cell_iterators())
          {
            if (e == part.first_element + part.n_elements)
              break; // of a sector
            for (unsigned int f = 0; f < 6; ++f)
              if (cell->face(f)->at_boundary())
                add_face_points(face_points(e, f), degree() + 1, inside);
            ++e;
          }
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
                         " is not alike in all sectors: it has node " + std::to_string(node) +
                         " without its copy in the next one");
  }
} // namespace vfife
