// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_primitives_primitive_options_h
#define vfife_mesh_primitives_primitive_options_h

#include <vfife/base/parameter_handler.h>
#include <vfife/mesh/body_mesh.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  struct PrimitiveShape;

  /**
   * A primitive body by the name of its shape: block, beam, ring, cylinder, disc or sphere
   * (primitives.h), with the sizes and numbers of cells that this shape has. One table of shapes:
   * its row says which entries there are, their defaults and what makes the mesh.
   */
  class PrimitiveOptions
  {
  public:
    /** Defaults of that shape. Throws InputError, naming the shapes, for an unknown name. */
    explicit PrimitiveOptions(const std::string &shape);

    /** Names of all shapes, in the order of the table. */
    static std::vector<std::string> shapes();

    /** Declares the shape's sizes [mm] and numbers of cells in the current section. Bound by
     * address: the object must stay where it is until the file has been read. */
    void declare(dealii::ParameterHandler &prm);

    /** Throws InputError (entries under @p section) when sizes or counts contradict each other. */
    void check(const std::string &section) const;

    std::array<double, 3>       sizes;  ///< in the order of the shape's entries [mm]
    std::array<unsigned int, 3> counts; ///< in the order of the shape's entries

  private:
    friend std::unique_ptr<BodyMesh> make_primitive(const PrimitiveOptions &options);

    const PrimitiveShape *shape_; ///< row of the table
  };

  /** The mesh, its name being the shape's; named sets and surfaces as in primitives.h. */
  std::unique_ptr<BodyMesh> make_primitive(const PrimitiveOptions &options);
} // namespace vfife

#endif
