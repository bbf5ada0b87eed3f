// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/number_list.h>
#include <vfife/base/process/log.h>
#include <vfife/fem/fem_options.h>
#include <vfife/model/model.h>

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
      std::vector<std::string> words = {"auto"};
      for (const auto &choice : fem_element_choices())
        words.push_back(choice.first);
      declare_choice(
        prm,
        "element type",
        words,
        words.front(),
        [&options](const unsigned int i) {
          options.chooses_elements = i == 0;
          if (i > 0)
            options.element = fem_element_choices()[i - 1].second;
        },
        "Element type: 8 nodes with incompatible modes; 8 nodes with full integration (locks in "
        "bending); quadratic (27 nodes); cubic (64 nodes). auto: quadratic on the exact surfaces "
        "where one sector of each body is factorized (loaded tooth contact analysis without "
        "coupled modes and with at most 50000 elements, modal analysis with cyclic symmetry), "
        "otherwise incompatible modes");
      declare_choice(prm,
                     "geometry",
                     options.geometry,
                     fem_geometry_choices(),
                     "Geometry of quadratic and cubic elements: straight edges, or edges and faces "
                     "on the exact surfaces (element type auto)");
      declare_names(
        prm,
        "local refinement",
        options.local_refinement,
        "Local refinement: surfaces or node sets, each with the number of times that "
        "elements touching it are divided into eight, as \"fillets 2\"; fillets, flanks "
        "and all are predefined names");
      declare_choice(prm,
                     "mass",
                     options.mass,
                     mass_choices(),
                     "Mass matrix of modal analyses and of rotating bodies");
      declare_choice(prm,
                     "strain measure",
                     options.strain,
                     strain_measure_choices(),
                     "Strain measure of rotating bodies. biot: linear strain in corotational axes, "
                     "as in explicit dynamics; green: Green-Lagrange strain, as in most other "
                     "programs");
    }

    void declare_sectors(FemOptions &options, dealii::ParameterHandler &prm)
    {
      declare_choice(
        prm,
        "cyclic symmetry",
        std::vector<std::string>({"auto", "yes", "no"}),
        "auto",
        [&options](const unsigned int i) {
          options.chooses_sectors = i == 0;
          options.cyclic_symmetry = i == 1;
        },
        "Models one sector (tooth) per body and computes the modes by nodal diameter. yes: "
        "Fem/modes is the number of modes per nodal diameter, up to maximum nodal diameter; auto: "
        "one sector where all sectors of each body are equal and held equally, without loads, "
        "springs, bearings and couplings; Fem/modes is the number of modes per body, of as many "
        "nodal diameters as have them; no: the whole body");
      declare_integer(prm,
                      "maximum nodal diameter",
                      options.largest_diameter,
                      "Maximum nodal diameter with cyclic symmetry = yes",
                      0,
                      10000);
    }
  } // namespace

  void FemOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_elements(*this, prm);
    declare_switch(prm,
                   "distributed",
                   distributed,
                   "Distributes the mesh of one body to the ranks (kinds linear static and modal): "
                   "conjugate gradients or LOBPCG without a matrix, with two levels of multigrid, "
                   "whatever solvers are set. Elements: full integration, quadratic, cubic");
    declare_choice(prm,
                   "linear solver",
                   linear_solver,
                   linear_solvers,
                   "Linear solver: conjugate gradients with algebraic multigrid, or direct "
                   "factorization");
    declare_number(prm,
                   "linear tolerance",
                   linear_tolerance,
                   "Relative residual at which conjugate gradients stop",
                   Range::between(1e-14, 1e-2));
    declare_choice(prm,
                   "eigenvalue solver",
                   eigen_solver,
                   eigen_solvers,
                   "Eigenvalue solver: Krylov-Schur with shift and factorization, or LOBPCG with "
                   "multigrid (less memory)");
    declare_number(prm,
                   "eigenvalue tolerance",
                   eigen_tolerance,
                   "Relative residual at which an eigenpair is accepted",
                   Range::between(1e-13, 1e-3));
    declare_integer(prm, "modes", n_modes, "Number of modes per body", 1, 10000);
    declare_switch(prm,
                   "hold hubs",
                   hold_hubs,
                   "Suppresses the free rotation of hubs about the axis, as a stiff shaft does");
    declare_switch(prm,
                   "count modes",
                   count_modes,
                   "Counts the modes below the highest computed one by a second factorization, "
                   "to detect missing modes (shift-invert only)");
    declare_names(prm, "bodies", bodies, "Bodies of the modal analysis; empty: all bodies");
    declare_number_list(prm,
                        "speeds",
                        speeds,
                        "Speeds of the bodies about their own axes, for modes at speed [rpm]");
    declare_switch(prm,
                   "coriolis",
                   coriolis,
                   "Includes Coriolis forces, which split the modes of a rotating body into "
                   "forward and backward waves");
    declare_sectors(*this, prm);
    declare_integer(prm,
                    "mesh harmonics",
                    mesh_orders,
                    "Number of mesh harmonics for which resonances are listed",
                    0,
                    1000);
  }

  std::vector<double> FemOptions::rates() const
  {
    return read_number_list(speeds, "rpm");
  }

  void FemOptions::check(const std::string &section) const
  {
    for_entry(section + "/speeds", [this] {
      // Parsed already here: a speed that is no quantity is named with its entry.
      std::vector<double> values = rates();
      if (values.empty())
        throw InputError("expected at least one speed (0 for bodies at rest)");
      std::sort(values.begin(), values.end());
      if (std::adjacent_find(values.begin(), values.end()) != values.end())
        throw InputError("duplicate speed");
    });
    for_entry(section + "/local refinement", [this] { read_local_refinements(local_refinement); });
    if (geometry == FemGeometry::curved && degree_of(element) == 1)
      throw InputError(section + "/geometry",
                       "expected straight, got curved: elements with 8 nodes have straight edges. "
                       "Set " +
                         section + "/element type = quadratic or cubic.");
    if (eigen_solver == EigenSolverKind::lobpcg && eigen_tolerance > loosest_of_lobpcg)
      throw InputError(section + "/eigenvalue tolerance",
                       "must be at most 1e-5 with \"lobpcg\", whose residuals are up to thousands "
                       "of times larger for the mode itself");
    if (coriolis && eigen_solver == EigenSolverKind::lobpcg)
      throw InputError(section + "/coriolis", "requires the eigenvalue solver \"shift-invert\"");
  }

  void FemOptions::choose_sectors(const bool can, Log &log)
  {
    if (!chooses_sectors)
      return;
    cyclic_symmetry = lowest_of_body = can;
    log.line("Fem/cyclic symmetry = auto: ", can ? "one sector of each body" : "whole bodies");
  }

  void FemOptions::choose_elements(const bool afford, Log &log)
  {
    if (!chooses_elements)
      return;
    element = afford ? FemElement::quadratic : FemElement::incompatible_modes;
    if (afford)
      geometry = FemGeometry::curved;
    log.line("Fem/element type = auto: ",
             afford ? "quadratic elements on the exact surfaces"
                    : "8-node elements with incompatible modes");
  }

  FemOptions make_fem_options(const StiffnessKind stiffness)
  {
    FemOptions options;
    options.element =
      stiffness == StiffnessKind::full ? FemElement::full : FemElement::incompatible_modes;
    options.mass = MassKind::lumped;
    return options;
  }

  bool affords_quadratic_elements(const Model &model)
  {
    constexpr std::size_t most_elements = 50000;
    std::size_t           n             = 0;
    for (const Body &body : model.bodies)
      n += body.n_elements();
    return n <= most_elements;
  }
} // namespace vfife
