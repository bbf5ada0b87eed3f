// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_parts_h
#define vfife_tests_parts_h

#include <vfife/base/process/mpi_session.h>

#include <initializer_list>

/** The parts of a test, one after the other: what main() does and returns. */
inline int run_parts(const std::initializer_list<void (*)()> parts)
{
  for (const auto part : parts)
    part();
  return 0;
}

/** The same with MPI: parts are handed the ranks, const or not, or nothing. */
template <typename World>
int run_parts(int argc, char **argv, const std::initializer_list<void (*)(World &)> parts)
{
  vfife::MpiSession session(argc, argv);
  for (const auto part : parts)
    part(session.world());
  return 0;
}

inline int run_parts(int argc, char **argv, const std::initializer_list<void (*)()> parts)
{
  const vfife::MpiSession session(argc, argv);
  return run_parts(parts);
}

#endif
