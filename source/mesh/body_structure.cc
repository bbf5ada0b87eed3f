// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/body_structure.h>

#include <utility>

namespace vfife
{
  BodyStructure::BodyStructure(const unsigned int n_sectors,
                               const unsigned int n_nodes,
                               const unsigned int n_elements)
    : n_sectors_(n_sectors)
    , nodes_per_sector_(n_nodes / n_sectors)
    , elements_per_sector_(n_elements / n_sectors)
  {
    if (n_sectors * nodes_per_sector_ != n_nodes || n_sectors * elements_per_sector_ != n_elements)
      throw InputError("a body of " + std::to_string(n_sectors) + " equal sectors cannot have " +
                       std::to_string(n_nodes) + " nodes and " + std::to_string(n_elements) +
                       " elements");
  }

  double BodyStructure::angle(const unsigned int sector) const
  {
    return 2. * pi * sector / n_sectors_;
  }

  Matrix3 BodyStructure::turn(const int sectors) const
  {
    return rotation_about(Vector3::UnitZ(), sectors * pitch());
  }

  unsigned int BodyStructure::copy(const unsigned int node, const int further) const
  {
    return sector_after(sector_of(node), further) * nodes_per_sector_ + first_copy(node);
  }

  unsigned int BodyStructure::copy_of_element(const unsigned int element, const int further) const
  {
    return sector_after(sector_of_element(element), further) * elements_per_sector_ +
           first_copy_of_element(element);
  }

  unsigned int BodyStructure::sector_after(const unsigned int sector, const int further) const
  {
    const int n = n_sectors_;
    return (static_cast<int>(sector) + further % n + n) % n;
  }

  void BodyStructure::set_materials(std::vector<std::uint8_t> materials)
  {
    materials_ = std::move(materials);
  }
} // namespace vfife
