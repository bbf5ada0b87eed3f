// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Entries that contradict their case are refused by name before anything is computed: shipped files
// with one entry changed. The .output file has the messages.
#include "../../parts.h"
#include "../../refusal.h"
#include "../quick_pair.h"

using namespace vfife;

struct Refused
{
  const char              *file;
  std::vector<std::string> overrides;
};

const std::vector<Refused> refused = {
  {"fem/cantilever_modes.prm", {"Fem/speeds="}},
  {"fem/cantilever_modes.prm", {"Fem/local refinement=fillets 99"}},
  {"fem/cantilever_modes.prm",
   {"Fem/coriolis=yes", "Fem/eigenvalue solver=lobpcg", "Fem/eigenvalue tolerance=1e-6"}},
  {"fem/loaded_spiral_bevel_quick.prm", {"Fem/distributed=yes"}},
  {"verification/curved_beam.prm", {"Study/kind=linear static", "Fem/speeds=100 rpm"}},
  {"gear/proposed_17_43.prm", {"Gear pair/Proposal/face width=500 mm"}},
  {"gear/proposed_17_43.prm", {"Gear pair/Proposal/pinion teeth=3"}},
  {"gear/proposed_17_43.prm", {"Gear pair/Proposal/module=0.1 mm"}},
  {"lumped/torsional_pair.prm", {"Lumped/stiffness=-1"}},
  {"waves/predict.prm", {"Waves/nodal diameters=99"}},
  {"waves/predict.prm", {"Waves/nodal diameters=x"}},
  {"reduced/quick_speeds.prm", {"Reduced/lowest speed=5000 rpm", "Reduced/highest speed=100 rpm"}},
  {"paper/quick_webs.prm", {"Sweep/base="}},
  {"paper/quick_webs.prm", {"Sweep/numerical parameters=nothing"}},
  {"spiral_bevel_quick.prm", {"Output/field output interval=-1"}},
  {"spiral_bevel_quick.prm", {"Output/checkpoint interval=-1 s"}}};

void messages(Communicator &world)
{
  for (const Refused &one : refused)
    print_refusal([&] { check_case(tree_folder() + "/prm/" + one.file, world, one.overrides); });
}

int main(int argc, char **argv)
{
  run_parts<Communicator>(argc, argv, {&messages});
  return 0;
}
