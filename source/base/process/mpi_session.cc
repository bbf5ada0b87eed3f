// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/mpi_session.h>
#include <vfife/base/process/wall_clock.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <thread>

namespace vfife
{
  struct MpiSession::Implementation
  {
    explicit Implementation(char **&argv)
      : mpi(n_arguments, argv, 1)
      , world(MPI_COMM_WORLD)
    {
      MPI_Comm_dup(MPI_COMM_WORLD, &farewell);
    }

    ~Implementation()
    {
      MPI_Comm_free(&farewell);
    }

    // PETSc, which deal.II starts too, complains of options that it does not know: it sees the
    // program's name alone.
    int n_arguments = 1;
    // Before all that uses it: MPI begins before it and ends after it.
    dealii::Utilities::MPI::MPI_InitFinalize mpi;
    Communicator                             world;
    MPI_Comm
      farewell; ///< a communicator of its own: world may be stuck in the middle of an exchange
  };

  namespace
  {
    /** One write for the whole line: those of several ranks do not mix. */
    void write_message(const Failure &failure)
    {
      std::cout.flush();
      std::cerr << "vfife: " + failure.message + "\n" << std::flush;
    }

    /** Waits until the request is done; false if that takes longer than @p patience seconds. */
    bool wait_for(MPI_Request &request, const double patience)
    {
      const auto start = WallClock::now();
      int        done  = 0;
      while (MPI_Test(&request, &done, MPI_STATUS_IGNORE), done == 0)
        {
          if (seconds_since(start) > patience)
            return false;
          std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
      return true;
    }
  } // namespace

  MpiSession::MpiSession(int &, char **&argv)
    : implementation_(std::make_unique<Implementation>(argv))
  {
    dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();
    dealii::deal_II_exceptions::disable_abort_on_exception();
  }

  MpiSession::~MpiSession() = default;

  Communicator &MpiSession::world()
  {
    return implementation_->world;
  }

  Failure find_start_obstacle()
  {
#ifdef OPEN_MPI
    namespace fs     = std::filesystem;
    std::string name = "/tmp", set_by;
    for (const char *variable : {"TMP", "TEMP", "TMPDIR", "OMPI_MCA_orte_tmpdir_base"})
      if (const char *const value = std::getenv(variable); value != nullptr && *value != '\0')
        {
          name   = value;
          set_by = variable;
        }
    // Tried and not asked for: root has all rights, also where the file system takes nothing.
    std::error_code error;
    fs::path        folder = fs::absolute(name, error).lexically_normal();
    while (!fs::exists(folder, error) && folder.has_parent_path() && folder != folder.parent_path())
      folder = folder.parent_path();
    std::string attempt = (folder / "vfife-XXXXXX").string();
    if (mkdtemp(attempt.data()) == nullptr)
      return {2,
              "MPI cannot write to the folder for temporary files \"" + name + "\" (" +
                std::strerror(errno) + "). Set " + (set_by.empty() ? "TMPDIR" : set_by) +
                " to another folder."};
    fs::remove(attempt, error);
#endif
    return {};
  }

  int MpiSession::finish(const Failure &failure, const double patience)
  {
    // A rank that failed alone must not wait for the others for ever, and they may be stuck in
    // a collective call that it will never join. So all who get here take part in one
    // reduction that does not block: if it ends in time, all are here and agree on the exit
    // code; if not, the failing rank stops them.
    const Communicator &world  = implementation_->world;
    const bool          failed = failure.exit_code != 0;
    if (world.size() == 1)
      {
        if (failed)
          write_message(failure);
        return failure.exit_code;
      }

    // largest exit code, and the lowest failing rank as the largest of size - rank
    std::array<int, 2> mine{
      {failure.exit_code, failed ? static_cast<int>(world.size() - world.rank()) : 0}};
    std::array<int, 2> all{{0, 0}};
    MPI_Request        request;
    MPI_Iallreduce(
      mine.data(), all.data(), 2, MPI_INT, MPI_MAX, implementation_->farewell, &request);

    // a rank without failure waits for a failing one that stops it; of several failing ranks the
    // lowest speaks first
    if (!failed)
      MPI_Wait(&request, MPI_STATUS_IGNORE);
    else if (!wait_for(request, patience + 0.2 * world.rank()))
      {
        write_message(failure);
        MPI_Abort(MPI_COMM_WORLD, failure.exit_code);
      }
    if (failed && all[1] == static_cast<int>(world.size() - world.rank()))
      write_message(failure);
    return all[0];
  }
} // namespace vfife
