// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What the reduction of a pair's bodies costs: reduction_cost FILE.prm [cut-off in Hz] [reach].
#include "../study/gear_model.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/reduced/body_reduction.h>

#include <iostream>
#include <set>

using namespace vfife;

int main(int argc, char **argv)
{
  MpiSession          session(argc, argv);
  const Communicator &world  = session.world();
  const double        cutoff = argc > 2 ? std::stod(argv[2]) : 25000.;
  const unsigned int  reach  = argc > 3 ? std::stoi(argv[3]) : 4;
  const Model         model  = make_gear_model(argv[1], world);
  for (unsigned int b = 0; b < model.bodies.size(); ++b)
    {
      const Body            &body       = model.bodies[b];
      const unsigned int     per_sector = body.structure().nodes_per_sector();
      std::set<unsigned int> touch;
      for (const auto &surface : body.mesh().surfaces)
        for (const unsigned int node : surface.second.nodes)
          if (node < per_sector)
            touch.insert(node);
      const double      start = MPI_Wtime();
      const ReducedBody reduced =
        reduce_body(model,
                    b,
                    {{touch.begin(), touch.end()}, {}, {}, body.rate, 2. * pi * cutoff, reach},
                    world);
      if (world.is_root())
        {
          std::cout << body.name() << ": " << body.mesh().structure.n_sectors() << " sectors of "
                    << per_sector << " nodes, " << touch.size() << " touch, " << reduced.n_unknowns
                    << " unknowns, " << reduced.n_modes() << " modes in "
                    << reduced.harmonics.size() << " harmonics, factors " << reduced.memory
                    << " MB, left " << reduced.residual_left << ", " << MPI_Wtime() - start << " s"
                    << std::endl;
          for (const auto &harmonic : reduced.harmonics)
            std::cout << " " << harmonic.number << ":" << harmonic.n_modes();
          std::cout << std::endl;
        }
    }
}
