# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# Python's module _vfife (doc/reference/python.md, Without files), made where Python's headers and pybind11 are.
# It is the only shared object; the library is position independent for it (CMakeLists.txt).

# Debian's Python has the libraries of reports also where another one comes first in PATH.
find_program(REPORT_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(REPORT_PYTHON python3)

set(python_module "")
if(VFIFE_SANITIZE OR NOT REPORT_PYTHON)
  return()
endif()
execute_process(
  COMMAND
    ${REPORT_PYTHON} -c
    "import sys, sysconfig as s; print(s.get_paths()['include'], s.get_config_var('EXT_SUFFIX'), sys.version_info[0], sys.version_info[1], sep=';')"
  OUTPUT_VARIABLE python_facts
  OUTPUT_STRIP_TRAILING_WHITESPACE)
list(GET python_facts 0 python_headers)
list(GET python_facts 1 python_suffix)
find_path(PYBIND11_HEADERS pybind11/pybind11.h)
if(NOT EXISTS ${python_headers}/Python.h OR NOT PYBIND11_HEADERS)
  message(STATUS "Python module _vfife left out: it needs pybind11 and Python's headers "
                 "(Debian: pybind11-dev python3-dev)")
  return()
endif()

set(python_module vfife_python)
add_library(vfife_python MODULE source/python/module.cc)
deal_ii_setup_target(vfife_python)
target_link_libraries(vfife_python vfife)
target_include_directories(vfife_python SYSTEM PRIVATE ${python_headers} ${PYBIND11_HEADERS})
target_compile_options(vfife_python PRIVATE -Wall -Wextra -fvisibility=hidden)
# Nothing of the library is seen from outside.
target_link_options(vfife_python PRIVATE -Wl,--exclude-libs,ALL)
set_target_properties(
  vfife_python
  PROPERTIES PREFIX ""
             OUTPUT_NAME _vfife
             SUFFIX ${python_suffix}
             LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/python)
list(GET python_facts 2 python_major)
list(GET python_facts 3 python_minor)
math(EXPR python_next "${python_minor} + 1")
# For the Debian package: a module is for one version of Python.
set(python_versions
    "python3 (>= ${python_major}.${python_minor}), python3 (<< ${python_major}.${python_next})")
