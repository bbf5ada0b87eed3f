// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_fem_options_h
#define vfife_fem_fem_options_h

#include <vfife/base/parameter_handler.h>
#include <vfife/element/stiffness.h>
#include <vfife/fem/system/fem_space.h>
#include <vfife/fem/system/finite_strain.h>

#include <string>
#include <vector>

namespace vfife
{
  class Log;
  struct Model;

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
  struct FemOptions : FemSpaceOptions
  {
    bool             chooses_elements = true; ///< element type auto: choose_elements()
    MassKind         mass             = MassKind::consistent;
    StrainMeasure    strain           = StrainMeasure::biot;
    LinearSolverKind linear_solver    = LinearSolverKind::multigrid;
    double           linear_tolerance = 1e-10; ///< residual over load
    EigenSolverKind  eigen_solver     = EigenSolverKind::shift_invert;
    double           eigen_tolerance  = 1e-9;
    unsigned int     n_modes          = 20;
    bool             count_modes      = true; ///< a second factorization counts what lies below

    std::vector<std::string> bodies;            ///< names; empty: all bodies of the model
    std::vector<std::string> speeds    = {"0"}; ///< of the bodies about their axes, with units
    bool                     hold_hubs = false; ///< hubs that turn freely are held instead
    bool                     coriolis  = false;
    bool                     chooses_sectors  = true;  ///< cyclic symmetry auto: choose_sectors()
    bool                     cyclic_symmetry  = false; ///< one sector instead of the whole body
    bool                     lowest_of_body   = false; ///< with one sector: not of each diameter
    bool                     distributed      = false; ///< the mesh is distributed to the ranks
    unsigned int             largest_diameter = 8;     ///< of nodal diameters, with one sector
    unsigned int             mesh_orders      = 3; ///< multiples of the mesh frequency looked at

    /** [rad/s]. */
    std::vector<double> rates() const;

    /** Throws InputError when entries contradict each other, or for a local refinement that is
     * none. */
    void check(const std::string &section) const;

    /** With cyclic symmetry auto: one sector of each body for its lowest modes, where analyses @p
     * can have it. */
    void choose_sectors(bool can, Log &log);

    /** Elements of element type auto: curved quadratic ones where an analysis can @p afford them,
     * else 8-node elements. */
    void choose_elements(bool afford, Log &log);

    /** Declares the entries in the section entered. */
    void declare(dealii::ParameterHandler &prm);
  };

  /** The conventional elements of a run with this stiffness, with the masses of its mass points. */
  FemOptions make_fem_options(StiffnessKind stiffness);

  /** Whether quadratic elements of a gear pair need minutes and a few GB at most: one sector per
   * body is factorized, and the mesh has at most 50,000 elements. */
  bool affords_quadratic_elements(const Model &model);
} // namespace vfife

#endif
