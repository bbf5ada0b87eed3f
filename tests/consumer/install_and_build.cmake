# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# Installs the build to a prefix of its own, builds the consumer against it and runs it.
set(folder ${build}/tests/consumer)
file(REMOVE_RECURSE ${folder})
foreach(
  step
  "${CMAKE_COMMAND};--install;${build};--prefix;${folder}/prefix"
  "${CMAKE_COMMAND};-S;${source};-B;${folder}/build;-G;${generator};-DCMAKE_BUILD_TYPE=${build_type};-DCMAKE_PREFIX_PATH=${folder}/prefix"
  "${CMAKE_COMMAND};--build;${folder}/build"
  "${folder}/build/consumer")
  execute_process(COMMAND ${step} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
