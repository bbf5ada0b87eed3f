// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_primitives_stepped_shaft_h
#define vfife_mesh_primitives_stepped_shaft_h

#include <vfife/base/parameter_handler.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/shaft_sections.h>

#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  /**
   * A shaft with discs on it, about the z axis: cylinders and rings, which may lie behind or around
   * each other, webs and rims of the discs among them. Diameters are those of circles with the area
   * of the polygons that the cells make, so that mass and stiffness are those of the round shaft.
   */
  struct SteppedShaftOptions
  {
    std::string  text; ///< "FROM TO OUTER [INNER]" a section, separated by commas [mm]
    unsigned int around           = 24;
    double       axial_cell_size  = 10; ///< largest [mm]
    double       radial_cell_size = 10; ///< largest [mm]

    /** Declares the entries in the section entered. Bound by address. */
    void declare(dealii::ParameterHandler &prm);

    /** Throws InputError (entries under @p section), naming the section of the shaft. */
    void check(const std::string &section) const;

    /** Those of the text, in its order. Throws InputError for words that are no numbers, sizes that
     * contradict each other, and sections that cross. */
    std::vector<ShaftSection> sections(const std::string &section) const;
  };

  /**
   * The mesh. Node sets and surfaces: "outer" (all that faces away from the axis), "section 1",
   * "section 2", ... (what of that belongs to each, if any), "bottom" and "top" (the ends), "bore"
   * (all that faces the axis) where a section is hollow; node set "axis" where one is solid.
   */
  std::unique_ptr<BodyMesh> make_stepped_shaft(const SteppedShaftOptions &options);
} // namespace vfife

#endif
