# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# cpack -G DEB in the build folder: one package with programs, library, headers, cases, pages.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME vfife)
set(CPACK_PACKAGE_VENDOR "The vfife authors")
set(CPACK_PACKAGE_CONTACT "The vfife authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY
    "dynamics of high-speed gears by the vector form intrinsic finite element method")
set(CPACK_PACKAGE_DESCRIPTION
    "Explicit dynamics of spiral bevel gear pairs whose bodies are deformable and turn,\nconventional finite elements, reduced and lumped models of the same pair, tooth\ncontact analysis, reports.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
# Folders of a package are readable by all, whatever the umask of who builds it.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
                                                GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Libraries by what the programs are linked with; beside them mpirun, and the report's Python.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/package_tools.cmake)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "openmpi-bin, python3, python3-numpy")
if(python_module)
  # Its module is for one version of Python.
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", ${python_versions}")
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-matplotlib, python3-jinja2, python3-meshio, python3-h5py")
# For programs of one's own with the library (find_package(vfife)).
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
    "libdeal.ii-dev, libeigen3-dev, libboost-program-options-dev, libboost-serialization-dev, nlohmann-json3-dev, cmake, python3-pandas, bash-completion"
)
include(CPack)
