// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_plugin_explicit_solid_h
#define vfife_plugin_explicit_solid_h

#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/element/frame_kind.h>
#include <vfife/element/material.h>
#include <vfife/element/stiffness.h>
#include <vfife/model/model.h>
#include <vfife/model/node_field.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/vector.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace vfife
{
  class SolidContact;

  /**
   * Explicit dynamics of an elastic solid by VFIFE on the mesh, the degrees of freedom (DoFs) and
   * the constraints of a deal.II program. Units mm, s, t, N, MPa.
   *
   * Vectors are ordered by the DoFs of an FESystem(FE_Q(1), 3), u = displacement. Constraints
   * u = T q + g are hanging nodes, prescribed values, and lines with one master (symmetry). With
   * internal forces f_int, external forces f and lumped masses m, central differences solve
   *   M dv/dt = T^T (f_int(u) + f) - damping M v,  M_j = sum_i m_i |T_ij| sum_k |T_ik|,
   * the row sums of T^T m T where weights are positive and the square of the weight for one master.
   * Hanging vertices are moved to the mean of their masters. All arguments of the constructor but
   * the options and the materials must outlive the object. MPI is not needed.
   */
  class ExplicitSolid
  {
  public:
    using DoFIndex = dealii::types::global_dof_index;
    using Vector   = dealii::Vector<double>;

    struct Options
    {
      FrameKind     frame     = FrameKind::polar;
      StiffnessKind stiffness = StiffnessKind::incompatible_modes;
      double        damping   = 0;  ///< of the force -damping M v [1/s]
      double        safety    = .9; ///< stable_step() over the bound of the elements [-]
    };

    /** @p materials: by material id. Throws ExcRanks, ExcElement, ExcMaterial, ExcCell,
     * ExcConstraint, ExcSize. */
    ExplicitSolid(const dealii::DoFHandler<3>                          &dof_handler,
                  const dealii::AffineConstraints<double>              &constraints,
                  const std::map<dealii::types::material_id, Material> &materials,
                  const Options                                        &options);

    /** Safety times the step that is stable for the worst free cell [s]. Constraints only increase
     * the stable step. */
    double stable_step() const;

    /** M [t]; zero at DoFs with masters. A DoF of a prescribed value keeps its own mass. */
    const Vector &lumped_masses() const
    {
      return masses_;
    }

    /** [mm] */
    const Vector &displacement() const
    {
      return displacement_;
    }

    /** Half a step before time() [mm/s]. */
    const Vector &velocity() const
    {
      return velocity_;
    }

    /** Begins anew at time 0 with displacements @p u [mm], velocities @p v [mm/s] at -@p dt/2 and
     * equal steps @p dt [s]. DoFs with masters follow these; prescribed values have the caller's
     * velocity until the first step. Throws ExcSize, and ExcStep for a step beyond the bound of the
     * elements. */
    void set_state(const Vector &u, const Vector &v, double dt);

    /** Sets @p f to the internal forces at @p u [N], minus the derivative of the strain energy, of
     * each node by itself: T is not applied. Throws ExcSize. */
    void internal_forces(const Vector &u, Vector &f) const;

    /**
     * One step with @p external_forces [N] at time(). The inhomogeneities of the constraints are
     * those of the end of the step; lines and weights must be those of the constructor. Throws
     * ExcSize, ExcStep before set_state(), ExcUnstable.
     */
    void step(const Vector &external_forces);

    /** [s] */
    double time() const
    {
      return n_steps_ * dt_;
    }

    /** sum M v_- v_+ / 2 where the last step began, at time() - dt [mJ]; 0 before the first step.
     * Without external forces its sum with strain_energy() is constant. */
    double kinetic_energy() const
    {
      return kinetic_energy_;
    }

    /** At the time of kinetic_energy() [mJ]. */
    double strain_energy() const
    {
      return strain_energy_;
    }

    DeclException1(ExcRanks,
                   unsigned int,
                   << "Triangulation: expected a serial one, got a parallel one on " << arg1
                   << " rank(s).");
    DeclException1(ExcElement,
                   std::string,
                   << "Element: expected FESystem<3>[FE_Q<3>(1)^3] with distributed DoFs, got "
                   << arg1 << ".");
    DeclException1(ExcMaterial,
                   dealii::types::material_id,
                   << "Materials: expected one for material id " << arg1 << ", got none.");
    DeclException2(ExcCell,
                   std::string,
                   double,
                   << "Cell " << arg1 << ": expected det J > 0, got " << arg2 << " mm^3.");
    DeclException3(ExcConstraint,
                   DoFIndex,
                   std::string,
                   std::string,
                   << "Constraint of DoF " << arg1 << ": expected " << arg2 << ", got " << arg3
                   << ".");
    DeclException3(ExcSize,
                   std::string,
                   std::size_t,
                   std::size_t,
                   << arg1 << ": expected " << arg2 << ", got " << arg3 << ".");
    DeclException2(ExcStep,
                   double,
                   double,
                   << "Step: expected more than 0 and at most " << arg1 << " s, got " << arg2
                   << " s.");
    DeclException3(ExcUnstable,
                   double,
                   std::string,
                   double,
                   << "Time " << arg1 << " s: expected det J > 0 in cell " << arg2 << ", got "
                   << arg3 << " mm^3. Reduce step or loads.");
    DeclException3(ExcSurface,
                   dealii::types::boundary_id,
                   std::string,
                   std::string,
                   << "Surface of boundary id " << arg1 << ": expected " << arg2 << ", got " << arg3
                   << ".");

  private:
    friend class SolidContact;

    void        check_input() const;
    void        check_lines() const;
    void        check_cells() const;
    void        check_size(const std::string &name, const Vector &vector) const;
    Model       make_model(const std::map<dealii::types::material_id, Material> &materials);
    std::string name_of_cell(std::uint32_t element) const;
    double      step_bound() const;
    void        condense_masses();
    void        write_positions(const Vector &u, NodeField &positions) const;
    /** Sets force_ to T^T (f_int + f), divided by the mass of the DoF over that of its node. */
    void find_forces(const Vector &external_forces);
    /** Velocity and displacement of DoFs in constraints, by those of the others. */
    void follow_constraints();

    const dealii::DoFHandler<3>             &dof_handler_;
    const dealii::AffineConstraints<double> &constraints_;
    Options                                  options_;
    Communicator                             communicator_; ///< of this process alone
    std::vector<std::uint32_t>               node_of_vertex_;
    std::vector<DoFIndex>                    dofs_;   ///< three a node of the body
    Vector                                   places_; ///< undeformed coordinates [mm]
    Model                                    model_;  ///< one body; nodes are the used vertices
    mutable VfifeOperator                    operator_;
    std::size_t                              n_lines_; ///< of the constraints
    std::vector<std::uint32_t> entries_; ///< of each DoF: its place in the data of a NodeField

    Vector    masses_, ratios_; ///< of the mass of the node, the least of its DoFs, over the DoF's
    Vector    displacement_, velocity_, old_velocity_;
    Vector    values_; ///< inhomogeneities at time() [mm]
    Vector    work_;
    NodeField position_, velocity_field_, internal_, force_;
    bool      knows_forces_ = false; ///< internal_ is of the present positions
    ElementMeasures measures_;       ///< of internal_
    double          dt_ = 0, kinetic_energy_ = 0, strain_energy_ = 0;
    std::uint64_t   n_steps_ = 0;
  };
} // namespace vfife

#endif
