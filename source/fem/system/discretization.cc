// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/system/discretization.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>

#include <algorithm>
#include <map>

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

    /** Marks the middles of face @p f (normal f / 2, lower or upper) whose corners are marked. */
    void
    add_face_middles(const unsigned int *points, const unsigned int f, std::vector<bool> &inside)
    {
      // Point i, j, k (0..2) of a cell has the number i + 3 j + 9 k; corners are
      // where all three are 0 or 2. The face is the plane where coordinate "normal"
      // is 0 or 2, spanned by the two others:
      //     6 7 8     as i + 3 j: corners 0 2 6 8, middles of edges 1 3 5 7,
      //     3 4 5     middle of the face 4
      //     0 1 2
      const unsigned int step[3] = {1, 3, 9};
      const unsigned int normal = f / 2, base = (f % 2) * 2 * step[normal],
                         s = step[(normal + 1) % 3], t = step[(normal + 2) % 3];
      const auto is_in = [&](const unsigned int i, const unsigned int j) {
        return bool(inside[points[base + i * s + j * t]]);
      };
      const auto mark = [&](const unsigned int i, const unsigned int j) {
        inside[points[base + i * s + j * t]] = true;
      };
      for (const unsigned int side : {0u, 2u})
        {
          if (is_in(0, side) && is_in(2, side))
            mark(1, side);
          if (is_in(side, 0) && is_in(side, 2))
            mark(side, 1);
        }
      if (is_in(0, 0) && is_in(2, 0) && is_in(0, 2) && is_in(2, 2))
        mark(1, 1);
    }
  } // namespace

  Discretization::Discretization(const Model &model, const FemElement element)
    : model_(&model)
    , element_(element)
    , n_local_(element == FemElement::quadratic ? 27 : 8)
  {
  }

  Discretization::Discretization(const Model                     &model,
                                 const std::vector<unsigned int> &bodies,
                                 const FemElement                 element)
    : Discretization(model, element)
  {
    for (const unsigned int body : bodies)
      add_body(body);
  }

  void Discretization::add_body(const unsigned int b)
  {
    const Body &body = model_->bodies[b];
    refuse_hanging_nodes(body);
    Part part{b, n_points(), body.n_nodes(), n_elements(), body.n_elements()};
    for (const Vector3 &x : body.node_positions())
      points_.push_back(body.placement(x));
    if (n_local_ == 8)
      for (const auto &nodes : body.elements())
        for (const std::uint32_t node : nodes)
          element_points_.push_back(part.first_point + node);
    else
      {
        add_middles(body, part);
        part.n_points = n_points() - part.first_point;
      }
    parts_.push_back(part);
  }

  void Discretization::add_middles(const Body &body, const Part &part)
  {
    // A middle is known by the corners it lies between: 2 of an edge, 4 of a face, 8 of a cell.
    std::map<std::vector<unsigned int>, unsigned int> middles;
    for (const auto &nodes : body.elements())
      for (unsigned int a = 0; a < 27; ++a)
        {
          // Corner v of the cell has coordinates 0 or 2 by its bits; it spans point a where they
          // agree or a lies in the middle of that direction.
          const unsigned int        at[3] = {a % 3, a / 3 % 3, a / 9};
          std::vector<unsigned int> corners;
          for (unsigned int v = 0; v < 8; ++v)
            {
              bool inside = true;
              for (unsigned int d = 0; d < 3; ++d)
                inside = inside && (at[d] == 1 || (v >> d & 1u) == at[d] / 2);
              if (inside)
                corners.push_back(part.first_point + nodes[v]);
            }
          if (corners.size() == 1)
            {
              element_points_.push_back(corners.front());
              continue;
            }
          Vector3 mean = Vector3::Zero();
          for (const unsigned int corner : corners)
            mean += points_[corner] / corners.size();
          std::sort(corners.begin(), corners.end());
          // Seen from the next cell the middle has the same corners, and so the same number.
          const auto found = middles.emplace(corners, n_points());
          if (found.second)
            points_.push_back(mean);
          element_points_.push_back(found.first->second);
        }
  }

  Discretization
  Discretization::sector_of(const Model &model, const unsigned int b, const FemElement element)
  {
    const Body          &body      = model.bodies[b];
    const BodyStructure &structure = body.structure();
    if (element == FemElement::quadratic)
      throw InputError("cyclic symmetry is there for elements with 8 nodes only");
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

    Discretization     sector(model, element);
    const unsigned int n_nodes    = structure.nodes_per_sector(),
                       n_elements = structure.elements_per_sector();
    //   n_nodes + i  *---*---*       Points are the nodes of sector 0 and, of sector 1, those
    //               / sector 0       on the common border (*): images of nodes i of sector 0, a
    //            i o---o---o         pitch further on. All other nodes are left out.
    //
    sector.sector_angle_ = structure.pitch();
    // Nodes and elements are numbered sector by sector: node i of sector s is s n_nodes + i. Sector
    // 1 must be sector 0 turned; the others are made in the same way.
    const auto   &X    = body.node_positions();
    const Matrix3 turn = rotation_about(Vector3::UnitZ(), sector.sector_angle_);
    double        size = 0;
    for (unsigned int i = 0; i < n_nodes; ++i)
      size = std::max(size, X[i].norm());
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        if ((turn * X[i] - X[n_nodes + i]).norm() > 1e-9 * size)
          throw InputError("body \"" + body.name() + "\": its sectors are not turned copies");
        sector.points_.push_back(body.placement(X[i]));
      }
    // Of nodes of sector 1: their points here.
    std::map<unsigned int, unsigned int> copies;
    for (unsigned int e = 0; e < n_elements; ++e)
      for (const std::uint32_t node : body.elements()[e])
        {
          // Elements of sector 0 reach into sector 1 at most, whose nodes
          // become images of those of sector 0.
          if (node < n_nodes)
            {
              sector.element_points_.push_back(node);
              continue;
            }
          if (node >= 2 * n_nodes)
            throw InputError("body \"" + body.name() + "\": a sector touches more than the next");
          const auto found = copies.emplace(node, sector.n_points());
          if (found.second)
            {
              sector.points_.push_back(body.placement(X[node]));
              sector.images_.emplace_back(found.first->second, node - n_nodes);
            }
          sector.element_points_.push_back(found.first->second);
        }
    sector.parts_.push_back({b, 0, sector.n_points(), 0, n_elements});
    return sector;
  }

  ElementNodes Discretization::element_nodes(const unsigned int e) const
  {
    ElementNodes        X(3, n_local_);
    const unsigned int *p = element_points(e);
    for (unsigned int a = 0; a < n_local_; ++a)
      X.col(a) = points_[p[a]];
    return X;
  }

  ElementNodes Discretization::stress_free_nodes(const unsigned int e) const
  {
    const Part        &part = part_of_element(e);
    const Body        &body = model_->bodies[part.body];
    const ElementNodes X    = element_nodes(e);
    return body.has_initial_strains() ? expand_nodes(X, body.initial_strain(e - part.first_element))
                                      : X;
  }

  Eigen::VectorXd Discretization::gather_from_stress_free(const unsigned int         e,
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

  const Discretization::Part &Discretization::part_of_element(const unsigned int e) const
  {
    std::size_t i = 0;
    while (e >= parts_[i].first_element + parts_[i].n_elements)
      ++i;
    return parts_[i];
  }

  const Discretization::Part &Discretization::part_of_point(const unsigned int p) const
  {
    std::size_t i = 0;
    while (p >= parts_[i].first_point + parts_[i].n_points)
      ++i;
    return parts_[i];
  }

  const Discretization::Part *Discretization::find_part(const unsigned int body) const
  {
    for (const Part &part : parts_)
      if (part.body == body)
        return &part;
    return nullptr;
  }

  std::vector<unsigned int> Discretization::points_of(const Part                      &part,
                                                      const std::vector<unsigned int> &nodes) const
  {
    // Images are no own points: what holds or loads them, does so at their originals.
    const unsigned int n_own = part.n_points - images_.size();
    std::vector<bool>  inside(n_points(), false);
    for (const unsigned int node : nodes)
      if (node < n_own)
        inside[part.first_point + node] = true;

    // A middle belongs to a set when the corners around it do: sets name corner nodes.
    if (n_local_ == 27)
      {
        // Edges through the interior between two nodes of the set are not part of it: only
        // boundary faces and their edges are, as for the areas of the nodes.
        unsigned int e = part.first_element;
        for (const auto &cell :
             model_->bodies[part.body].mesh().triangulation.active_cell_iterators())
          {
            const unsigned int *p = element_points(e++);
            for (unsigned int f = 0; f < 6; ++f)
              if (cell->face(f)->at_boundary())
                add_face_middles(p, f, inside);
          }
      }
    std::vector<unsigned int> points;
    for (unsigned int p = 0; p < inside.size(); ++p)
      if (inside[p])
        points.push_back(p);
    return points;
  }

  Eigen::VectorXd Discretization::gather(const unsigned int e, const std::vector<double> &u) const
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
