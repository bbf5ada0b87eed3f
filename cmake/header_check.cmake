# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# Every header must compile alone. The library shows that of none: its sources have a precompiled
# header before them, and others of their unit. Each is compiled here, alone and twice (its guard).

file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include
     ${PROJECT_SOURCE_DIR}/include/*.h)
set(alone "")
foreach(header ${headers})
  string(REGEX REPLACE "^vfife/(.*)\\.h$" "\\1" name ${header})
  set(check ${CMAKE_CURRENT_BINARY_DIR}/headers/${name}.cc)
  file(CONFIGURE OUTPUT ${check} CONTENT "#include <@header@>\n#include <@header@>\n" @ONLY)
  list(APPEND alone ${check})
endforeach()

# The library's flags, without optimisation of the code that is thrown away.
add_library(header_check OBJECT EXCLUDE_FROM_ALL ${alone})
target_link_libraries(header_check vfife)
target_compile_options(header_check PRIVATE -Wall -Wextra -O0 -U_FORTIFY_SOURCE)
target_include_directories(header_check SYSTEM PRIVATE ${DEAL_II_INCLUDE_DIRS})
