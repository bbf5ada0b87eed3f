// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A gear body is written to a file by the mesh study, read as a body of a general model, and spins
// freely: conservation of momentum, and the growth that the centrifugal force gives it.
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <filesystem>

using namespace vfife;

int main(int argc, char **argv)
{
  MpiSession    session(argc, argv);
  Communicator &world = session.world();
  run_case(tree_folder() + "/prm/spiral_bevel_mesh.prm",
           "mesh",
           world,
           {"Gear pair/Gear/Mesh/elements along face width=2",
            "Gear pair/Gear/Mesh/elements along profile=2",
            "Gear pair/Pinion/Mesh/elements along face width=2",
            "Export/formats=msh",
            "Export/pair=no",
            "Export/flank points lengthwise=0",
            "Export/flank points profile=0"});
  const std::string file = std::filesystem::absolute("mesh/gear.msh").string();
  run_case(tree_folder() + "/prm/verification/free_gear_spin.prm",
           "spin",
           world,
           {"Model/Body gear/file=" + file,
            "Dynamics/end time=0.1 ms",
            "Output/verbosity=quiet",
            "Output/report=no"});

  auto         h       = read_columns("spin/history.csv");
  const auto  &angular = h["angular momentum z"];
  const double spin    = std::abs(angular.front()); // N mm s = t mm^2/s
  // Sums of some 7000 terms in 10^3 steps; the gear's radius is 130 mm.
  check_below("drift of the angular momentum", angular.back() / angular.front() - 1, 1e-12);
  check_below("angular momentum sideways over that of the spin",
              largest_of(largest_size(h["angular momentum x"]),
                         largest_size(h["angular momentum y"])) /
                spin,
              1e-3);
  check_below("momentum over that of the spin",
              130 *
                largest_of({largest_size(h["momentum x"]),
                            largest_size(h["momentum y"]),
                            largest_size(h["momentum z"])}) /
                spin,
              1e-10);
  check_below("energy error", largest_size(h["energy error"]), 0.01);
  check("strain only from the centrifugal force",
        h["strain energy"].front() < 1e-6 * h["strain energy"].back() &&
          h["strain energy"].back() < 0.01 * h["kinetic energy"].front());
  if (argc > 1)
    std::cout << angular.back() / angular.front() - 1 << ' '
              << largest_size(h["angular momentum x"]) / spin << ' '
              << 130 * largest_size(h["momentum x"]) / spin << ' '
              << 130 * largest_size(h["momentum z"]) / spin << ' '
              << largest_size(h["energy error"]) << ' ' << h["strain energy"].front() << ' '
              << h["strain energy"].back() << ' ' << h["kinetic energy"].front() << std::endl;
  return 0;
}
