// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_fem_space_options_h
#define vfife_fem_system_fem_space_options_h

#include <vfife/fem/system/element_integrals.h>

#include <map>
#include <string>
#include <vector>

namespace vfife
{
  class Body;
  struct Model;

  /** Where an element's points between its corners lie. */
  enum class FemGeometry
  {
    straight, ///< on straight edges: trilinear between the corners
    curved    ///< on the true surfaces: dealii::MappingQ of the element's degree on the mesh's
              ///< manifolds
  };

  /** "straight", "curved". */
  const Choices<FemGeometry> &fem_geometry_choices();

  /** Elements that touch a surface or a node set, by a corner too, are divided into eight, so many
   * times. */
  struct LocalRefinement
  {
    std::string  around; ///< its name; "fillets" and "flanks" are those of both sides, "all" is all
    unsigned int times;
  };

  /** Reads "NAME TIMES" each, 1 to 5 times. Throws InputError. */
  std::vector<LocalRefinement> read_local_refinements(const std::vector<std::string> &texts);

  /** Whether it divides all elements. */
  bool is_everywhere(const LocalRefinement &refinement);

  /** The nodes of the node sets and surfaces that a refinement names, a list each. */
  std::vector<std::vector<unsigned int>> nodes_of_refinement(const LocalRefinement &refinement,
                                                             const Body            &body);

  /** Throws InputError where no body of the model has the surface or node set. */
  void check_refinements(const Model &model, const std::vector<LocalRefinement> &refinements);

  /** What a FemSpace is made of. */
  struct FemSpaceOptions
  {
    FemElement               element          = FemElement::incompatible_modes;
    FemGeometry              geometry         = FemGeometry::straight;
    std::vector<std::string> local_refinement = {}; ///< read_local_refinements()

    /** Elements of bodies of the model (numbers in the body's part of the space) to divide. */
    using Division = std::map<unsigned int, std::vector<unsigned int>>;
    /** Steps after the local refinement; numbers are those after the step before. None with cyclic
     * symmetry. */
    std::vector<Division> divisions = {};

    /** Whether contact divides facets by the points between nodes (FacetParts). Explicit runs and
     * reduced bodies do not: their facets move as their four nodes. */
    bool divides_facets = true;
  };
} // namespace vfife

#endif
