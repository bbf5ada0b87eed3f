# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# <build>/include/vfife/revision.h, checked at each build and written only when it changes.
# Included by CMakeLists.txt it defines the target; run as a script (cmake -P) it does the work.

if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(revision_header ${PROJECT_BINARY_DIR}/include/vfife/revision.h)
  set(write_revision
      ${CMAKE_COMMAND} -Dsource=${PROJECT_SOURCE_DIR} -Dheader=${revision_header}
      -Dversion=${PROJECT_VERSION} -P ${CMAKE_CURRENT_LIST_FILE})
  execute_process(COMMAND ${write_revision} COMMAND_ERROR_IS_FATAL ANY)
  add_custom_target(vfife_revision COMMAND ${write_revision} BYPRODUCTS ${revision_header}
                                   COMMENT "" VERBATIM)
  return()
endif()

cmake_minimum_required(VERSION 3.22)
set(revision "unknown")
find_program(GIT_PROGRAM git)
# A copy without .git inside another repository must not take that one's revision.
if(GIT_PROGRAM AND EXISTS ${source}/.git)
  execute_process(
    COMMAND ${GIT_PROGRAM} --no-optional-locks -c safe.directory=* describe --always --dirty
            --exclude=* --abbrev=10
    WORKING_DIRECTORY ${source}
    OUTPUT_VARIABLE description
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
    RESULT_VARIABLE failed)
  if(NOT failed)
    set(revision ${description})
  endif()
endif()

file(
  CONFIGURE
  OUTPUT ${header}
  CONTENT
    "// Generated at build time.\n#define VFIFE_VERSION \"@version@\"\n#define VFIFE_REVISION \"@revision@\"\n"
  @ONLY)
