// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pair_coupled_modes_h
#define vfife_fem_pair_coupled_modes_h

#include <vfife/base/text/table.h>
#include <vfife/fem/fem_options.h>
#include <vfife/fem/modes/mode_description.h>
#include <vfife/fem/pair/pair_equilibrium.h>

#include <vector>

namespace vfife
{
  /** A natural vibration of a gear pair in contact. */
  struct CoupledMode
  {
    double frequency = 0; ///< [Hz]
    /** Part of the hub's turn under a static torque that is this mode's; all modes together 1. */
    double              share_of_turn = 0;
    double              driven_energy = 0; ///< part of the kinetic energy in the driven body
    ModeDescription     driven;            ///< what the driven body does
    std::vector<double> shape;             ///< real part, of all points, largest 1 mm
  };

  struct CoupledModes
  {
    /** Contact and shapes frozen in axes that turn with the bodies, without Coriolis forces. */
    std::vector<CoupledMode> turning;
    /** Shapes that stand in space with the contact while the material turns through them. */
    std::vector<CoupledMode> standing;
    double stiffness = 0;     ///< torque over the turn of its points, bodies and contact [N mm/rad]
    bool   counted   = false; ///< completeness was checked by a factorization
    unsigned int n_unknowns = 0;
  };

  /**
   * Small vibrations of the assembled pair about a loaded position: both bodies of the compliance's
   * space in their state of spin, joined by the springs of the contact; the driver's hub
   * turns as prescribed or is held by its coupling, the driven hub turns freely; bearings have
   * the tangent @p bearings (PairEquilibriumResult::bearing_tangent; doc/theory/fem.md, Coupled
   * modes). The @p n lowest; always by shift-invert. Throws NumericalError where the eigenvalue
   * solver fails or a motion grows. Collective.
   */
  CoupledModes find_coupled_modes(const Compliance              &compliance,
                                  const FemOptions              &options,
                                  bool                           centrifugal,
                                  const std::vector<ContactTie> &ties,
                                  const Eigen::MatrixXd         &bearings,
                                  unsigned int                   n,
                                  const Communicator            &communicator);

  /** Columns of coupled_modes.csv. */
  Table make_coupled_mode_table();
  void  add_coupled_modes(const CoupledModes &modes, Table &table);
} // namespace vfife

#endif
