// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_plugin_solid_contact_h
#define vfife_plugin_solid_contact_h

#include <vfife/base/types.h>
#include <vfife/contact/law/contact_options.h>
#include <vfife/dynamics/loads/contact/contact_system.h>
#include <vfife/dynamics/rigid_velocity.h>
#include <vfife/model/model.h>
#include <vfife/model/node_field.h>
#include <vfife/model/partition.h>
#include <vfife/plugin/explicit_solid.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace vfife
{
  /**
   * Contact between a boundary id of one ExplicitSolid and one of another, by the formulation of
   * Contact (doc/theory/contact.md). A pressure that is integrated implicitly depends on all other
   * forces of the step: call add_forces() last. Both solids must outlive the object and have equal
   * steps.
   */
  class SolidContact
  {
  public:
    using Vector = ExplicitSolid::Vector;

    /**
     * ContactSurfaceKind::automatic and true_flank: smooth patches, or flat facets on surfaces with
     * edges. Throws ExplicitSolid::ExcSurface where a boundary id has no face, or a DoF on it has
     * masters (hanging nodes: facets then do not meet along whole sides). Throws InputError where
     * the options contradict each other.
     */
    SolidContact(ExplicitSolid             &slave,
                 dealii::types::boundary_id slave_boundary,
                 ExplicitSolid             &master,
                 dealii::types::boundary_id master_boundary,
                 const ContactOptions      &options);

    SolidContact(const SolidContact &)            = delete;
    SolidContact &operator=(const SolidContact &) = delete;

    /** The largest stable step [s] where the solids allow @p step. */
    double stable_step(double step) const;

    /** Adds the contact forces [N] to all other external forces of the coming step of both solids.
     * Throws ExplicitSolid::ExcSize, ExcSteps, ExcPenetration. */
    void add_forces(Vector &slave_forces, Vector &master_forces);

    /** On the slave, of the last add_forces() [N]. */
    Vector3 force() const
    {
      return force_;
    }

    /** Of the contact springs at the last add_forces() [mJ]. */
    double energy() const;

    DeclException2(ExcSteps,
                   double,
                   double,
                   << "Steps of two solids in contact: expected equal ones, got " << arg1
                   << " s and " << arg2 << " s.");
    DeclException2(
      ExcPenetration, double, std::string, << "Time " << arg1 << " s: " << arg2 << ".");

  private:
    Model make_model(const std::array<dealii::types::boundary_id, 2> &boundaries,
                     const ContactOptions                            &options);
    void  add_body(unsigned int b, dealii::types::boundary_id boundary, Model &model);
    void  add_held_nodes(unsigned int b, Model &model) const;
    static const std::vector<unsigned int> &surface_nodes(const Body &body);
    /** Brings motion and forces of the surface nodes of a body; returns its mean rigid motion. */
    RigidMotion bring(unsigned int b, RigidVelocity &rate);

    std::array<ExplicitSolid *, 2> solids_;
    Model                          model_; ///< both solids, each with its surface
    Partition                      partition_;
    ContactSystem                  contact_;
    NodeField                      positions_, velocities_, forces_, added_;
    Vector3                        force_   = Vector3::Zero();
    double                         dt_      = 0;
    std::uint64_t                  n_calls_ = 0;
  };
} // namespace vfife

#endif
