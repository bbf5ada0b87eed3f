// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// General models give the same histories on one rank and on several: bars in contact, a turning
// body, a clamped beam.
#include "../history_difference.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <filesystem>

using namespace vfife;

void run_case(const std::string              &name,
              const std::vector<std::string> &overrides,
              const std::string              &folder,
              Communicator                   &communicator)
{
  std::vector<std::string> all = overrides;
  all.emplace_back("Output/verbosity=quiet"); // no progress on the screen
  run_pair(tree_folder() + "/prm/verification/" + name + ".prm", folder, communicator, all);
}

void compare_ranks(const std::string              &name,
                   const std::vector<std::string> &overrides,
                   const histories::Bodies        &bodies,
                   Communicator                   &world,
                   const bool                      tell)
{
  if (world.is_root())
    {
      for (const char *folder : {"_alone", "_shared"})
        std::filesystem::remove_all(name + folder);
      Communicator alone(MPI_COMM_SELF);
      run_case(name, overrides, name + "_alone", alone);
    }
  world.barrier();
  run_case(name, overrides, name + "_shared", world);
  world.barrier();
  if (world.is_root())
    histories::check_same(name,
                          read_result_table(name + "_shared/history.csv"),
                          read_result_table(name + "_alone/history.csv"),
                          bodies,
                          {},
                          tell);
}

int main(int argc, char **argv)
{
  MpiSession    session(argc, argv);
  const bool    tell  = argc > 1;
  Communicator &world = session.world();
  // Largest coordinate, cell, mass.
  compare_ranks("two_bars",
                {"Model/Body flying/elements x=40",
                 "Model/Body resting/elements x=40",
                 "Dynamics/end time=40 us"},
                {200., 2.5, 2 * 100 * 5 * 5 * 7.85e-9},
                world,
                tell);
  // On more than eight ranks some take no part in the contact: that is what is asked there.
  if (world.size() > 8)
    return 0;
  compare_ranks(
    "tumbling", {"Dynamics/end time=0.05 ms"}, {20., 2., 20 * 10 * 4 * 7.85e-9}, world, tell);
  compare_ranks("vibrating_cantilever",
                {"Dynamics/end time=0.3 ms"},
                {100., 2.5, 100 * 10 * 10 * 7.85e-9},
                world,
                tell);
  return 0;
}
