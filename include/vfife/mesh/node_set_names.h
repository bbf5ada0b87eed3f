// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_node_set_names_h
#define vfife_mesh_node_set_names_h

/**
 * Names of the node sets and surfaces that the mesh makers fill: the one place where they are
 * spelt.
 */
namespace vfife
{
  namespace node_set
  {
    constexpr char bore[]          = "bore";
    constexpr char hub[]           = "hub";           ///< all nodes of the hub ring
    constexpr char rim[]           = "rim";           ///< all nodes of the ring under the teeth
    constexpr char rim_underside[] = "rim underside"; ///< held where there is no web
    constexpr char web_front[]     = "web front";     ///< face of the web towards the apex
    constexpr char web_back[]      = "web back";      ///< face of the web towards the back
    constexpr char node_A_front[]  = "node A front";  ///< one a sector, in the order of sectors
    constexpr char node_A_back[]   = "node A back";   ///< one a sector, in the order of sectors
    constexpr char tip[]           = "tip";
    constexpr char toe[]           = "toe";
    constexpr char heel[]          = "heel";
  } // namespace node_set

  namespace surface_name
  {
    constexpr char concave[] = "concave";
    constexpr char convex[]  = "convex";
  } // namespace surface_name
} // namespace vfife

#endif
