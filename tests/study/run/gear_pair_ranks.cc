// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A coarse gear pair (rim held without web) gives the same history on one rank and on two, with
// either integration of the contact, and with errors of manufacture.
#include "../history_difference.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <filesystem>

using namespace vfife;

/** Entries of errors that make teeth unequal. */
constexpr char errors[] = "subsection Gear pair\n subsection Errors\n  subsection Gear\n"
                          "   set radial runout amplitude = 10 um\n   subsection Convex flank\n"
                          "    set pitch amplitude = 5 um\n    set pitch order = 3\n"
                          "    set lengthwise crowning = 5 um\n   end\n  end\n end\nend\n";

void compare_ranks(const std::string &integration,
                   const std::string &more,
                   Communicator      &world,
                   const bool         shows)
{
  if (world.is_root())
    {
      std::filesystem::remove_all("one_rank");
      std::filesystem::remove_all("two_ranks");
      std::ofstream("ranks.prm")
        << quick_pair("set body type = rim only", "set elements through rim = 2", "1e-5")
        << "subsection Contact\n set integration = " << integration << "\nend\n"
        << "subsection Fillets\n set teeth = in contact\nend\n"
        << "subsection Pressure\n set instants = 0, 0.1\n set pressure cells = 6\nend\n"
        << more;
      Communicator alone(MPI_COMM_SELF);
      run_pair("ranks.prm", "one_rank", alone);
    }
  world.barrier();
  run_pair("ranks.prm", "two_ranks", world);
  world.barrier();
  if (!world.is_root())
    return;

  const Table one = read_result_table("one_rank/history.csv"),
              two = read_result_table("two_ranks/history.csv");
  // 11 samples are the first 200 steps. Some 10^3 relaxation steps, whose damping follows
  // quotients of small differences, make of 1e-16 a start that differs by some 1e-9; contact that
  // opens and closes passes it on without jumps. Largest coordinate, least cell, mass of the
  // pair.
  histories::check_same(
    integration + (more.empty() ? "" : ", errors"), two, one, {100., 0.5, 3.5e-3}, {0, 11}, shows);
  // The first sample, for the same reason.
  const Table one_root = read_result_table("one_rank/root_stress.csv"),
              two_root = read_result_table("two_ranks/root_stress.csv");
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < one_root.n_rows() && one_root.numbers("time")[i] == 0; ++i)
    for (const char *stress : {"tension", "compression"})
      {
        const double reference = one_root.numbers(stress)[i];
        largest                = std::max(largest, std::abs(reference));
        raise_to(difference, std::abs(two_root.numbers(stress)[i] - reference));
      }
  check("root stresses at the start", largest > 100 && difference < 1e-6 * largest);
  // After 200 steps: as the histories.
  for (const char *name : {"pressure.csv", "pressure_field.csv"})
    {
      const Table one_grid = read_result_table(std::string("one_rank/") + name),
                  two_grid = read_result_table(std::string("two_ranks/") + name);
      check(std::string(name) + ": as many rows",
            one_grid.n_rows() >= 4 && one_grid.n_rows() == two_grid.n_rows());
      double worst = 0;
      for (const Table::Column &column : one_grid.columns())
        {
          double most = 0, differs = 0;
          for (std::size_t i = 0; i < std::min(one_grid.n_rows(), two_grid.n_rows()); ++i)
            {
              const double here = column.numbers[i], there = two_grid.numbers(column.name)[i];
              raise_to(most, std::abs(here));
              raise_to(differs, std::abs(there - here));
            }
          raise_to(worst, differs / std::max(most, 1e-300));
        }
      if (shows)
        std::cerr << integration << ", " << name << ": ranks differ by " << worst << std::endl;
      check_below(std::string(name) + ": difference", worst, 1e-5);
    }
  check("a loaded pair was compared",
        one.n_rows() >= 80 && one.numbers("contact force total").front() > 1000 &&
          one.numbers("strain energy").front() > 0);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  for (const char *integration : {"explicit", "implicit"})
    compare_ranks(integration, "", session.world(), argc > 1);
  compare_ranks("explicit", errors, session.world(), argc > 1);
  return 0;
}
