// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_half_space_cell_forces_h
#define vfife_contact_half_space_cell_forces_h

#include <vfife/base/types.h>

#include <functional>

namespace vfife
{
  /** Forces of the cells of contacts that carry a load together. */
  struct CellForces
  {
    Eigen::VectorXd forces;         ///< by cell [N]
    Eigen::VectorXd gaps;           ///< under these, zero where a cell carries [mm]
    double          closing    = 0; ///< by which the surfaces are brought together, over the arms
    unsigned int    iterations = 0;
  };

  /**
   * Finds the forces f >= 0 of cells that carry a load together, without adhesion and friction,
   *
   *   h = gaps + flexibility(f) - closing arms >= 0,    f h = 0,    arms . f = load,
   *
   * by conjugate gradients on the cells that carry (Polonsky and Keer 1999), and by sets of these
   * where gradients stagnate.
   * @param flexibility how far forces [N] part the surfaces in the cells [mm], symmetric and
   *                    positive
   * @param gaps        without forces [mm]
   * @param arms        positive: 1 where bodies approach each other [-], of a turn [mm]
   * @param load        positive: [N], of a turn [N mm]
   *
   * Throws InputError for arms or loads that are not positive, NumericalError where the iteration
   * does not end.
   */
  CellForces
  find_cell_forces(const std::function<Eigen::VectorXd(const Eigen::VectorXd &)> &flexibility,
                   const Eigen::VectorXd                                         &gaps,
                   const Eigen::VectorXd                                         &arms,
                   double                                                         load);
} // namespace vfife

#endif
