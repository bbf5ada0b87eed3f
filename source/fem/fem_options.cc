// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/number_list.h>
#include <vfife/fem/fem_options.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    const Choices<LinearSolverKind> linear_solvers = {{"multigrid", LinearSolverKind::multigrid},
                                                      {"direct", LinearSolverKind::direct}};
    const Choices<EigenSolverKind> eigen_solvers = {{"shift-invert", EigenSolverKind::shift_invert},
                                                    {"lobpcg", EigenSolverKind::lobpcg}};

    /** |K x - lambda M x| over lambda with x^T M x = 1, where ModalSolver asks for less than 1e-3
     * of lambda |M x|: |M x| is the root of a node's mass [t], 1e-4 to 1e-2 in bodies of machines.
     */
    constexpr double loosest_of_lobpcg = 1e-5;

    void declare_elements(FemOptions &options, dealii::ParameterHandler &prm)
    {
      declare_choice(
        prm,
        "element",
        options.element,
        fem_element_choices(),
        "Eight nodes with incompatible modes or plain (locks in bending), or degree 2 (27 points) "
        "or 3 (64 points)");
      declare_choice(prm,
                     "geometry",
                     options.geometry,
                     fem_geometry_choices(),
                     "Of quadratic and cubic elements: straight edges between nodes, or edges and "
                     "faces on the true surfaces");
      declare_names(prm,
                    "local refinement",
                    options.local_refinement,
                    "Surfaces or node sets and how often elements that touch them are divided "
                    "into eight (fillets 2, NAME 1); fillets, flanks and all are names too");
      declare_choice(
        prm, "mass", options.mass, mass_choices(), "Mass matrix of vibrations and of spin");
      declare_choice(
        prm,
        "strain measure",
        options.strain,
        strain_measure_choices(),
        "Of bodies in spin: the linear strain in turned axes, as in explicit dynamics, "
        "or Green's, as other programs take");
    }
  } // namespace

  void FemOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_elements(*this, prm);
    declare_choice(prm,
                   "linear solver",
                   linear_solver,
                   linear_solvers,
                   "Conjugate gradients with algebraic multigrid, or factorization");
    declare_number(prm,
                   "linear tolerance",
                   linear_tolerance,
                   "Residual over load at which conjugate gradients stop",
                   Range::between(1e-14, 1e-2));
    declare_choice(
      prm,
      "eigenvalue solver",
      eigen_solver,
      eigen_solvers,
      "Krylov-Schur with shift and factorization, or LOBPCG with multigrid (less memory)");
    declare_number(prm,
                   "eigenvalue tolerance",
                   eigen_tolerance,
                   "Residual at which a mode is taken",
                   Range::between(1e-13, 1e-3));
    declare_integer(prm, "modes", n_modes, "Number of modes of each body", 1, 10000);
    declare_switch(prm,
                   "hold hubs",
                   hold_hubs,
                   "Whether hubs that turn freely are held about the axis, as by a stiff shaft");
    declare_switch(prm,
                   "count modes",
                   count_modes,
                   "Whether a second factorization counts the modes below the highest one found "
                   "(shift-invert only)");
    declare_names(prm, "bodies", bodies, "Bodies whose modes are wanted; none: all");
    declare_number_list(
      prm,
      "speeds",
      speeds,
      "Speeds of the bodies about their own axes at which modes are wanted [rpm]");
    declare_switch(
      prm,
      "coriolis",
      coriolis,
      "Whether Coriolis forces split modes into waves that travel with and against the "
      "speed");
    declare_switch(prm,
                   "cyclic symmetry",
                   cyclic_symmetry,
                   "One sector of each body (tooth by tooth) instead of the whole: modes by nodal "
                   "diameter");
    declare_integer(prm,
                    "largest nodal diameter",
                    largest_diameter,
                    "Up to which diameter, with cyclic symmetry; Fem/modes is then their number "
                    "for each diameter",
                    0,
                    10000);
    declare_integer(prm,
                    "mesh orders",
                    mesh_orders,
                    "Multiples of the mesh frequency whose resonances are looked for",
                    0,
                    1000);
  }

  std::vector<double> FemOptions::rates() const
  {
    return read_number_list(speeds, "rpm");
  }

  void FemOptions::check(const std::string &section) const
  {
    try
      {
        // Parsed already here: a speed that is no quantity is named with its entry.
        std::vector<double> values = rates();
        if (values.empty())
          throw InputError("expected at least one speed (0 for bodies at rest)");
        std::sort(values.begin(), values.end());
        if (std::adjacent_find(values.begin(), values.end()) != values.end())
          throw InputError("duplicate speed");
      }
    catch (const InputError &error)
      {
        throw InputError(section + "/speeds", error.what());
      }
    try
      {
        read_local_refinements(local_refinement);
      }
    catch (const InputError &error)
      {
        throw InputError(section + "/local refinement", error.what());
      }
    if (geometry == FemGeometry::curved && degree_of(element) == 1)
      throw InputError(section + "/geometry",
                       "expected straight, got curved: elements with 8 nodes have straight edges. "
                       "Set " +
                         section + "/element = quadratic or cubic.");
    if (eigen_solver == EigenSolverKind::lobpcg && eigen_tolerance > loosest_of_lobpcg)
      throw InputError(section + "/eigenvalue tolerance",
                       "must be at most 1e-5 with \"lobpcg\", whose residuals are up to thousands "
                       "of times larger for the mode itself");
    if (coriolis && eigen_solver == EigenSolverKind::lobpcg)
      throw InputError(section + "/coriolis", "requires the eigenvalue solver \"shift-invert\"");
  }
} // namespace vfife
