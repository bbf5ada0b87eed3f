// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_process_mpi_session_h
#define vfife_base_process_mpi_session_h

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/failure.h>

#include <memory>

namespace vfife
{
  /**
   * MPI and the libraries below deal.II (p4est, PETSc, Zoltan), started and ended with the life of
   * this object. One thread per rank. deal.II's exceptions are told to carry no stack trace and not
   * to abort.
   */
  class MpiSession
  {
  public:
    /** Starts MPI; @p argc and @p argv are those of main(), of which MPI sees the name alone. */
    MpiSession(int &argc, char **&argv);
    ~MpiSession();
    MpiSession(const MpiSession &)            = delete;
    MpiSession &operator=(const MpiSession &) = delete;

    /** All ranks. */
    Communicator &world();

    /**
     * Every rank's last call, with its own failure (exit code 0: none). The lowest failing rank
     * writes "vfife: message" to stderr, and every rank returns the largest exit code. If other
     * ranks do not get here within @p patience [s], they wait for this rank somewhere else and
     * would wait for ever: this rank then writes its message and stops them all by MPI_Abort.
     */
    int finish(const Failure &failure, double patience = 3.);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
  };

  /** Why MPI cannot start, by which it would end the process with a report of its own; exit code 0
   * where nothing is known to be in its way. Open MPI keeps files of a session in the folder for
   * temporary files ($TMPDIR, else $TEMP, $TMP, /tmp), which it makes where it is missing. */
  Failure find_start_obstacle();
} // namespace vfife

#endif
