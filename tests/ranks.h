// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_ranks_h
#define vfife_tests_ranks_h

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>

#include <iostream>

/** The ranks of a test: all together, and each alone. Only the first one prints. */
struct TestRanks
{
  TestRanks(int argc, char **argv)
    : session(argc, argv)
    , world(session.world())
    , alone(MPI_COMM_SELF)
  {
    if (!world.is_root())
      std::cout.setstate(std::ios::failbit);
  }

  vfife::MpiSession          session;
  const vfife::Communicator &world;
  const vfife::Communicator  alone;
};

#endif
