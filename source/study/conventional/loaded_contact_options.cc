// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/study/conventional/loaded_contact_options.h>

namespace vfife
{
  void LoadedContactOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_integer(prm,
                    "positions",
                    positions,
                    "Number of positions over one mesh cycle, equally spaced; from 4 on, two more "
                    "at which tooth edges have their largest forces (loaded_teeth.csv only); 1: "
                    "only its beginning",
                    1,
                    1000);
    declare_integer(prm,
                    "first position",
                    first_mesh,
                    "First position, in mesh cycles after the reference position; selects the "
                    "teeth in contact where tooth deviations make teeth unequal",
                    0,
                    100000);
    declare_switch(prm,
                   "centrifugal",
                   centrifugal,
                   "Includes centrifugal forces of both bodies at their speeds");
    declare_integer(prm,
                    "coupled modes",
                    coupled_modes,
                    "Number of natural vibrations of the pair in contact at the reference "
                    "position, from the lowest; 0: none",
                    0,
                    1000);
    declare_number_or_word(
      prm,
      "pressure cells",
      pressure_cells,
      "auto",
      "Elements across the width of each contact on the contact's own grid, which gives load "
      "sharing and pressures; 10 to 20 are sufficient; 0: no pressures, load sharing by the "
      "penalty; auto: 16 with Contact/penalty = auto or Fillets/source = submodel, else 0",
      0,
      64);
    declare_quantity(prm,
                     "pressure depth",
                     pressure_depth,
                     "mm",
                     "Minimum depth of the layer under the flanks whose flexibility is exact on "
                     "that grid; auto: one and a half Hertzian contact widths under the whole load",
                     Range::positive().or_word("auto"));
  }
} // namespace vfife
