// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A coarse gear pair (rim held without web) gives the same history on one rank and on two.
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <algorithm>
#include <filesystem>

using namespace vfife;

int main(int argc, char **argv)
{
  MpiSession    session(argc, argv);
  Communicator &world = session.world();
  if (world.is_root())
    {
      std::filesystem::remove_all("one_rank");
      std::filesystem::remove_all("two_ranks");
      std::ofstream("ranks.prm") << quick_pair("set web = none", "set rim rows = 2", "1e-5");
      Communicator alone(MPI_COMM_SELF);
      run_pair("ranks.prm", "one_rank", alone);
    }
  world.barrier();
  run_pair("ranks.prm", "two_ranks", world);
  world.barrier();
  if (!world.is_root())
    return 0;

  auto one = read_columns("one_rank/history.csv"), two = read_columns("two_ranks/history.csv");
  check("same columns and samples",
        one.size() == two.size() && one.size() > 10 && one["time"].size() == 99);
  // Sums over ranks are rounded differently. Some 10^3 relaxation steps, whose damping follows
  // quotients of small differences, make of 1e-16 a start that differs by some 1e-9; contact that
  // opens and closes passes it on without jumps. 11 samples are 200 steps. The energy error is what
  // round-off leaves of large energies: not relative.
  double error = 0, energy_error = 0, kinetic_error = 0;
  for (const auto &[name, values] : one)
    {
      double size = 0;
      for (const double v : values)
        size = largest_of(size, std::abs(v));
      for (std::size_t i = 0; i <= 10; ++i)
        {
          const double difference = std::abs(two.at(name).at(i) - values[i]);
          if (name == "energy error")
            energy_error = largest_of(energy_error, difference);
          else if (name == "relative kinetic energy")
            kinetic_error = largest_of(kinetic_error, difference);
          else if (size > 0)
            error = largest_of(error, difference / size);
        }
    }
  check_below("histories of the first 200 steps over their largest values", error, 1e-8);
  // Round-off 1e-16 of the spin energy, 7e6 mJ, over the energy exchanged in the first samples,
  // some 1e-4 mJ.
  check_below("energy error", energy_error, 1e-5);
  // The same for the difference of the energies of all and of rigid motion.
  check_below("relative kinetic energy over the kinetic one",
              kinetic_error / one["kinetic energy"].front(),
              1e-12);
  check("a loaded pair was compared",
        one["contact force total"].front() > 1000 && one["strain energy"].front() > 0);
}
