// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_sector_gear_sector_h
#define vfife_mesh_gear_sector_gear_sector_h

#include <vfife/gear/gear_geometry.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/gear/conical_web.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace vfife
{
  /** Nodes and facets of one flank of a tooth. */
  struct FlankGrid
  {
    FlankSide                 side = FlankSide::concave;
    std::vector<unsigned int> nodes; ///< of the sector
    std::vector<Vector2>      L_h;   ///< coordinates (L, h) of the nodes [mm]

    /** Corners as places in the list of nodes, counter-clockwise seen from outside; the first side
     * runs along the tooth. */
    std::vector<std::array<unsigned int, 4>> facets;
  };

  /** Fillets of a web that have a radius, by the names of their node sets. */
  using WebFillets = std::map<std::string, MeridianArc>;

  /** Material ids of gear bodies. */
  enum class GearRegion : unsigned int
  {
    tooth = 1,
    rim   = 2,
    web   = 3,
    hub   = 4,
    shaft = 5
  };

  /**
   * The template that a gear body consists of: tooth 0 with the half slots beside it and what lies
   * under it. A hexahedron's node is an index of this sector's nodes, or next_sector(index): that
   * node of the following sector. Nodes on the sector's upper side face are the next sector's.
   */
  struct GearSector
  {
    std::vector<Vector3>      nodes; ///< [mm]
    std::vector<CellNodes>    hexahedra;
    std::vector<unsigned int> regions; ///< GearRegion of each hexahedron
    std::map<std::string, std::vector<unsigned int>>
                           node_sets; ///< sorted, by names of node_set_names.h
    std::vector<FlankGrid> flanks;    ///< concave and convex
    WebFillets             web_fillets;

    static constexpr unsigned int next_sector(const unsigned int index)
    {
      return index | next_bit;
    }
    static constexpr bool is_next(const unsigned int node)
    {
      return (node & next_bit) != 0;
    }
    static constexpr unsigned int index_of(const unsigned int node)
    {
      return node & ~next_bit;
    }

  private:
    static constexpr unsigned int next_bit = 1u << 31;
  };
} // namespace vfife

#endif
