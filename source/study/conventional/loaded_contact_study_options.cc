// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Entries of the section Loaded contact.
#include <vfife/base/parameters/parameters.h>
#include <vfife/study/conventional/loaded_contact_study.h>

namespace vfife
{
  void LoadedContactOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_integer(
      prm, "positions", positions, "Positions over one tooth mesh; 1: its begin alone", 1, 1000);
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
    declare_integer(prm,
                    "pressure cells",
                    pressure_cells,
                    "Cells of a grid of its own over the width of each contact, on which pressures "
                    "that neither mesh nor penalty makes are found; 10 to 20 are enough, 0: none",
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
