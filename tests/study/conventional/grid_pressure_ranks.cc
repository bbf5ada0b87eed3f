// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Pressures on their own grid of a coarse pair on two ranks are those of one.
#include "../../model_sections.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

using namespace vfife;

int main(int argc, char **argv)
{
  MpiSession        session(argc, argv);
  const bool        first = session.world().is_root();
  const std::string file  = "grid_pressure_ranks.prm";
  if (first)
    std::ofstream(file) << quick_pair("set body type = rim only",
                                      "set elements through rim = 2",
                                      "1e-5")
                        << model_text::loaded_contact(2, "set pressure cells = 8\n");
  MPI_Barrier(MPI_COMM_WORLD);
  run_pair(file, "grid_pressure_two", session.world());
  // Each rank by itself too, in a folder of its own.
  Communicator      own(MPI_COMM_SELF);
  const std::string alone = first ? "grid_pressure_one" : "grid_pressure_other";
  run_pair(file, alone, own);
  if (!first)
    return 0;
  for (const std::string name : {"pressure.csv", "pressure_field.csv"})
    {
      const Table one = read_result_table(alone + "/" + name),
                  two = read_result_table("grid_pressure_two/" + name);
      check(name + ": as many rows", one.n_rows() > 0 && one.n_rows() == two.n_rows());
      for (const Table::Column &column : one.columns())
        {
          double worst = 0, largest = 0;
          for (std::size_t i = 0; i < std::min(one.n_rows(), two.n_rows()); ++i)
            {
              const double here = column.numbers[i], there = two.numbers(column.name)[i];
              raise_to(worst, std::abs(there - here));
              raise_to(largest, std::abs(here));
            }
          // The direct solver's sums have another order: the forces' iteration ends at 1e-8.
          check(name + ": " + column.name, worst <= 1e-6 * largest);
        }
    }
  return 0;
}
