// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_body_h
#define vfife_model_body_h

#include <vfife/base/parameters/parameter_history.h>
#include <vfife/base/types.h>
#include <vfife/element/hexahedron.h>
#include <vfife/element/material.h>
#include <vfife/mesh/body_structure.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  struct BodyMesh;

  /** The line about which a body turns, in the fixed frame. */
  struct Axis
  {
    Vector3 point     = Vector3::Zero();
    Vector3 direction = Vector3::UnitZ();
  };

  /** What tells elements of one shape apart: their stiffness, mass and stresses. */
  struct ElementKind
  {
    unsigned int material;       ///< number among those of the body
    double       initial_strain; ///< see Body::initial_strain()

    bool operator==(const ElementKind &other) const
    {
      return material == other.material && initial_strain == other.initial_strain;
    }
    bool operator!=(const ElementKind &other) const
    {
      return !(*this == other);
    }
  };

  /**
   * A deformable body: mesh, material, lumped masses, and where it is and how it turns at time
   * zero. Nodes and elements are numbered as the mesh's vertices and active cells; first_node
   * shifts them into the model's numbering.
   */
  class Body
  {
  public:
    /** Computes masses. @p materials: those that the mesh's BodyStructure::material_of() counts.
     * Throws InputError naming the first inverted element, and for hanging nodes. */
    Body(std::string name, std::vector<Material> materials, std::unique_ptr<BodyMesh> mesh);
    Body(std::string name, std::unique_ptr<BodyMesh> mesh, const Material &material);
    /** The same of plain @p nodes [mm] and right-handed @p elements: the triangulation of @p parts
     * is empty, its surfaces, node sets and materials name these nodes and elements. */
    Body(std::string                               name,
         std::vector<Material>                     materials,
         std::vector<Vector3>                      nodes,
         std::vector<std::array<std::uint32_t, 8>> elements,
         std::unique_ptr<BodyMesh>                 parts);
    Body(Body &&) noexcept;
    ~Body();

    const std::string &name() const;
    const BodyMesh    &mesh() const;
    /** Sectors, and the material of each element. */
    const BodyStructure &structure() const;

    const std::vector<Material> &materials() const;
    const Material              &material(unsigned int element) const;
    /** Of the elements that have a face among @p nodes. Throws InputError with @p what acts there
     * where these have several materials or there are none. */
    const Material &material_under(const std::vector<unsigned int> &nodes,
                                   const std::string               &what) const;
    /** Largest speed of sound in a bar, sqrt(E/rho) [mm/s]. */
    double sound_speed() const;

    /** Strain of an element without stress, the same in all directions: thermal
     * expansion. */
    double initial_strain(const unsigned int element) const
    {
      return initial_strains_.empty() ? 0. : initial_strains_[element];
    }
    ElementKind kind_of(const unsigned int element) const
    {
      return {structure().material_of(element), initial_strain(element)};
    }
    bool has_initial_strains() const
    {
      return !initial_strains_.empty();
    }
    /** To what there is, so that sources of strain sum; by element, each sum above -1. */
    void add_initial_strains(const std::vector<double> &strains);
    /** Throws InputError with the @p method that does not support them. */
    void require_no_initial_strains(const std::string &method) const;
    /** The element in the shape in which it has no stress, around its middle [mm]. */
    HexahedronNodes stress_free_nodes(unsigned int element) const;

    unsigned int n_nodes() const;
    unsigned int n_elements() const;

    /** Undeformed node positions in the body frame [mm]. */
    const std::vector<Vector3> &node_positions() const;
    /** Row-sum lumped masses [t]. */
    const std::vector<double> &node_masses() const;
    /** Nodes of each element, lexicographic (x fastest). */
    const std::vector<std::array<std::uint32_t, 8>> &elements() const;
    HexahedronNodes                                  element_nodes(unsigned int element) const;

    /** Sorted (or ordered by sector) nodes of a named set; throws InputError with the nearest known
     * name. */
    const std::vector<unsigned int> &node_set(const std::string &set) const;
    bool                             has_node_set(const std::string &set) const;

    /** Adds to the nodes' masses (mass scaling) [t]. */
    void add_masses(const std::vector<double> &masses);
    /** What add_masses() has added [t]. */
    double added_mass() const;

    /** With added mass. */
    double mass() const;
    /** Moment of inertia of the lumped masses about the body's axis of rotation [t mm^2]. */
    double axial_inertia() const;

    /** Angle about the axis by which a drive has turned the body since time zero [rad]. */
    double driven_turn(double time) const;

    RigidMotion placement;      ///< body frame -> fixed frame at time zero
    Axis        axis;           ///< axis of rotation, fixed frame
    bool turns_on_axis = false; ///< held by bearings: rigid motion is a rotation about the axis
    /** On elastic bearings: it turns about the axis in the mean, and beside that its rigid motion
     * has translations and tilts. */
    bool   floats = false;
    double rate   = 0; ///< angular velocity about the axis at time zero [rad/s]
    /** Of what drives the body: angular velocity over that at time zero. */
    ParameterHistory rate_history;
    Vector3          velocity =
      Vector3::Zero(); ///< translation velocity at time zero (bodies without bearings) [mm/s]
    /** Added to the rigid motion at time zero: by node, or empty [mm/s]. */
    std::vector<Vector3> initial_velocity;
    unsigned int         first_node    = 0;
    unsigned int         first_element = 0;

  private:
    void compute_masses();

    std::string                               name_;
    std::unique_ptr<BodyMesh>                 mesh_;
    std::vector<Material>                     materials_;
    std::vector<double>                       initial_strains_; ///< by element; empty: none
    std::vector<Vector3>                      node_positions_;
    std::vector<double>                       node_masses_;
    std::vector<std::array<std::uint32_t, 8>> elements_;
    double                                    mass_ = 0, added_mass_ = 0;
  };
} // namespace vfife

#endif
