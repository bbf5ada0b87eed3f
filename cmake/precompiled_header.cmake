# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# deal.II's triangulation takes 4 s to parse: the library gets it precompiled (once 15 s), and so do
# the tests of folders that see meshes. The others' programs do not pay for loading it.

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
