// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_program_h
#define vfife_study_program_h

namespace vfife
{
  class Communicator;

  /**
   * Everything between start and end of MPI: reads the arguments (the first is the program's name)
   * and prints, checks or runs what they ask for. Throws as run_study() does. Collective.
   */
  void run_program(int argc, const char *const *argv, Communicator &communicator);
} // namespace vfife

#endif
