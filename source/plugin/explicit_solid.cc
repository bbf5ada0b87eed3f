// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/motion/nodal_update.h>
#include <vfife/element/hexahedron.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/partition.h>
#include <vfife/plugin/explicit_solid.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/dofs/dof_accessor.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <sstream>
#include <utility>

namespace vfife
{
  namespace
  {
    using ConstraintLines = dealii::AffineConstraints<double>;

    std::string weights_of(const ConstraintLines::ConstraintLine &line)
    {
      std::ostringstream text;
      text << "weights";
      for (const auto &entry : line.entries)
        text << ' ' << entry.second;
      return text.str();
    }
  } // namespace

  ExplicitSolid::ExplicitSolid(const dealii::DoFHandler<3>                          &dof_handler,
                               const dealii::AffineConstraints<double>              &constraints,
                               const std::map<dealii::types::material_id, Material> &materials,
                               const Options                                        &options)
    : dof_handler_(dof_handler)
    , constraints_(constraints)
    , options_(options)
    , communicator_(MPI_COMM_SELF)
    , model_(make_model(materials))
    , operator_(model_, options.frame, options.stiffness, communicator_)
    , n_lines_(constraints.n_constraints())
    , entries_(dof_handler.n_dofs())
    , position_(operator_.make_field())
    , velocity_field_(operator_.make_field())
    , internal_(operator_.make_field())
    , force_(operator_.make_field())
  {
    const std::vector<std::uint32_t> &local_node = operator_.partition().local_node;
    for (std::size_t i = 0; i < dofs_.size(); ++i)
      entries_[dofs_[i]] = 4 * local_node[i / 3] + i % 3;
    for (Vector *vector :
         {&masses_, &ratios_, &displacement_, &velocity_, &old_velocity_, &values_, &work_})
      vector->reinit(dof_handler.n_dofs());
    condense_masses();
    write_positions(displacement_, position_);
  }

  void ExplicitSolid::check_input() const
  {
    const auto *parallel = dynamic_cast<const dealii::parallel::TriangulationBase<3> *>(
      &dof_handler_.get_triangulation());
    AssertThrow(parallel == nullptr,
                ExcRanks(dealii::Utilities::MPI::n_mpi_processes(parallel->get_communicator())));
    const std::string expected = dealii::FESystem<3>(dealii::FE_Q<3>(1), 3).get_name();
    const std::string given    = !dof_handler_.has_active_dofs() ? "none"
                                 : dof_handler_.has_hp_capabilities()
                                   ? "a collection"
                                   : dof_handler_.get_fe().get_name();
    AssertThrow(given == expected, ExcElement(given));
  }

  void ExplicitSolid::check_lines() const
  {
    // Positive weights that sum to s <= 1 or one weight w: (T q)^T m (T q) <= q^T M q, so that the
    // bound of the elements holds. A sum below one is what masters of prescribed values leave.
    for (const auto &line : constraints_.get_lines())
      {
        AssertThrow(constraints_.is_closed(),
                    ExcConstraint(line.index, "constraints after close()", "open ones"));
        double sum = 0, least = std::numeric_limits<double>::infinity();
        for (const auto &entry : line.entries)
          {
            sum += entry.second;
            least = std::min(least, entry.second);
          }
        // 1e-12: round-off of the sum.
        AssertThrow(line.entries.size() < 2 || (least > 0 && sum < 1 + 1e-12),
                    ExcConstraint(line.index,
                                  "one master, or positive weights with a sum of at most 1",
                                  weights_of(line)));
      }
  }

