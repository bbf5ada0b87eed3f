# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# deal.II's triangulation takes 4 s to parse: the library gets it precompiled (once 15 s), and so do
# the tests of folders that see meshes. The others' programs do not pay for loading it.

set(folders_with_meshes mesh model fem plugin reduced study)

target_precompile_headers(
  vfife
  PRIVATE
  <deal.II/base/parameter_handler.h>
  <deal.II/grid/tria.h>
  <Eigen/Core>
  <Eigen/Geometry>)
# ccache needs the preprocessor to name the precompiled header.
target_compile_options(vfife PRIVATE -fpch-preprocess)
# ccache hashes this text instead of the half gigabyte of the precompiled header (CCACHE_PCH_EXTSUM,
# contrib/prepare.sh): all that the header is made of.
file(
  CONFIGURE
  OUTPUT ${PROJECT_BINARY_DIR}/CMakeFiles/vfife.dir/cmake_pch.hxx.gch.sum
  CONTENT "deal.II ${DEAL_II_PACKAGE_VERSION}, Eigen ${Eigen3_VERSION}, Boost ${Boost_VERSION_STRING}, compiler ${CMAKE_CXX_COMPILER_VERSION}, ${CMAKE_BUILD_TYPE} ${CMAKE_CXX_FLAGS} ${DEAL_II_CXX_FLAGS} ${VFIFE_SANITIZE}")
