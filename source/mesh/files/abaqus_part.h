// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_files_abaqus_part_h
#define vfife_mesh_files_abaqus_part_h

#include "abaqus_mesh.h"

#include <string>
#include <vector>

namespace vfife
{
  /** An AbaqusMesh that is read keyword by keyword. */
  class AbaqusPart : public AbaqusMesh
  {
  public:
    explicit AbaqusPart(AbaqusText &text);

    /** Reads the data of a keyword; false where it is none of a mesh. */
    bool read(const AbaqusKeyword &keyword);

    /** What element types say that is not read, for the log. */
    std::vector<std::string> warnings;

  private:
    void read_nodes(const AbaqusKeyword &keyword);
    void read_system();
    void read_elements(const AbaqusKeyword &keyword);
    void read_set(const AbaqusKeyword &keyword, bool of_nodes);
    void read_surface(const AbaqusKeyword &keyword);
    void generate_nodes(const AbaqusKeyword &keyword);
    void generate_elements(const AbaqusKeyword &keyword);
    void copy_elements(const AbaqusKeyword &keyword);

    ElementKind kind_of(const std::string &type, unsigned int line);

    RigidMotion system_; ///< of coordinates
  };
} // namespace vfife

#endif
