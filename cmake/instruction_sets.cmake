# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# The kernels of elements and of the nodal update are compiled once per instruction set and chosen at start-up. Only these leaf
# files, which include neither Eigen nor deal.II nor the standard library, get such flags: inline
# functions shared with other files would otherwise need the newest processor everywhere.

# Debug: the compiler would give up tracking the variables of the unrolled loops, and say so.
set(kernel_flags -O3 -fno-math-errno -ffp-contract=fast -fno-var-tracking-assignments)
set(kernel_flags_generic "")
set(kernel_flags_sse2 -march=x86-64)
if(VFIFE_SANITIZE)
  list(REMOVE_ITEM kernel_flags -O3) # minutes for each file
  # The first two do not compile in ten minutes; avx2 checks the same source.
  set(kernel_flags_generic -fno-sanitize=all)
  list(APPEND kernel_flags_sse2 -fno-sanitize=all)
  set(kernel_flags_avx512 -fno-sanitize=all)
endif()
if(VFIFE_COVERAGE)
  list(APPEND kernel_flags -fno-profile-arcs -fno-test-coverage) # counters would take most of a run
endif()
set(kernel_flags_avx2 -march=haswell)
list(APPEND kernel_flags_avx512 -march=skylake-avx512 -mprefer-vector-width=512)

foreach(set generic sse2 avx2 avx512)
  foreach(kernel element/kernels/kernels dynamics/motion/update)
    set(kernel ${PROJECT_SOURCE_DIR}/source/${kernel}_${set}.cc)
    if(NOT set STREQUAL "generic" AND NOT CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
      list(REMOVE_ITEM sources ${kernel})
    elseif(EXISTS ${kernel})
      set_property(SOURCE ${kernel} APPEND PROPERTY COMPILE_OPTIONS ${kernel_flags_${set}}
                                                    ${kernel_flags})
      set_property(SOURCE ${kernel} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
endforeach()
