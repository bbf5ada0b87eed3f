// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_model_h
#define vfife_model_model_h

#include <vfife/base/parameters/parameter_history.h>
#include <vfife/contact/law/contact_options.h>
#include <vfife/model/body.h>
#include <vfife/model/load.h>
#include <vfife/model/transmission.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vfife
{
  enum class ConstraintKind
  {
    held,                ///< nodes do not move
    prescribed_rotation, ///< nodes follow the body's rate about its axis exactly
    free_rotation,       ///< radial and axial displacement held, each node free tangentially
    rigid_hub,           ///< as before, but all nodes share one rotation
    directions           ///< displacement prescribed in some directions, free in the others
  };

  struct Constraint
  {
    std::string               name;
    ConstraintKind            kind = ConstraintKind::held;
    unsigned int              body = 0;
    std::vector<unsigned int> nodes; ///< of the body

    /** Of `prescribed_rotation`: angle times history instead of the body's rate times time [rad].
     */
    std::optional<double> angle = {};

    /**
     * Of `directions`: along r, theta, z of the body's axis (of each node's own place) instead of
     * x, y, z of the fixed frame; which ones are prescribed; and the displacement [mm; theta: rad]
     * that times the history is.
     */
    bool                cylindrical  = false;
    std::array<bool, 3> prescribed   = {{false, false, false}};
    Vector3             displacement = Vector3::Zero();
    ParameterHistory    history      = {};
  };

  /**
   * A torque about the body's axis, applied as tangential nodal forces of constant traction: value
   * times history, on a linear ramp from zero over ramp_time (0: full from the start).
   */
  struct Torque
  {
    std::string               name;
    unsigned int              body = 0;
    std::vector<unsigned int> nodes;          ///< of the body
    std::vector<double>       areas;          ///< area that belongs to each node [mm^2]
    double                    value     = 0;  ///< [N mm], + about the axis direction
    double                    ramp_time = 0;  ///< [s]
    ParameterHistory          history   = {}; ///< over the value at time zero
  };

  /** Two surfaces that may touch. */
  struct ContactPair
  {
    std::string    side; ///< "drive", "coast", or a user's name
    unsigned int   slave_body = 0;
    std::string    slave_surface;
    unsigned int   master_body = 0;
    std::string    master_surface;
    ContactOptions options;
    /** Contact::set_stiffness(); empty: the penalty is the same everywhere. */
    std::vector<double> stiffness;
    double mean_stiffness = 1; ///< of those points, by the forces on them, over the penalty [-]
    /** Penalty in the mean of the points [N/mm^3]. */
    double mean_penalty() const
    {
      return options.penalty.value * mean_stiffness;
    }
    /** Transmission error of those springs less that of the contact's own grid, at equal positions
     * over one gear mesh from time zero on [rad]; empty: not known. */
    std::vector<double> spring_errors = {};
    /** Facets of slave and master that the contact passes per gear mesh, along the face and along
     * the profile; zeros: not known. */
    std::array<std::array<double, 2>, 2> facets_passed = {};
  };

  /** A node whose displacement and stress are recorded. */
  struct Probe
  {
    std::string  name;
    unsigned int body = 0;
    unsigned int node = 0; ///< of the body
    /** Displacement x - X along x, y, z of the fixed frame, stresses along those of the body,
     * instead of what is left in the turning body along r, theta, z. */
    bool fixed_axes = false;
  };

  /** Everything that is computed with, but for the state: read-only while a solver runs. */
  struct Model
  {
    std::vector<Body>         bodies;
    std::vector<Constraint>   constraints;
    std::vector<Torque>       torques;
    std::vector<Load>         loads;
    std::vector<RigidWall>    walls;
    std::vector<Bearing>      bearings;
    std::vector<Coupling>     couplings;
    Eigen::MatrixXd           housing; ///< BearingSystem::set_housing(); empty: the ground
    std::vector<ContactPair>  contacts;
    std::vector<Probe>        probes;
    std::vector<Transmission> transmissions; ///< gear pairs among the bodies

    /** Appends a body and numbers its nodes and elements; returns its index. */
    unsigned int add_body(Body &&body);
    unsigned int n_nodes() const;
    unsigned int n_elements() const;
    /** Whether a body has a rate at time zero. */
    bool any_body_turns() const;
    /** Whether a body has initial strains. */
    bool has_initial_strains() const;
    /** The gear pair; nullptr: there is none. For what a single pair has: throws InputError where
     * there are several. */
    const Transmission *only_transmission() const;
  };

  /** Whether a face is selected, its @p nodes in any order. */
  bool is_one_of(const SelectedFaces &faces, std::array<unsigned int, 4> nodes);

  /**
   * Area of the mesh's boundary faces that belongs to each of @p nodes [mm^2]: the integral of its
   * shape function over the faces whose four nodes are all in the set, and which are among @p faces
   * where these are given.
   */
  std::vector<double> compute_nodal_areas(const Body                      &body,
                                          const std::vector<unsigned int> &nodes,
                                          const SelectedFaces             &faces = {});
} // namespace vfife

#endif
