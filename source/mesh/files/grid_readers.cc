// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/shown_text.h>
#include <vfife/mesh/hexahedron_corners.h>

#include "file_mesh.h"
#include "mesh_text.h"
#include "mesh_writers.h"

// Formats without names: VTK's legacy files and AVS' unstructured cell data (UCD). Cells have an
// id, which is that of a region or, of quadrilaterals, of a boundary; 0 is none.
namespace vfife
{
  namespace
  {
    /** Corners of a hexahedron in the order of UCD, which begins with the side y = 0. */
    constexpr unsigned int corner_of_ucd[8] = {0, 1, 5, 4, 2, 3, 7, 6};

    /** Adds hexahedra and faces, and hands them over. */
    class Collector
    {
    public:
      explicit Collector(MeshText &text)
        : text_(text)
      {
      }

      void add_node(const Vector3 &x)
      {
        mesh_.nodes.push_back(x);
      }

      std::size_t n_nodes() const
      {
        return mesh_.nodes.size();
      }

      void add_hexahedron(const std::vector<unsigned int> &nodes,
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

      void add_face(const std::vector<unsigned int> &nodes, const long id)
      {
        if (id <= 0)
          return;
        auto &members = surfaces_["boundary " + std::to_string(id)];
        members.insert(members.end(), nodes.begin(), nodes.end());
      }

      FileMesh finish()
      {
        if (mesh_.elements.empty())
          text_.refuse("there are no hexahedra");
        mesh_.finish({}, surfaces_, regions_);
        return std::move(mesh_);
      }

    private:
      MeshText         &text_;
      FileMesh          mesh_;
      FileMesh::Members surfaces_, regions_;
    };

    /** A cell of a VTK file before its type and id are known. */
    struct VtkCell
    {
      std::vector<unsigned int> nodes;
      long                      type = 0, id = 0;
      unsigned int              line = 0;
    };

    constexpr long vtk_quadrilateral = 9, vtk_hexahedron = 12;

    class VtkReader
    {
    public:
      explicit VtkReader(const std::string &path)
        : text_(path)
        , collector_(text_)
      {
      }

      FileMesh read()
      {
        if (text_.rest_of_line().rfind("# vtk DataFile", 0) != 0)
          text_.refuse("cannot be read as a file of VTK's legacy format: the first line must begin "
                       "with \"# vtk DataFile\"");
        text_.rest_of_line();
        if (text_.rest_of_line() != "ASCII")
          text_.refuse("the third line must be ASCII: binary files are not read");
        text_.expect("DATASET");
        text_.expect("UNSTRUCTURED_GRID");
        text_.expect("POINTS");
        read_points();
        text_.expect("CELLS");
        read_cells();
        text_.expect("CELL_TYPES");
        read_types();
        read_ids();
        for (const VtkCell &cell : cells_)
          if (cell.type == vtk_hexahedron)
            collector_.add_hexahedron(cell.nodes, corner_of_files, cell.id, cell.line);
          else if (cell.type == vtk_quadrilateral)
            collector_.add_face(cell.nodes, cell.id);
        return collector_.finish();
      }

    private:
      void read_points()
      {
        const long n = text_.integer("the number of points");
        text_.next(); // float or double
        for (long i = 0; i < n; ++i)
          collector_.add_node(text_.point());
      }

      /** Number of nodes and the nodes from 0 of each cell. */
      void read_cells()
      {
        const long n = text_.integer("the number of cells");
        text_.integer("the number of all numbers of cells");
        for (long i = 0; i < n; ++i)
          {
            VtkCell    cell;
            const long n_nodes = text_.integer("the number of nodes of a cell", 1);
            cell.line          = text_.line();
            for (long k = 0; k < n_nodes; ++k)
              {
                const long node = text_.integer("a node");
                if (node >= static_cast<long>(collector_.n_nodes()))
                  text_.refuse("there is no node " + std::to_string(node) +
                               " (they are numbered from 0)");
                cell.nodes.push_back(node);
              }
            cells_.push_back(cell);
          }
      }