  Model ExplicitSolid::make_model(const std::map<dealii::types::material_id, Material> &materials)
  {
    check_input();
    check_lines();
    // 1. Nodes are the used vertices, elements the active cells, in deal.II's order.
    const dealii::Triangulation<3> &triangulation = dof_handler_.get_triangulation();
    std::uint32_t                   n_nodes       = 0;
    for (const bool used : triangulation.get_used_vertices())
      node_of_vertex_.push_back(used ? n_nodes++ : Partition::absent);
    dofs_.resize(3 * static_cast<std::size_t>(n_nodes));
    places_.reinit(dof_handler_.n_dofs());
    std::vector<CellNodes>    elements;
    std::vector<std::uint8_t> material_of;
    for (const auto &cell : dof_handler_.active_cell_iterators())
      {
        elements.emplace_back();
        for (unsigned int v = 0; v < 8; ++v)
          {
            const std::uint32_t node = node_of_vertex_[cell->vertex_index(v)];
            elements.back()[v]       = node;
            for (unsigned int c = 0; c < 3; ++c)
              {
                const DoFIndex dof  = cell->vertex_dof_index(v, c);
                dofs_[3 * node + c] = dof;
                places_[dof]        = cell->vertex(v)[c];
              }
          }
        const auto found = materials.find(cell->material_id());
        AssertThrow(found != materials.end(), ExcMaterial(cell->material_id()));
        material_of.push_back(std::distance(materials.begin(), found));
      }

    // 2. Hanging vertices at the mean of their masters: the geometry is a field of the space, and
    // linear fields are kept on curved boundaries too.
    ConstraintLines hanging;
    dealii::DoFTools::make_hanging_node_constraints(dof_handler_, hanging);
    hanging.close();
    for (const auto &line : hanging.get_lines())
      AssertThrow(constraints_.is_constrained(line.index),
                  ExcConstraint(line.index, "the line of a hanging node", "none"));
    hanging.distribute(places_);

    // 3. One body with its materials.
    std::vector<Vector3> nodes(n_nodes);
    for (std::size_t i = 0; i < dofs_.size(); ++i)
      nodes[i / 3][i % 3] = places_[dofs_[i]];
    for (std::uint32_t e = 0; e < elements.size(); ++e)
      {
        HexahedronNodes corners;
        for (unsigned int v = 0; v < 8; ++v)
          corners.col(v) = nodes[elements[e][v]];
        const double least = compute_least_jacobian(corners);
        AssertThrow(least > 0, ExcCell(name_of_cell(e), least));
      }
    std::vector<Material> list;
    for (const auto &material : materials)
      list.push_back(material.second);
    auto parts       = std::make_unique<BodyMesh>();
    parts->structure = BodyStructure(1, n_nodes, elements.size());
    parts->structure.set_materials(std::move(material_of));
    Model model;
    model.add_body(
      Body("solid", std::move(list), std::move(nodes), std::move(elements), std::move(parts)));
    return model;
  }

  std::string ExplicitSolid::name_of_cell(const std::uint32_t element) const
  {
    return std::next(dof_handler_.begin_active(), element)->id().to_string();
  }

  void ExplicitSolid::condense_masses()
  {
    // 1. M_j = sum_i m_i |T_ij| sum_k |T_ik|; masters have no line themselves (close()).
    for (std::size_t i = 0; i < dofs_.size(); ++i)
      masses_[dofs_[i]] = model_.bodies[0].node_masses()[i / 3];
    for (const auto &line : constraints_.get_lines())
      if (!line.entries.empty())
        {
          double sum = 0;
          for (const auto &entry : line.entries)
            sum += std::abs(entry.second);
          for (const auto &entry : line.entries)
            masses_[entry.first] += masses_[line.index] * std::abs(entry.second) * sum;
          masses_[line.index] = 0;
        }

    // 2. The kernels know one mass a node, the least of its free DoFs; the forces on its others are
    // scaled. Masses of a node differ where lines of its components do.
    for (std::size_t node = 0; node < dofs_.size() / 3; ++node)
      {
        double mass = std::numeric_limits<double>::infinity();
        for (unsigned int c = 0; c < 3; ++c)
          if (!constraints_.is_constrained(dofs_[3 * node + c]))
            mass = std::min(mass, masses_[dofs_[3 * node + c]]);
        if (std::isinf(mass))
          continue; // the constraints move it alone
        for (unsigned int c = 0; c < 3; ++c)
          if (const DoFIndex dof = dofs_[3 * node + c]; !constraints_.is_constrained(dof))
            ratios_[dof] = mass / masses_[dof];
        const std::uint32_t local = operator_.partition().local_node[node];
        position_.set_number(local, 1. / mass);
        velocity_field_.set_number(local, mass);
      }
  }

  double ExplicitSolid::step_bound() const
  {
    return operator_.limiting_element().stable_step();
  }

  double ExplicitSolid::stable_step() const
  {
    return options_.safety * step_bound();
  }

  void ExplicitSolid::check_size(const std::string &name, const Vector &vector) const
  {
    AssertThrow(vector.size() == entries_.size(),
                ExcSize("Entries of " + name, entries_.size(), vector.size()));
  }

  void ExplicitSolid::write_positions(const Vector &u, NodeField &positions) const
  {
    for (std::size_t i = 0; i < entries_.size(); ++i)
      positions.data()[entries_[i]] = places_[i] + u[i];
  }

  void ExplicitSolid::set_state(const Vector &u, const Vector &v, const double dt)
  {
    check_size("the displacement", u);
    check_size("the velocity", v);
    AssertThrow(dt > 0 && dt <= step_bound(), ExcStep(step_bound(), dt));
    dt_             = dt;
    n_steps_        = 0;
    kinetic_energy_ = strain_energy_ = 0;
    displacement_                    = u;
    velocity_                        = v;
    constraints_.distribute(displacement_);
    for (const auto &line : constraints_.get_lines())
      {
        values_[line.index] = line.inhomogeneity;
        if (line.entries.empty())
          continue; // the velocity of a prescribed value is the caller's
        velocity_[line.index] = 0;
        for (const auto &entry : line.entries)
          velocity_[line.index] += entry.second * velocity_[entry.first];
      }
    write_positions(displacement_, position_);
    for (std::size_t i = 0; i < entries_.size(); ++i)
      velocity_field_.data()[entries_[i]] = velocity_[i];
    knows_forces_ = false;
  }

