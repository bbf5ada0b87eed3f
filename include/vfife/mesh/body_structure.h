// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_body_structure_h
#define vfife_mesh_body_structure_h

#include <vfife/base/types.h>

#include <cstdint>
#include <vector>

namespace vfife
{
  /**
   * The parts of a body: equal sectors about z of its frame, and materials. Nodes and elements are
   * numbered sector by sector, each sector in the same order. A body without sectors has one.
   */
  class BodyStructure
  {
  public:
    BodyStructure() = default;
    /** Throws InputError where the numbers are no multiples of @p n_sectors. */
    BodyStructure(unsigned int n_sectors, unsigned int n_nodes, unsigned int n_elements);

    unsigned int n_sectors() const
    {
      return n_sectors_;
    }
    /** Angle about z from sector 0 to a @p sector [rad]. */
    double angle(unsigned int sector) const;
    double pitch() const
    {
      return angle(1);
    }
    /** About z by so many sectors, also backwards. */
    Matrix3      turn(int sectors) const;
    unsigned int nodes_per_sector() const
    {
      return nodes_per_sector_;
    }
    unsigned int elements_per_sector() const
    {
      return elements_per_sector_;
    }

    unsigned int sector_of(const unsigned int node) const
    {
      return node / nodes_per_sector_;
    }
    /** The same place in sector 0. */
    unsigned int first_copy(const unsigned int node) const
    {
      return node % nodes_per_sector_;
    }
    /** The same place so many sectors @p further on, also backwards. */
    unsigned int copy(unsigned int node, int further) const;

    unsigned int sector_of_element(const unsigned int element) const
    {
      return element / elements_per_sector_;
    }
    unsigned int first_copy_of_element(const unsigned int element) const
    {
      return element % elements_per_sector_;
    }
    unsigned int copy_of_element(unsigned int element, int further) const;

    /** Number of an element's material among those of its body. */
    unsigned int material_of(const unsigned int element) const
    {
      return materials_.empty() ? 0 : materials_[element];
    }
    /** @p materials: by element; empty: all have the first one. */
    void set_materials(std::vector<std::uint8_t> materials);

  private:
    unsigned int sector_after(unsigned int sector, int further) const;

    unsigned int              n_sectors_ = 1, nodes_per_sector_ = 0, elements_per_sector_ = 0;
    std::vector<std::uint8_t> materials_;
  };
} // namespace vfife

#endif
