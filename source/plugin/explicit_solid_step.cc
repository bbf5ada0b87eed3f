// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The steps of an ExplicitSolid.
#include <vfife/dynamics/motion/nodal_update.h>
#include <vfife/plugin/explicit_solid.h>

#include <cmath>

namespace vfife
{
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
