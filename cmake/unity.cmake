# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# The sources of a room (a folder below source/) are compiled several at a time: what they include is
# parsed and its templates are instantiated once for all of them. Names in namespaces without a name
# are therefore each used once in a room: the compiler refuses a second one of its unit.

option(VFIFE_UNITY "Compile several sources of a room at a time" ON)
# Few enough that one changed source is compiled again in seconds.
set(sources_at_a_time 6)

if(VFIFE_UNITY)
  set_target_properties(vfife PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # Types in namespaces without a name, used by a source's own types: right, but the compiler takes
  # the source for a header here.
  target_compile_options(vfife PRIVATE -Wno-subobject-linkage)
  foreach(source ${sources})
    file(RELATIVE_PATH room ${PROJECT_SOURCE_DIR}/source ${source})
    get_filename_component(room ${room} DIRECTORY)
    string(REPLACE "/" "_" room "${room}")
    if(NOT DEFINED count_${room})
      set(count_${room} 0)
    endif()
    math(EXPR group "${count_${room}} / ${sources_at_a_time}")
    math(EXPR count_${room} "${count_${room}} + 1")
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${room}_${group})
  endforeach()
  # Alone: what each commit compiles again, and what takes in deal.II's wrappers of Trilinos.
  set_property(SOURCE ${PROJECT_SOURCE_DIR}/source/base/process/revision.cc
                      ${PROJECT_SOURCE_DIR}/source/fem/solvers/multigrid_solver.cc
               PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
endif()
