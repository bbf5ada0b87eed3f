// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_mumps_instance_h
#define vfife_fem_mumps_instance_h

// MUMPS as the direct solvers use it; seen by their sources only.
#include <vfife/base/process/communicator.h>
#include <vfife/fem/system/fem_matrix.h>

#include <dmumps_c.h>

#include <vector>

namespace vfife
{
  /** One symmetric matrix that MUMPS factorizes. */
  struct MumpsInstance
  {
    DMUMPS_STRUC_C      mumps = {};
    std::vector<int>    rows, columns;
    std::vector<double> values;

    /** Takes the entries and begins; nothing is factorized. */
    explicit MumpsInstance(const FemMatrix &matrix);
    ~MumpsInstance();
    MumpsInstance(const MumpsInstance &)            = delete;
    MumpsInstance &operator=(const MumpsInstance &) = delete;

    /** An entry of ICNTL as the manual numbers it. */
    MUMPS_INT &control(const unsigned int i)
    {
      return mumps.icntl[i - 1];
    }
    /** An entry of INFOG. */
    int info(const unsigned int i) const
    {
      return mumps.infog[i - 1];
    }

    /** MUMPS' jobs: -1 begins, 4 analyses and factorizes, 2 factorizes, 3 solves, -2 ends. */
    void run(const int job)
    {
      mumps.job = job;
      dmumps_c(&mumps);
    }

    /** Analyses and factorizes; entries are given back. Throws NumericalError. */
    void factorize();
    /** Solves for the right sides set. Throws NumericalError. */
    void solve();
  };
} // namespace vfife

#endif
