// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Entries of the section Loaded contact.
#include <vfife/base/parameters/parameters.h>
#include <vfife/study/conventional/loaded_contact_study.h>

namespace vfife
{
  void LoadedContactOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_integer(
      prm,
      "positions",
      positions,
      "Positions over one tooth mesh, in equal steps; from 4 on two more where edges of teeth have "
      "their largest forces (loaded_teeth.csv alone); 1: its begin alone",
      1,
      1000);
    declare_integer(prm,
                    "first tooth mesh",
                    first_mesh,
                    "Tooth meshes after the reference position at which the positions begin: which "
                    "teeth carry, where errors make them unequal",
                    0,
                    100000);
    declare_switch(prm, "centrifugal", centrifugal, "Whether both bodies spin at their speeds");
    declare_integer(
      prm,
      "coupled modes",
      coupled_modes,
      "Lowest natural vibrations of the pair in contact at the reference position; 0: "
      "none",
      0,
      1000);
    declare_number_or_word(prm,
                           "pressure cells",
                           pressure_cells,
                           "auto",
                           "Cells over the width of each contact on its own grid, by which the "
                           "teeth share the load and have their pressures; 10 to 20 are enough; 0: "
                           "no pressures, and the load is shared by the penalty; auto: 16 with "
                           "Contact/penalty = auto, 0 with a given one",
                           0,
                           64);
    declare_quantity(
      prm,
      "pressure depth",
      pressure_depth,
      "mm",
      "Least depth of the layers under the flanks whose flexibility is exact there; 0: "
      "one and a half widths of Hertz's contact under the whole load",
      Range::not_negative());
  }
} // namespace vfife
