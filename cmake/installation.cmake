# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# ninja install, and what find_package(vfife) needs.

include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/vfife)

install(TARGETS vfife EXPORT vfifeTargets)
install(TARGETS vfife_main vfife_study)
install(DIRECTORY include/vfife DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_BINARY_DIR}/include/vfife/revision.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/vfife)
install(
  DIRECTORY source/report/
  DESTINATION ${CMAKE_INSTALL_DATADIR}/vfife/report
  COMPONENT report
  USE_SOURCE_PERMISSIONS
  FILES_MATCHING
  PATTERN *.py
  PATTERN *.html
  PATTERN *.css
  PATTERN __pycache__ EXCLUDE)
install(DIRECTORY prm meshes DESTINATION ${CMAKE_INSTALL_DATADIR}/vfife)
install(EXPORT vfifeTargets NAMESPACE vfife:: DESTINATION ${package_folder})

configure_package_config_file(cmake/vfifeConfig.cmake.in ${PROJECT_BINARY_DIR}/vfifeConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/vfifeConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/vfifeConfig.cmake ${PROJECT_BINARY_DIR}/vfifeConfigVersion.cmake
        DESTINATION ${package_folder})
