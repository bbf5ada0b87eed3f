// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Contact/penalty elements = cubic: the start of a run differs from that with quadratic elements by
// as much as loaded analyses of both elements differ.
#include "../few_teeth.h"
#include "grid_errors.h"

#include <vfife/base/process/mpi_session.h>

using namespace vfife;

constexpr char file[] = "cubic_penalty.prm", folder[] = "cubic_penalty";

/** Mean transmission error at rest by the contact's own grid, four positions [arcsec]. */
double analyse(const std::string &elements, Communicator &world)
{
  // No penalty has an effect on the own grid, so none is calibrated.
  run_pair(file,
           folder,
           world,
           {"Study/kind=loaded tooth contact analysis",
            "Loaded contact/positions=4",
            "Fem/element type=" + elements,
            "Fem/geometry=curved",
            "Fem/mass=lumped",
            "Loaded contact/pressure cells=10",
            "Fillets/teeth=none",
            quick_penalty});
  const std::vector<double> errors = grid_errors(folder);
  check("positions", errors.size() == 4);
  return mean_of(errors);
}

/** Transmission error at the start of a run with a penalty of these elements [arcsec]. */
double start_of_run(const std::string &elements, Communicator &world)
{
  run_pair(file,
           folder,
           world,
           {"Contact/penalty=auto",
            "Contact/penalty elements=" + elements,
            "Dynamics/maximum number of steps=1",
            "Fillets/teeth=none"});
  return read_columns(std::string(folder) + "/history.csv").at("dte").front();
}

int main(int argc, char **argv)
{
  MpiSession   session(argc, argv);
  Communicator world = session.world();
  if (world.is_root())
    std::ofstream(file) << few_teeth("set body type = rim only", "")
                        << "subsection Gear pair\n set mesh = coarse\nend\n"
                        << "subsection Operation\n set speed = 20000 rpm\n set torque = 800 N m\n"
                        << " set mesh cycles = 1\nend\n";
  world.barrier();
  const double change = analyse("cubic", world) - analyse("quadratic", world);
  check("cubic elements are more compliant", change < -.3);
  check_close("start of a run with the penalty of cubic less that of quadratic elements [arcsec]",
              start_of_run("cubic", world) - start_of_run("quadratic", world),
              change,
              .05);
  return 0;
}
