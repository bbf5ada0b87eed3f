// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/shown_text.h>
#include <vfife/mesh/hexahedron_corners.h>

#include "file_mesh.h"

#include <deal.II/grid/grid_tools.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace vfife
{
  namespace
  {
    /** A face seen from one of its elements. */
    struct ElementFace
    {
      std::array<unsigned int, 4> nodes;    ///< sorted
      unsigned int                opposite; ///< the node opposite to the first one of these
      unsigned int                element;

      bool operator<(const ElementFace &other) const
      {
        return std::tie(nodes, element) < std::tie(other.nodes, other.element);
      }
    };

    std::vector<ElementFace> collect_faces(const std::vector<CellNodes> &elements)
    {
      std::vector<ElementFace> faces;
      faces.reserve(6 * elements.size());
      for (unsigned int e = 0; e < elements.size(); ++e)
        for (const auto &corners : outward_faces)
          {
            ElementFace face;
            for (unsigned int v = 0; v < 4; ++v)
              face.nodes[v] = elements[e][corners[v]];
            const auto first = std::min_element(face.nodes.begin(), face.nodes.end());
            face.opposite    = face.nodes[(first - face.nodes.begin() + 2) % 4];
            face.element     = e;
            std::sort(face.nodes.begin(), face.nodes.end());
            faces.push_back(face);
          }
      std::sort(faces.begin(), faces.end());
      return faces;
    }

    std::vector<dealii::Point<3>> points_of(const FileMesh &mesh)
    {
      std::vector<dealii::Point<3>> points;
      points.reserve(mesh.nodes.size());
      for (const Vector3 &x : mesh.nodes)
        points.emplace_back(x[0], x[1], x[2]);
      return points;
    }

    double volume(const std::vector<dealii::Point<3>> &points, const CellNodes &element)
    {
      const std::vector<unsigned int> corners(element.begin(), element.end());
      return dealii::GridTools::cell_measure<3>(points, corners);
    }
    /** Whether the face at place @p i of the sorted list is that of one element only. */
    bool is_boundary(const std::vector<ElementFace> &faces, const std::size_t i)
    {
      return (i == 0 || faces[i - 1].nodes != faces[i].nodes) &&
             (i + 1 == faces.size() || faces[i + 1].nodes != faces[i].nodes);
    }

    std::array<unsigned int, 4> in_order(std::array<unsigned int, 4> nodes)
    {
      std::sort(nodes.begin(), nodes.end());
      return nodes;
    }

    /** Throws unless all are faces of elements. */
    void check_faces(const std::string            &path,
                     const std::vector<CellNodes> &elements,
                     const FileMesh::Surfaces     &surfaces)
    {
      const std::vector<ElementFace> faces = collect_faces(elements);
      const auto is_before = [](const ElementFace &face, const std::array<unsigned int, 4> &nodes) {
        return face.nodes < nodes;
      };
      for (const auto &[name, list] : surfaces)
        for (const FileMesh::Face &face : list)
          {
            const auto nodes = in_order(face.nodes);
            const auto found = std::lower_bound(faces.begin(), faces.end(), nodes, is_before);
            if (found == faces.end() || found->nodes != nodes)
              throw InputError(path + ":" + std::to_string(face.line) + ": a face of surface \"" +
                               shown(name) + "\" is not a face of a hexahedron");
          }
    }

    /** Each face once. */
    void remove_copies(std::vector<FileMesh::Face> &faces)
    {
      FaceSet known;
      faces.erase(std::remove_if(faces.begin(),
                                 faces.end(),
                                 [&known](const FileMesh::Face &face) {
                                   return !known.insert(in_order(face.nodes)).second;
                                 }),
                  faces.end());
    }
  } // namespace

  void
  FileMesh::finish(const std::string &path, Members sets, Surfaces of_surfaces, Members of_elements)
  {
    check_faces(path, elements, of_surfaces);
    // nodes in the order in which elements use them
    const unsigned int        none = -1;
    std::vector<unsigned int> index(nodes.size(), none);
    std::vector<Vector3>      used;
    for (CellNodes &element : elements)
      for (unsigned int &corner : element)
        {
          if (index[corner] == none)
            {
              index[corner] = used.size();
              used.push_back(nodes[corner]);
            }
          corner = index[corner];
        }
    nodes = used;
    // sets and surfaces in the new numbers, without what belongs to no hexahedron
    for (auto &group : sets)
      {
        std::vector<unsigned int> kept;
        for (const unsigned int member : group.second)
          if (index[member] != none)
            kept.push_back(index[member]);
        group.second = kept;
      }
    for (auto &[name, faces] : of_surfaces)
      {
        remove_copies(faces);
        for (Face &face : faces)
          for (unsigned int &node : face.nodes)
            node = index[node];
        if (!name.empty() && !faces.empty())
          surfaces.push_back({name, faces});
      }
    const auto hand_over = [](Members &members, std::vector<Group> &groups) {
      for (auto &group : members)
        {
          std::sort(group.second.begin(), group.second.end());
          group.second.erase(std::unique(group.second.begin(), group.second.end()),
                             group.second.end());
          if (!group.first.empty() && !group.second.empty())
            groups.push_back({group.first, group.second});
        }
    };
    hand_over(sets, node_sets);
    hand_over(of_elements, regions);
  }

  std::string FileMesh::list_regions() const
  {
    std::vector<std::string> words;
    for (const Group &region : regions)
      {
        words.push_back("\"" + shown(region.name) + "\"");
        for (const auto &[number, name] : region_numbers)
          if (name == region.name)
            words.back() += " (" + std::to_string(number) + ")";
      }
    return list_of(words);
  }

  const FileMesh::Group &FileMesh::find_region(const std::string &path,
                                               const std::string &wanted) const
  {
    // A name goes before a number: a region may be called "2".
    const auto find = [this](const std::string &name) {
      return std::find_if(regions.begin(), regions.end(), [&](const Group &region) {
        return names_without_case ? boost::iequals(region.name, name, std::locale::classic())
                                  : region.name == name;
      });
    };
    auto found = find(wanted);
    for (const auto &[number, name] : region_numbers)
      if (found == regions.end() && std::to_string(number) == wanted)
        found = find(name);
    if (found == regions.end())
      {
        std::vector<std::string> names;
        for (const Group &region : regions)
          names.push_back(region.name);
        throw InputError("regions",
                         path + " has no region \"" + wanted + "\"; it has " + list_regions() +
                           did_you_mean(wanted, names));
      }
    return *found;
  }

  FaceSet FileMesh::find_boundary() const
  {
    const std::vector<ElementFace> faces = collect_faces(elements);
    FaceSet                        boundary;
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (is_boundary(faces, i))
        boundary.insert(faces[i].nodes);
    return boundary;
  }

  void FileMesh::keep_regions(const std::string &path, const std::vector<std::string> &wanted)
  {
    // 1. The elements that stay, in their order, and their new numbers.
    constexpr unsigned int    none = -1;
    std::vector<unsigned int> index(elements.size(), none);
    for (const std::string &name : wanted)
      for (const unsigned int element : find_region(path, name).members)
        index[element] = 0;
    unsigned int n = 0;
    for (unsigned int e = 0; e < elements.size(); ++e)
      if (index[e] != none)
        {
          elements[n]      = elements[e];
          element_lines[n] = element_lines[e];
          index[e]         = n++;
        }
    elements.resize(n);
    element_lines.resize(n);

    // 2. The groups with what is left of them: of surfaces the faces of these elements.
    Members  sets, of_elements;
    Surfaces of_surfaces;
    for (const Group &group : node_sets)
      sets[group.name] = group.members;
    FaceSet kept;
    for (const ElementFace &face : collect_faces(elements))
      kept.insert(face.nodes);
    for (const Surface &surface : surfaces)
      for (const Face &face : surface.faces)
        if (kept.count(in_order(face.nodes)) != 0)
          of_surfaces[surface.name].push_back(face);
    for (const Group &group : regions)
      for (const unsigned int element : group.members)
        if (index[element] != none)
          of_elements[group.name].push_back(index[element]);
    node_sets.clear();
    surfaces.clear();
    regions.clear();
    finish(path, sets, of_surfaces, of_elements);
  }

  void turn_inside_out(FileMesh &mesh)
  {
    const auto points = points_of(mesh);
    for (const CellNodes &element : mesh.elements)
      if (!(volume(points, element) < 0.))
        return;
    for (CellNodes &element : mesh.elements)
      std::swap_ranges(element.begin(), element.begin() + 4, element.begin() + 4);
  }

  void check_elements(const std::string &path, const FileMesh &mesh)
  {
    const auto refuse = [&](const unsigned int element, const std::string &message) {
      const unsigned int line = mesh.element_lines[element];
      throw InputError(path + (line == 0 ? "" : ":" + std::to_string(line)) + ": element " +
                       std::to_string(element + 1) + " (in the order of the file) " + message);
    };
    const auto line_of = [&](const unsigned int element) {
      const unsigned int line = mesh.element_lines[element];
      return line == 0 ? "element " + std::to_string(element + 1)
                       : "that of line " + std::to_string(line);
    };
    // Nodes before volumes: with one node twice the volume may still be positive.
    const auto points = points_of(mesh);
    for (unsigned int e = 0; e < mesh.elements.size(); ++e)
      {
        CellNodes nodes = mesh.elements[e];
        std::sort(nodes.begin(), nodes.end());
        if (std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end())
          refuse(e, "has a node twice");
        const double measure = volume(points, mesh.elements[e]);
        if (!std::isfinite(measure))
          refuse(e, "has corners too far away for a volume");
        if (!(measure > 0.))
          refuse(e, "is inverted, or has no volume");
      }
    // Equal elements, and equal faces, are neighbours in sorted lists.
    std::vector<std::pair<CellNodes, unsigned int>> copies;
    for (unsigned int e = 0; e < mesh.elements.size(); ++e)
      {
        copies.emplace_back(mesh.elements[e], e);
        std::sort(copies.back().first.begin(), copies.back().first.end());
      }
    std::sort(copies.begin(), copies.end());
    for (std::size_t i = 1; i < copies.size(); ++i)
      if (copies[i - 1].first == copies[i].first)
        refuse(copies[i].second, "has the same nodes as " + line_of(copies[i - 1].second));
    const std::vector<ElementFace> faces = collect_faces(mesh.elements);
    for (std::size_t i = 1; i < faces.size(); ++i)
      {
        const ElementFace &one = faces[i - 1], &two = faces[i];
        if (one.nodes != two.nodes)
          continue;
        if (i + 1 < faces.size() && faces[i + 1].nodes == two.nodes)
          refuse(faces[i + 1].element,
                 "has a face that two other elements have already, " + line_of(one.element) +
                   " and " + line_of(two.element));
        if (one.opposite != two.opposite)
          refuse(two.element,
                 "shares four nodes with " + line_of(one.element) + ", but not the face's edges");
      }
  }
} // namespace vfife
