// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Contact/penalty = auto of the coarse reference pair: with the penalties of its points the loaded
// analysis, the explicit run and the reduced pair approach each other as on the contact's own grid,
// also between the positions of the calibration. The penalty 30 E*/m does not. With the penalty of
// quadratic elements the run starts with the transmission error of these.
#include "grid_errors.h"

#include <vfife/base/process/mpi_session.h>

using namespace vfife;

using Curve = std::vector<double>;

/** Transmission errors [arcsec] at 3 positions of a mesh cycle, which are not multiples of an
 * eighth but for the first one. */
Curve analyse(const std::vector<std::string> &entries, Communicator &world)
{
  std::vector<std::string> overrides = {"Loaded contact/positions=3",
                                        "Fem/element type=incompatible modes",
                                        "Fillets/teeth=none",
                                        "Output/report=no"};
  overrides.insert(overrides.end(), entries.begin(), entries.end());
  run_pair(tree_folder() + "/prm/fem/loaded_spiral_bevel_quick.prm",
           "auto_penalty",
           world,
           overrides);
  return read_columns("auto_penalty/loaded_contact.csv")["transmission error"];
}

/** Of the first sample of a history, in which the pair stands as at the start [arcsec]. */
double start_of(const std::string              &file,
                const std::string              &folder,
                const std::vector<std::string> &entries,
                Communicator                   &world)
{
  std::vector<std::string> overrides = {"Dynamics/maximum number of steps=1",
                                        "Dynamics/start=static equilibrium"};
  overrides.insert(overrides.end(), entries.begin(), entries.end());
  run_pair(tree_folder() + "/" + file, folder, world, overrides);
  return read_columns(folder + "/history.csv")["dte"].front();
}

int main(int argc, char **argv)
{
  MpiSession   session(argc, argv);
  Communicator world  = session.world();
  const Curve  grid   = analyse({}, world),
              springs = analyse({"Loaded contact/pressure cells=0"}, world),
              given   = analyse({quick_penalty,
                                 "Loaded contact/pressure cells=0",
                                 "Loaded contact/positions=1"},
                              world);
  check("positions", grid.size() == 3 && springs.size() == 3);
  // At 16 positions at most 0.25 and 0.09 rms; here less.
  check_below("springs of the points less own grid [arcsec]",
              largest_difference(springs, grid),
              .15);
  check("one penalty is elsewhere", largest_difference(given, grid) > 2.);
  // Motions start with the deformation that stands still in space, which changes them by 0.3.
  const std::string own_elements = "Contact/penalty elements=as the run";
  const double      of_run =
    start_of("prm/spiral_bevel_quick.prm", "auto_penalty_run", {own_elements}, world);
  check_close("start of a run less own grid [arcsec]", of_run, grid[0], .5);
  // Residual flexibility stands for all modes above the cut-off in the equilibrium.
  check_close(
    "start of a reduced pair less own grid [arcsec]",
    start_of("prm/reduced/spiral_bevel_quick.prm",
             "auto_penalty_reduced",
             {"Reduced/cutoff frequency=3 kHz", "Reduced/element type=as the run", own_elements},
             world),
    grid[0],
    .5);
  // The penalty of quadratic elements changes the mean alone. Their own grid needs no calibration:
  // no penalty leaves a trace in it (test grid_pressure).
  analyse({"Fem/element type=quadratic",
           "Fem/geometry=curved",
           quick_penalty,
           "Loaded contact/pressure cells=10"},
          world);
  const Curve  quadratic = grid_errors("auto_penalty");
  const double change    = mean_of(quadratic) - mean_of(grid);
  check("as many positions", quadratic.size() == grid.size());
  check("quadratic elements are more compliant", change < -2.);
  check_close("start of a run by default less that by its own elements [arcsec]",
              start_of("prm/spiral_bevel_quick.prm", "auto_penalty_quadratic", {}, world) - of_run,
              change,
              .15);
  return 0;
}
