// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_mesh_fields_h
#define vfife_mesh_mesh_fields_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  /** Vector fields on a mesh of deal.II that is distributed to the ranks, under their names; the
   * vectors have the values of all cells that a rank knows. Points to what others own. */
  struct MeshFields
  {
    using Field = dealii::LinearAlgebra::distributed::Vector<double>;

    const dealii::DoFHandler<3>                       &dofs;
    const dealii::Mapping<3>                          &mapping;
    std::vector<std::pair<std::string, const Field *>> fields;
  };
} // namespace vfife

#endif
