# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# deal.II's triangulation takes 4 s to parse in each file. Folders that see meshes get it precompiled
# (once 15 s); the pure ones (gear, element, contact) and the light ones do not pay for loading it.

set(folders_with_meshes mesh model fem reduced study)

target_precompile_headers(
  vfife
  PRIVATE
  <deal.II/base/parameter_handler.h>
  <deal.II/grid/tria.h>
  <Eigen/Core>
  <Eigen/Geometry>)
# ccache needs the preprocessor to name the precompiled header.
target_compile_options(vfife PRIVATE -fpch-preprocess)

foreach(source ${sources})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/source ${source})
  string(REGEX REPLACE "/.*" "" folder ${folder})
  if(NOT folder IN_LIST folders_with_meshes)
    set_property(SOURCE ${source} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
  endif()
endforeach()
