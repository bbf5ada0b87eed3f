// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  Body::Body(std::string name, std::unique_ptr<BodyMesh> mesh, const Material &material)
    : Body(std::move(name), std::vector<Material>{material}, std::move(mesh))
  {
  }

  Body::Body(std::string name, std::vector<Material> materials, std::unique_ptr<BodyMesh> mesh)
    : name_(std::move(name))
    , mesh_(std::move(mesh))
    , materials_(std::move(materials))
  {
    if (mesh_->triangulation.has_hanging_nodes())
      throw InputError("body \"" + name_ +
                       "\": expected elements that meet in whole faces, got hanging nodes. Refine "
                       "the mesh everywhere");
    // A triangulation that was not made by create_triangulation() has one sector.
    if (mesh_->structure.elements_per_sector() == 0)
      mesh_->structure =
        BodyStructure(1, mesh_->triangulation.n_vertices(), mesh_->triangulation.n_active_cells());

    // Plain arrays for the kernels: places, elements and masses in the order of the triangulation's
    // vertices and active cells. deal.II's order of a cell's vertices is that of HexahedronNodes.
    const auto &vertices = mesh_->triangulation.get_vertices();
    node_positions_.reserve(vertices.size());
    for (const auto &v : vertices)
      node_positions_.emplace_back(v[0], v[1], v[2]);

    elements_.reserve(mesh_->triangulation.n_active_cells());
    for (const auto &cell : mesh_->triangulation.active_cell_iterators())
      {
        std::array<std::uint32_t, 8> nodes;
        for (unsigned int i = 0; i < 8; ++i)
          nodes[i] = cell->vertex_index(i);
        elements_.push_back(nodes);
      }
    compute_masses();
  }

  Body::Body(std::string                               name,
             std::vector<Material>                     materials,
             std::vector<Vector3>                      nodes,
             std::vector<std::array<std::uint32_t, 8>> elements,
             std::unique_ptr<BodyMesh>                 parts)
    : name_(std::move(name))
    , mesh_(std::move(parts))
    , materials_(std::move(materials))
    , node_positions_(std::move(nodes))
    , elements_(std::move(elements))
  {
    if (mesh_->structure.elements_per_sector() == 0)
      mesh_->structure = BodyStructure(1, n_nodes(), n_elements());
    compute_masses();
  }

  void Body::compute_masses()
  {
    node_masses_.assign(n_nodes(), 0.);
    for (unsigned int e = 0; e < n_elements(); ++e)
      {
        const HexahedronNodes nodes = element_nodes(e);
        // At the Gauss points, where masses and stiffness are made. Refused here, where element and
        // place can be named, rather than by a kernel in the middle of a run.
        if (!(compute_least_gauss_jacobian(nodes) > 0))
          {
            const Vector3 c = nodes.rowwise().mean();
            throw InputError(
              "body \"" + name_ + "\": element " + std::to_string(e) + " at (" +
              std::to_string(c[0]) + ", " + std::to_string(c[1]) + ", " + std::to_string(c[2]) +
              ") mm of the body frame is inverted. Change the mesh or the body sizes");
          }
        // M_a = sum over elements of rho int N_a dV
        const auto masses = compute_lumped_mass(nodes, material(e).density);
        for (unsigned int i = 0; i < 8; ++i)
          node_masses_[elements_[e][i]] += masses[i];
      }
    for (const double m : node_masses_)
      mass_ += m;
  }

  Body::Body(Body &&) noexcept = default;
  Body::~Body()                = default;

  const std::string &Body::name() const
  {
    return name_;
  }

  const BodyMesh &Body::mesh() const
  {
    return *mesh_;
  }

  const BodyStructure &Body::structure() const
  {
    return mesh_->structure;
  }

  const std::vector<Material> &Body::materials() const
  {
    return materials_;
  }

  const Material &Body::material(const unsigned int element) const
  {
    return materials_[structure().material_of(element)];
  }

  const Material &Body::material_under(const std::vector<unsigned int> &nodes,
                                       const std::string               &what) const
  {
    if (materials_.size() == 1)
      return materials_.front();
    std::vector<bool> among(n_nodes(), false);
    for (const unsigned int node : nodes)
      among[node] = true;
    const Material *found = nullptr;
    for (unsigned int e = 0; e < n_elements(); ++e)
      {
        // Four corners that differ in two of the three directions are a face.
        bool has_face = false;
        for (unsigned int d = 0; d < 3; ++d)
          for (unsigned int side = 0; side < 2; ++side)
            {
              bool whole = true;
              for (unsigned int v = 0; v < 8; ++v)
                whole = whole && ((v >> d & 1u) != side || among[elements_[e][v]]);
              has_face = has_face || whole;
            }
        if (!has_face)
          continue;
        if (found != nullptr && found != &material(e))
          throw InputError("body \"" + name_ + "\": expected one material under " + what +
                           ", got \"" + found->name + "\" and \"" + material(e).name +
                           "\". Give them surfaces of their own.");
        found = &material(e);
      }
    if (found == nullptr)
      throw InputError("body \"" + name_ + "\": no element has a face on " + what);
    return *found;
  }

  double Body::sound_speed() const
  {
    double speed = 0;
    for (const Material &material : materials_)
      speed = std::max(speed, std::sqrt(material.youngs_modulus / material.density));
    return speed;
  }

  unsigned int Body::n_nodes() const
  {
    return node_positions_.size();
  }

  unsigned int Body::n_elements() const
  {
    return elements_.size();
  }

  const std::vector<Vector3> &Body::node_positions() const
  {
    return node_positions_;
  }

  const std::vector<double> &Body::node_masses() const
  {
    return node_masses_;
  }

  const std::vector<std::array<std::uint32_t, 8>> &Body::elements() const
  {
    return elements_;
  }

  HexahedronNodes Body::element_nodes(const unsigned int element) const
  {
    HexahedronNodes nodes;
    for (unsigned int i = 0; i < 8; ++i)
      nodes.col(i) = node_positions_[elements_[element][i]];
    return nodes;
  }

  void Body::require_no_initial_strains(const std::string &method) const
  {
    if (has_initial_strains())
      throw InputError("body \"" + name_ + "\": expected temperature = 0 for " + method +
                       ", got another one. Set it to 0, or use the study kind run.");
  }

  void Body::add_initial_strains(const std::vector<double> &strains)
  {
    initial_strains_.resize(n_elements(), 0.);
    for (unsigned int e = 0; e < n_elements(); ++e)
      initial_strains_[e] += strains[e];
  }

  HexahedronNodes Body::stress_free_nodes(const unsigned int element) const
  {
    HexahedronNodes X = element_nodes(element);
    if (has_initial_strains())
      X = expand_nodes(X, initial_strain(element));
    return X;
  }

  void Body::add_masses(const std::vector<double> &masses)
  {
    for (std::size_t i = 0; i < masses.size(); ++i)
      {
        // Counts in inertia and in loads that are masses times something, not in the elements'
        // density.
        node_masses_[i] += masses[i];
        mass_ += masses[i];
        added_mass_ += masses[i];
      }
  }

  double Body::added_mass() const
  {
    return added_mass_;
  }

  bool Body::has_node_set(const std::string &set) const
  {
    return mesh_->node_sets.count(mesh_->find_spelling(set)) != 0;
  }

  const std::vector<unsigned int> &Body::node_set(const std::string &set) const
  {
    const auto found = mesh_->node_sets.find(mesh_->find_spelling(set));
    if (found != mesh_->node_sets.end())
      return found->second;

    std::vector<std::string> names;
    std::string              list;
    for (const auto &s : mesh_->node_sets)
      {
        names.push_back(s.first);
        list += (list.empty() ? "" : ", ") + s.first;
      }
    throw InputError("body \"" + name_ + "\" has no node set \"" + set + "\"" +
                     did_you_mean(set, names) + " (sets: " + list + ")");
  }

  double Body::driven_turn(const double time) const
  {
    return rate * rate_history.integral(time);
  }

  double Body::mass() const
  {
    return mass_;
  }

  double Body::axial_inertia() const
  {
    // sum m |a x (x - c)|^2, places at time zero in the fixed frame.
    double inertia = 0;
    for (unsigned int i = 0; i < n_nodes(); ++i)
      inertia += node_masses_[i] *
                 axis.direction.cross(placement(node_positions_[i]) - axis.point).squaredNorm();
    return inertia;
  }
} // namespace vfife