  void ExplicitSolid::internal_forces(const Vector &u, Vector &f) const
  {
    check_size("the displacement", u);
    check_size("the internal forces", f);
    NodeField positions = operator_.make_field(), forces = operator_.make_field();
    write_positions(u, positions);
    operator_.compute_internal_forces(positions, forces);
    for (std::size_t i = 0; i < entries_.size(); ++i)
      f[i] = forces.data()[entries_[i]];
  }

  void ExplicitSolid::check_cells() const
  {
    if (measures_.least_jacobian > 0 && std::isfinite(measures_.strain_energy))
      return;
    // A place that is not finite has no Jacobian to compare: its cell is looked for.
    const auto   &elements = model_.bodies[0].elements();
    const auto   &local    = operator_.partition().local_node;
    std::uint32_t found    = measures_.least_element;
    double        jacobian = measures_.least_jacobian;
    for (std::uint32_t e = 0; e < elements.size() && !std::isnan(jacobian); ++e)
      for (const std::uint32_t node : elements[e])
        if (!position_.value(local[node]).allFinite())
          {
            found    = e;
            jacobian = not_known;
          }
    AssertThrow(false, ExcUnstable(time(), name_of_cell(found), jacobian));
  }

  void ExplicitSolid::find_forces(const Vector &external_forces)
  {
    check_size("the external forces", external_forces);
    AssertThrow(dt_ > 0, ExcStep(step_bound(), dt_));
    AssertThrow(constraints_.n_constraints() == n_lines_,
                ExcSize("Lines of the constraints", n_lines_, constraints_.n_constraints()));
    if (!knows_forces_)
      {
        measures_     = operator_.measure_internal_forces(position_, internal_);
        knows_forces_ = true;
        check_cells();
      }
    for (std::size_t i = 0; i < entries_.size(); ++i)
      work_[i] = internal_.data()[entries_[i]] + external_forces[i];
    // AffineConstraints::condense() refuses inhomogeneities, which forces have nothing to do with.
    for (const auto &line : constraints_.get_lines())
      for (const auto &entry : line.entries)
        work_[entry.first] += entry.second * work_[line.index];
    // The ratio is zero at DoFs in constraints.
    for (std::size_t i = 0; i < entries_.size(); ++i)
      force_.data()[entries_[i]] = ratios_[i] * work_[i];
  }

  void ExplicitSolid::follow_constraints()
  {
    for (const auto &line : constraints_.get_lines())
      {
        double velocity = (line.inhomogeneity - values_[line.index]) / dt_;
        for (const auto &entry : line.entries)
          velocity += entry.second * velocity_[entry.first];
        velocity_[line.index] = velocity;
        values_[line.index]   = line.inhomogeneity;
      }
    constraints_.distribute(displacement_);
    for (const auto &line : constraints_.get_lines())
      {
        const std::uint32_t entry     = entries_[line.index];
        velocity_field_.data()[entry] = velocity_[line.index];
        position_.data()[entry]       = places_[line.index] + displacement_[line.index];
      }
  }

  void ExplicitSolid::step(const Vector &external_forces)
  {
    find_forces(external_forces);
    // From v- at t - dt/2 to v+ at t + dt/2, positions to t + dt; then the DoFs in constraints.
    BodyDamping damping;
    damping.zeta = options_.damping;
    update_nodes(0,
                 operator_.partition().n_local(),
                 dt_,
                 damping,
                 UpdateAxis(),
                 {operator_.partition().owned.data(),
                  force_.data(),
                  position_.data(),
                  velocity_field_.data(),
                  position_.data(),
                  velocity_field_.data()});
    knows_forces_ = false;
    old_velocity_.swap(velocity_);
    for (std::size_t i = 0; i < entries_.size(); ++i)
      {
        velocity_[i]     = velocity_field_.data()[entries_[i]];
        displacement_[i] = position_.data()[entries_[i]] - places_[i];
      }
    follow_constraints();

    kinetic_energy_ = 0;
    for (std::size_t i = 0; i < entries_.size(); ++i)
      kinetic_energy_ += .5 * masses_[i] * old_velocity_[i] * velocity_[i];
    strain_energy_ = measures_.strain_energy;
    ++n_steps_;
  }
} // namespace vfife
