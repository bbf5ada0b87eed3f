// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_fillets_pressed_flank_h
#define vfife_study_fillets_pressed_flank_h

#include <vfife/base/parameter_handler.h>
#include <vfife/fem/fem_options.h>
#include <vfife/output/files/figures.h>

#include <string>

namespace vfife
{
  class Communicator;
  class Log;
  class OutputFolder;

  /** Section Linear static/Pressed flank: a tooth of a gear pair under uniform pressure. */
  struct PressedFlankOptions
  {
    double       pressure  = 0; ///< into the tooth [MPa]; 0: no flank is pressed
    bool         on_gear   = false;
    unsigned int tooth     = 0;
    bool         on_convex = false;

    /** Declares the section. */
    void declare(dealii::ParameterHandler &prm);

    bool acts() const
    {
      return pressure > 0;
    }
    /** Throws InputError where the model is no gear pair or has no such tooth. */
    void check(const Model &model) const;
  };

  /** Stresses in the fillets of that tooth, by one sector of the member where it has equal ones,
   * with centrifugal forces as asked for: root_stress.csv, fillet_envelope.csv, root_sections.csv.
   * Returns the figures. Throws as Compliance. Collective. */
  NamedFigures solve_pressed_flank(const Model               &model,
                                   const PressedFlankOptions &options,
                                   const FemOptions          &fem,
                                   bool                       centrifugal,
                                   const OutputFolder        &folder,
                                   Log                       &log);
} // namespace vfife

#endif
