// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_linear_static_study_h
#define vfife_study_conventional_linear_static_study_h

#include <vfife/base/text/table.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/study/fillets/pressed_flank.h>

#include <string>

namespace vfife
{
  /** Section Linear static. */
  struct LinearStaticOptions
  {
    bool   at_time          = false; ///< loads as their histories say, else in full
    double time             = 0;     ///< [s]
    bool   centrifugal      = true;  ///< on bodies that turn
    bool   spin_softening   = true;
    bool   stress_stiffness = true;

    PressedFlankOptions pressed_flank;

    /** Section Adaptive refinement: steps end when this result changes by less than the tolerance
     * from mesh to mesh; empty: one mesh. */
    std::string  adapted_result;
    double       adapted_tolerance = .01; ///< over the result [-]
    double       marked_part       = .5;  ///< mark_elements()
    unsigned int most_steps        = 6;

    /** Declares the section. */
    void declare(dealii::ParameterHandler &prm);
    /** Throws InputError when entries contradict each other. */
    void check() const;

    StaticLoads loads() const;
  };

  /** adaptive_refinement.csv without rows: a row per mesh; the unit of the value is in the text
   * beside it. */
  Table make_adaptive_table();

  /** reactions.csv without rows. */
  Table make_reaction_table();
} // namespace vfife

#endif
