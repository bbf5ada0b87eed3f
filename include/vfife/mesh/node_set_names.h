// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_node_set_names_h
#define vfife_mesh_node_set_names_h

#include <string>
#include <vector>

/**
 * Names of the node sets and surfaces that the mesh makers fill: the one place where they are
 * spelt.
 */
namespace vfife
{
  namespace node_set
  {
    constexpr char bore[]             = "bore"; ///< with a shaft the nodes that both share, inside
    constexpr char hub[]              = "hub";  ///< all nodes of the hub ring
    constexpr char rim[]              = "rim";  ///< all nodes of the ring under the teeth
    constexpr char rim_underside[]    = "rim underside";    ///< held where there is no web
    constexpr char web_front[]        = "web front";        ///< face of the web towards the apex
    constexpr char web_back[]         = "web back";         ///< face of the web towards the back
    constexpr char rim_fillet_front[] = "rim fillet front"; ///< of the web's front face at the rim
    constexpr char rim_fillet_back[]  = "rim fillet back";
    constexpr char hub_fillet_front[] = "hub fillet front"; ///< of the web's front face at the hub
    constexpr char hub_fillet_back[]  = "hub fillet back";
    constexpr char node_A_front[]     = "node A front"; ///< one a sector, in the order of sectors
    constexpr char node_A_back[]      = "node A back";  ///< one a sector, in the order of sectors
    constexpr char tip[]              = "tip";
    constexpr char toe[]              = "toe";
    constexpr char heel[]             = "heel";
    constexpr char root_land[]        = "root land"; ///< between the fillets of a slot

    constexpr char shaft[]         = "shaft";         ///< all nodes of a shaft
    constexpr char shaft_surface[] = "shaft surface"; ///< its free outside
    constexpr char shaft_bore[]    = "shaft bore";    ///< its inside
    constexpr char shaft_ends[]    = "shaft ends";    ///< faces across the axis, shoulders too

    constexpr char concave_fillet[] = "concave fillet"; ///< from root land to start of the flank
    constexpr char convex_fillet[]  = "convex fillet";

    constexpr char concave_chamfer[] = "concave chamfer"; ///< from end of the flank to the tip
    constexpr char convex_chamfer[]  = "convex chamfer";
  } // namespace node_set

  namespace surface_name
  {
    constexpr char concave[] = "concave";
    constexpr char convex[]  = "convex";
  } // namespace surface_name

  /** Sets whose faces have boundary ids in gear bodies: id = place in the list + 1 (0: others, the
   * outside of the hub). The flanks' node sets have the names of their surfaces. */
  inline std::vector<std::string> gear_boundaries()
  {
    return {surface_name::concave,
            surface_name::convex,
            node_set::concave_fillet,
            node_set::convex_fillet,
            node_set::tip,
            node_set::root_land,
            node_set::toe,
            node_set::heel,
            node_set::rim_underside,
            node_set::web_front,
            node_set::web_back,
            node_set::bore,
            node_set::shaft_surface,
            node_set::shaft_bore,
            node_set::shaft_ends,
            node_set::concave_chamfer,
            node_set::convex_chamfer};
  }
} // namespace vfife

#endif
