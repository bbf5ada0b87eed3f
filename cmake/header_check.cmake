# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# Every header must compile alone. Where source/FOLDER/.../NAME.cc includes its own header first, and
# without a precompiled header before it, the library's build has shown that; the others are compiled
# here, each alone and twice (its guard).

file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include
     ${PROJECT_SOURCE_DIR}/include/*.h)
set(alone "")
foreach(header ${headers})
  string(REGEX REPLACE "^vfife/(.*)\\.h$" "\\1" name ${header})
  string(REGEX REPLACE "/.*" "" folder ${name})
  set(source ${PROJECT_SOURCE_DIR}/source/${name}.cc)
  set(first_include "")
  if(EXISTS ${source} AND NOT folder IN_LIST folders_with_meshes)
    file(STRINGS ${source} first_include REGEX "^#include" LIMIT_COUNT 1)
  endif()
  if(NOT first_include STREQUAL "#include <${header}>")
    set(check ${CMAKE_CURRENT_BINARY_DIR}/headers/${name}.cc)
    file(CONFIGURE OUTPUT ${check} CONTENT "#include <@header@>\n#include <@header@>\n" @ONLY)
    list(APPEND alone ${check})
  endif()
endforeach()

# The library's flags, without optimisation of the code that is thrown away.
add_library(header_check OBJECT EXCLUDE_FROM_ALL ${alone})
target_link_libraries(header_check vfife)
target_compile_options(header_check PRIVATE -Wall -Wextra -O0 -U_FORTIFY_SOURCE)
target_include_directories(header_check SYSTEM PRIVATE ${DEAL_II_INCLUDE_DIRS})
