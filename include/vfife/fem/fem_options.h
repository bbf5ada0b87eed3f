// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_fem_options_h
#define vfife_fem_fem_options_h

#include <vfife/fem/fem_element.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace vfife
{
  enum class LinearSolverKind
  {
    multigrid, ///< conjugate gradients with algebraic multigrid
    direct     ///< MUMPS
  };

  enum class EigenSolverKind
  {
    shift_invert, ///< Krylov-Schur with a direct factorization
    lobpcg        ///< with algebraic multigrid: less memory, for large meshes
  };

  /** Section Fem. */
  struct FemOptions
  {
    FemElement       element          = FemElement::incompatible_modes;
    MassKind         mass             = MassKind::consistent;
    LinearSolverKind linear_solver    = LinearSolverKind::multigrid;
    double           linear_tolerance = 1e-10; ///< residual over load
    EigenSolverKind  eigen_solver     = EigenSolverKind::shift_invert;
    double           eigen_tolerance  = 1e-9;
    unsigned int     n_modes          = 20;
    bool             count_modes      = true; ///< a second factorization counts what lies below

    /** Declares the entries in the section entered. */
    void declare(dealii::ParameterHandler &prm);
  };
} // namespace vfife

#endif
