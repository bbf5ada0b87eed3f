// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_contact_options_h
#define vfife_study_conventional_loaded_contact_options_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/parameters/parameters.h>

namespace vfife
{
  /** Section Loaded contact. */
  struct LoadedContactOptions
  {
    unsigned int positions     = 8;    ///< over one mesh cycle
    unsigned int first_mesh    = 0;    ///< mesh cycles from the reference position to the first one
    bool         centrifugal   = true; ///< both bodies spin
    unsigned int coupled_modes = 0;    ///< of the pair in contact at the first position
    /** Across a contact, of its own grid; 0: none. The word: where the grid gives the penalty. */
    NumberOrWord pressure_cells = {16, true};
    double pressure_depth = 0; ///< of the layers that are exact there [mm]; 0: of Hertz's width

    void declare(dealii::ParameterHandler &prm);
  };
} // namespace vfife

#endif
