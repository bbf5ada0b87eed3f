# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# Read by cpack. Without these programs it would make a package that depends on no library.
if(CPACK_GENERATOR STREQUAL "DEB")
  find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
  find_program(FILE_PROGRAM file)
  if(NOT DPKG_SHLIBDEPS OR NOT FILE_PROGRAM)
    message(FATAL_ERROR "cpack -G DEB needs dpkg-shlibdeps and file (Debian: dpkg-dev file)")
  endif()
endif()
