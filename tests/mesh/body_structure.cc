// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes and elements of equal sectors, and refusals.
#include "../refusal.h"
#include "../tests.h"

#include <vfife/mesh/body_structure.h>

using namespace vfife;

int main()
{
  // Five sectors of four nodes and three elements.
  const BodyStructure body(5, 20, 15);
  check("counts",
        body.n_sectors() == 5 && body.nodes_per_sector() == 4 && body.elements_per_sector() == 3);
  check("a node of sector 3", body.sector_of(14) == 3 && body.first_copy(14) == 2);
  check("its copies forwards, round the last sector, and backwards",
        body.copy(14, 1) == 18 && body.copy(14, 2) == 2 && body.copy(14, -4) == 18 &&
          body.copy(14, -13) == 2);
  check("elements", body.sector_of_element(14) == 4 && body.first_copy_of_element(14) == 2);
  check("one material where none is given", body.material_of(7) == 0);
  print_refusal([] { BodyStructure(5, 21, 15); });
  print_refusal([] { BodyStructure(5, 20, 14); });
  return 0;
}