      /** Points and lines (1 to 4) are passed over. */
      void read_types()
      {
        const long n = text_.integer("the number of cells");
        if (n != static_cast<long>(cells_.size()))
          text_.refuse("the number of types, " + std::to_string(n) +
                       ", is not that of the cells, " + std::to_string(cells_.size()));
        for (VtkCell &cell : cells_)
          {
            cell.type = text_.integer("the type of a cell");
            if (cell.type > 4 && cell.type != vtk_quadrilateral && cell.type != vtk_hexahedron)
              text_.refuse("cells of type " + std::to_string(cell.type) +
                           " are not read: only hexahedra (12) and quadrilaterals (9)");
            const std::size_t n_nodes = cell.type == vtk_hexahedron ? 8 : 4;
            if (cell.type > 4 && cell.nodes.size() != n_nodes)
              text_.refuse("a cell of type " + std::to_string(cell.type) + " has " +
                           std::to_string(n_nodes) + " nodes, the one of line " +
                           std::to_string(cell.line) + " has " + std::to_string(cell.nodes.size()));
          }
      }

      /** CELL_DATA up to an array MaterialID of whole numbers; other arrays of scalars before it
       * are passed over, and all that follows. */
      void read_ids()
      {
        if (text_.next() != "CELL_DATA")
          return;
        if (text_.integer("the number of cells") != static_cast<long>(cells_.size()))
          text_.refuse("CELL_DATA is of another number of cells");
        while (text_.next() == "SCALARS")
          {
            const std::string name = text_.next();
            text_.rest_of_line(); // type and number of components
            text_.expect("LOOKUP_TABLE");
            text_.next();
            for (VtkCell &cell : cells_)
              if (name == "MaterialID")
                cell.id = text_.integer("a material id", -1);
              else
                text_.number("a value");
            if (name == "MaterialID")
              return;
          }
      }

      MeshText             text_;
      Collector            collector_;
      std::vector<VtkCell> cells_;
    };

    /** Numbers of nodes and cells, nodes, cells: number, id, kind, nodes. */
    FileMesh read_ucd_text(MeshText &text)
    {
      Collector  collector(text);
      const long n_nodes = text.integer("the number of nodes", 1);
      const long n_cells = text.integer("the number of cells", 1);
      for (unsigned int i = 0; i < 3; ++i)
        text.integer("a number of data");

      std::map<long, unsigned int> index;
      for (long i = 0; i < n_nodes; ++i)
        {
          const long number = text.integer("the number of a node");
          if (!index.emplace(number, collector.n_nodes()).second)
            text.refuse("there is a second node " + std::to_string(number));
          collector.add_node(text.point());
        }
      const std::map<std::string, unsigned int> kinds = {{"pt", 1},
                                                         {"line", 2},
                                                         {"quad", 4},
                                                         {"hex", 8}};
      for (long i = 0; i < n_cells; ++i)
        {
          text.integer("the number of a cell");
          const long        id   = text.integer("the id of a cell", -1);
          const std::string word = text.next();
          const auto        kind = kinds.find(word);
          if (kind == kinds.end())
            text.refuse("\"" + shown(word) +
                        "\" stands where hex or quad should: other cells "
                        "than hexahedra are not read");
          const unsigned int        line = text.line();
          std::vector<unsigned int> nodes;
          for (unsigned int k = 0; k < kind->second; ++k)
            {
              const long number = text.integer("the number of a node");
              const auto found  = index.find(number);
              if (found == index.end())
                text.refuse("there is no node " + std::to_string(number));
              nodes.push_back(found->second);
            }
          if (word == "hex")
            collector.add_hexahedron(nodes, corner_of_ucd, id, line);
          else if (word == "quad")
            collector.add_face(nodes, id);
        }
      return collector.finish();
    }
  } // namespace

  FileMesh read_vtk(const std::string &path)
  {
    return VtkReader(path).read();
  }

  FileMesh read_ucd(const std::string &path)
  {
    MeshText text(path, '#');
    return read_ucd_text(text);
  }
} // namespace vfife
