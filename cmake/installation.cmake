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
  PATTERN *.json
  PATTERN *.html
  PATTERN *.css
  PATTERN __pycache__ EXCLUDE)
# Whose words reports explain.
install(
  FILES doc/reference/glossary.md
  DESTINATION ${CMAKE_INSTALL_DATADIR}/vfife/report
  COMPONENT report)
# Python finds the packages beside the report by links: PREFIX/lib/python3/dist-packages, which Debian's Python knows for
# PREFIX = /usr, others by PYTHONPATH.
set(VFIFE_PYTHON_FOLDER lib/python3/dist-packages CACHE STRING "Python's folder, below the prefix")
file(RELATIVE_PATH report_from_python /prefix/${VFIFE_PYTHON_FOLDER} /prefix/${report_folder})
foreach(package vfife vfife_report)
  install(
    CODE "set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${VFIFE_PYTHON_FOLDER}\")
file(MAKE_DIRECTORY \"\${folder}\")
file(CREATE_LINK \"${report_from_python}/${package}\" \"\${folder}/${package}\" SYMBOLIC)"
    COMPONENT report)
endforeach()
if(python_module)
  install(TARGETS ${python_module} LIBRARY DESTINATION ${VFIFE_PYTHON_FOLDER})
endif()
install(
  DIRECTORY prm meshes examples
  DESTINATION ${CMAKE_INSTALL_DATADIR}/vfife
  PATTERN __pycache__ EXCLUDE)
# Pages keep their places to each other, so that their links hold.
install(FILES README.md CHANGELOG.md CONTRIBUTING.md CITATION.cff LICENSE
        DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(
  DIRECTORY doc
  DESTINATION ${CMAKE_INSTALL_DOCDIR}
  PATTERN Doxyfile EXCLUDE
  PATTERN site EXCLUDE)
install(
  FILES LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR}
  RENAME copyright)
install(
  FILES contrib/completion.bash
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  RENAME vfife)
install(EXPORT vfifeTargets NAMESPACE vfife:: DESTINATION ${package_folder})
# The build folder serves as vfife_DIR too.
export(EXPORT vfifeTargets NAMESPACE vfife:: FILE ${PROJECT_BINARY_DIR}/vfifeTargets.cmake)

configure_package_config_file(cmake/vfifeConfig.cmake.in ${PROJECT_BINARY_DIR}/vfifeConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/vfifeConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/vfifeConfig.cmake ${PROJECT_BINARY_DIR}/vfifeConfigVersion.cmake
        DESTINATION ${package_folder})
