// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "grid_collector.h"

namespace vfife
{
  GridCollector::GridCollector(const std::string &path, MeshText &text)
    : path_(path)
    , text_(text)
  {
  }

  void GridCollector::add_node(const Vector3 &x)
  {
    mesh_.nodes.push_back(x);
  }

  std::size_t GridCollector::n_nodes() const
  {
    return mesh_.nodes.size();
  }

  void GridCollector::add_hexahedron(const std::vector<unsigned int> &nodes,
                                     const unsigned int (&order)[8],
                                     const long         id,
                                     const unsigned int line)
  {
    CellNodes corners;
    for (unsigned int k = 0; k < 8; ++k)
      corners[order[k]] = nodes[k];
    const std::string region = "region " + std::to_string(id);
    mesh_.region_numbers[id] = region;
    regions_[region].push_back(mesh_.elements.size());
    mesh_.elements.push_back(corners);
    mesh_.element_lines.push_back(line);
  }

  void GridCollector::add_face(const std::vector<unsigned int> &nodes,
                               const long                       id,
                               const unsigned int               line)
  {
    if (id > 0)
      surfaces_["boundary " + std::to_string(id)].push_back(
        {{{nodes[0], nodes[1], nodes[2], nodes[3]}}, line});
  }

  void GridCollector::add_note(const std::string &note)
  {
    mesh_.notes.push_back(note);
  }

  void GridCollector::add_warning(const std::string &warning)
  {
    mesh_.warnings.push_back(warning);
  }

  FileMesh GridCollector::finish()
  {
    if (mesh_.elements.empty())
      text_.refuse("expected hexahedra, got none");
    mesh_.finish(path_, {}, surfaces_, regions_);
    return std::move(mesh_);
  }
} // namespace vfife
