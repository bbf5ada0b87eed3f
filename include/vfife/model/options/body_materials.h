// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_options_body_materials_h
#define vfife_model_options_body_materials_h

#include <vfife/base/parameter_handler.h>
#include <vfife/element/material.h>

#include <string>
#include <vector>

namespace vfife
{
  class Body;
  struct BodyMesh;
  class MaterialSections;

  /** Entries `material` and `region materials` of a body, names of sections "Material NAME", and
   * its `temperature`. */
  struct BodyMaterials
  {
    std::string              material = "steel";
    std::vector<std::string> of_regions; ///< "REGION: MATERIAL"; other regions have the material
    /** Formula of x, y, z in the body frame [K], with or without the unit at its end. */
    std::string temperature = "0";

    /** @p regions: those that the second entry may name, for its description. */
    void declare(dealii::ParameterHandler &prm, const std::string &regions);

    /** Throws InputError naming an entry of @p section where a pair is incomplete, or names the
     * @p region_of_body, whose material is the entry `material`, or the temperature depends on
     * time. */
    void check(const std::string &section, const std::string &region_of_body = "") const;

    /** Names of sections, each once: that of the body, then those of regions. */
    std::vector<std::string> names() const;

    /** The materials of names(), in that order. Throws InputError where one has no section. */
    std::vector<Material> find(const MaterialSections &sections, const std::string &section) const;

    /** Gives the elements of @p mesh their numbers among names(). Throws InputError where the mesh
     * has no such region, or none of its elements, or a region has two materials. */
    void assign(BodyMesh &mesh, const std::string &section) const;

    /** Gives the elements of @p body the strain of free thermal expansion at their centres. Throws
     * InputError where the formula is wrong or a strain exceeds the theory of small strains. */
    void give_temperature(Body &body, const std::string &section) const;
  };
} // namespace vfife

#endif
