// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/shown_text.h>
#include <vfife/mesh/hexahedron_corners.h>

#include "grid_collector.h"

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <cmath>

// Unstructured grids of VTK's legacy format in text, up to version 5.1 (VTK file formats; "Changes
// in VTK 9.0"). Keywords have any case of letters.
namespace vfife
{
  namespace
  {
    /** Corners of a voxel (type 11) go by x, then y, then z. */
    constexpr unsigned int corner_of_voxel[8] = {0, 1, 2, 3, 4, 5, 6, 7};

    constexpr long vtk_line_strip = 4, vtk_pixel = 8, vtk_quadrilateral = 9, vtk_voxel = 11,
                   vtk_hexahedron = 12;

    /** A cell before its type and id are known. */
    struct VtkCell
    {
      std::vector<unsigned int> nodes;
      long                      type = 0, id = 0;
      unsigned int              line = 0;
    };

    /** An array of one number a cell. */
    struct CellArray
    {
      std::string               name;
      std::vector<std::string>  words;
      std::vector<unsigned int> lines;
    };

    std::string upper_case(const std::string &word)
    {
      return boost::to_upper_copy(word, std::locale::classic());
    }

    /** Place in the list of what programs call the ids of regions, most likely first; its length
     * for another name. Only letters and digits count. */
    std::size_t rank_of_ids(const std::string &name)
    {
      static const std::vector<std::string> known = {"materialid", "materialids", "material",
                                                     "matid",      "mat",         "regionid",
                                                     "regionids",  "region",      "gmshphysical",
                                                     "physical",   "attribute",   "cellentityids",
                                                     "entityid",   "medittags",   "meditref",
                                                     "celltags",   "subdomain",   "domain",
                                                     "partid",     "part",        "zone"};
      std::string                           bare;
      for (const char letter : boost::to_lower_copy(name, std::locale::classic()))
        if ((letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9'))
          bare += letter;
      return std::find(known.begin(), known.end(), bare) - known.begin();
    }
    const std::size_t no_ids = rank_of_ids("");

    /** "mat%20id" as "mat id". */
    std::string decoded(const std::string &name)
    {
      std::string result;
      for (std::size_t i = 0; i < name.size(); ++i)
        if (name[i] == '%' && i + 2 < name.size() &&
            std::isxdigit(static_cast<unsigned char>(name[i + 1])) != 0 &&
            std::isxdigit(static_cast<unsigned char>(name[i + 2])) != 0)
          {
            result += static_cast<char>(std::stoi(name.substr(i + 1, 2), nullptr, 16));
            i += 2;
          }
        else
          result += name[i];
      return result;
    }

    class VtkReader
    {
    public:
      explicit VtkReader(const std::string &path)
        : text_(path)
        , collector_(path, text_)
      {
      }

      FileMesh read()
      {
        read_head();
        for (std::string word = text_.next(); !word.empty(); word = text_.next())
          read_section(upper_case(word));
        if (cells_.empty() || !has_types_)
          text_.refuse("the file ends without CELLS and CELL_TYPES");
        choose_ids();
        for (const VtkCell &cell : cells_)
          add(cell);
        if (!left_out_.empty())
          collector_.add_note("left out: " + list_of(left_out_));
        return collector_.finish();
      }

    private:
      void read_head()
      {
        std::string line;
        text_.next_line(line);
        if (upper_case(trimmed(line)).rfind("# VTK DATAFILE", 0) != 0)
          text_.refuse("cannot be read as a file of VTK's legacy format: the first line must begin "
                       "with \"# vtk DataFile\"");
        // The title may be empty.
        text_.next_line(line);
        line.clear();
        text_.next_line(line);
        const std::string kind = upper_case(trimmed(line));
        if (kind != "ASCII")
          text_.refuse("the third line must be ASCII" +
                       std::string(kind == "BINARY" ? ": binary files are not read" : ""));
        text_.expect("DATASET");
        text_.expect("UNSTRUCTURED_GRID");
      }

      void read_section(const std::string &keyword)
      {
        if (keyword == "POINTS")
          read_points();
        else if (keyword == "CELLS")
          read_cells();
        else if (keyword == "CELL_TYPES")
          read_types();
        else if (keyword == "CELL_DATA" || keyword == "POINT_DATA")
          {
            of_cells_ = keyword == "CELL_DATA";
            n_values_ = text_.integer("the number of values");
            if (n_values_ != static_cast<long>(of_cells_ ? cells_.size() : collector_.n_nodes()))
              text_.refuse(keyword + " has another number of " + (of_cells_ ? "cells" : "points"));
          }
        else if (keyword == "METADATA")
          for (std::string line; text_.next_line(line) && !trimmed(line).empty();)
            {
            }
        else if (keyword == "FIELD")
          read_field();
        else
          read_attribute(keyword);
      }

      void read_points()
      {
        if (collector_.n_nodes() > 0)
          text_.refuse("duplicate section POINTS");
        const long n = text_.integer("the number of points");
        text_.next(); // float or double
        for (long i = 0; i < n; ++i)
          collector_.add_node(text_.point());
      }

      unsigned int read_node()
      {
        const long node = text_.integer("a node");
        if (node >= static_cast<long>(collector_.n_nodes()))
          text_.refuse("node " + std::to_string(node) +
                       " does not exist (nodes are numbered from 0)");
        return node;
      }

      void read_cells()
      {
        if (!cells_.empty())
          text_.refuse("duplicate section CELLS");
        const long        n    = text_.integer("the number of cells");
        const long        size = text_.integer("the number of all numbers of cells");
        const std::string word = text_.next();
        if (upper_case(word) == "OFFSETS")
          {
            read_cells_by_offsets(n, size);
            return;
          }
        text_.put_back(word);
        // Number of nodes and the nodes from 0 of each cell.
        long n_numbers = 0;
        for (long i = 0; i < n; ++i)
          {
            VtkCell    cell;
            const long n_nodes = text_.integer("the number of nodes of a cell");
            cell.line          = text_.line();
            for (long k = 0; k < n_nodes; ++k)
              cell.nodes.push_back(read_node());
            n_numbers += n_nodes + 1;
            cells_.push_back(cell);
          }
        if (n_numbers != size)
          text_.refuse("the cells have " + std::to_string(n_numbers) +
                       " numbers, but the section's first line states " + std::to_string(size));
      }

      /** From version 5.1: where each cell begins in one list of nodes, and where the last ends. */
      void read_cells_by_offsets(const long n, const long size)
      {
        text_.next(); // type of numbers
        std::vector<long> offsets;
        for (long i = 0; i < n; ++i)
          offsets.push_back(text_.integer("an offset", offsets.empty() ? 0 : offsets.back()));
        if (!offsets.empty() && (offsets.front() != 0 || offsets.back() != size))
          text_.refuse("offsets go from 0 to the number of nodes of all cells, " +
                       std::to_string(size));
        text_.expect("CONNECTIVITY");
        text_.next(); // type of numbers
        for (std::size_t i = 1; i < offsets.size(); ++i)
          {
            VtkCell cell;
            for (long k = offsets[i - 1]; k < offsets[i]; ++k)
              {
                cell.nodes.push_back(read_node());
                cell.line = cell.line == 0 ? text_.line() : cell.line;
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
        has_types_ = true;
        for (VtkCell &cell : cells_)
          {
            cell.type          = text_.integer("the type of a cell");
            const bool is_face = cell.type == vtk_quadrilateral || cell.type == vtk_pixel;
            if (cell.type > vtk_line_strip && !is_face && cell.type != vtk_voxel &&
                cell.type != vtk_hexahedron)
              text_.refuse("cells of type " + std::to_string(cell.type) +
                           " are not read: only hexahedra (12) and quadrilaterals (9)");
            const std::size_t n_nodes = is_face ? 4 : 8;
            if (cell.type > vtk_line_strip && cell.nodes.size() != n_nodes)
              text_.refuse("a cell of type " + std::to_string(cell.type) + " has " +
                           std::to_string(n_nodes) + " nodes, the cell of line " +
                           std::to_string(cell.line) + " has " + std::to_string(cell.nodes.size()));
          }
      }

      /** An array of any kind but FIELD; the keyword says how many numbers it has. */
      void read_attribute(const std::string &keyword)
      {
        static const std::map<std::string, long> n_components = {{"VECTORS", 3},
                                                                 {"NORMALS", 3},
                                                                 {"TENSORS", 9},
                                                                 {"TENSORS6", 6},
                                                                 {"GLOBAL_IDS", 1},
                                                                 {"PEDIGREE_IDS", 1},
                                                                 {"EDGE_FLAGS", 1}};
        const std::string                        name         = decoded(text_.next());
        const auto                               plain        = n_components.find(keyword);
        if (keyword == "SCALARS")
          {
            text_.next(); // type
            const std::string rest = text_.rest_of_this_line();
            const auto        n    = plain_number(rest);
            const std::string word = text_.next();
            if (upper_case(word) == "LOOKUP_TABLE")
              text_.next();
            else
              text_.put_back(word);
            read_array(name, n ? static_cast<long>(*n) : 1, n_values_, "");
          }
        else if (plain != n_components.end())
          {
            text_.next(); // type
            read_array(name, plain->second, n_values_, "");
          }
        else if (keyword == "TEXTURE_COORDINATES" || keyword == "COLOR_SCALARS")
          {
            const long n = text_.integer("the number of components");
            if (keyword == "TEXTURE_COORDINATES")
              text_.next(); // type
            read_array(name, n, n_values_, "");
          }
        else if (keyword == "LOOKUP_TABLE")
          read_array(name, 4, text_.integer("the size of a table"), "");
        else
          text_.refuse("expected a section of an unstructured grid of VTK's legacy format, got \"" +
                       shown(keyword) + "\"");
      }

      /** FIELD NAME n, then n times: name, components, values, type; the numbers. */
      void read_field()
      {
        text_.next(); // its name
        const long n = text_.integer("the number of arrays");
        for (long i = 0; i < n; ++i)
          {
            std::string word = text_.next();
            while (upper_case(word) == "METADATA")
              {
                read_section("METADATA");
                word = text_.next();
              }
            const long components = text_.integer("the number of components");
            const long values     = text_.integer("the number of values");
            read_array(decoded(word), components, values, upper_case(text_.next()));
          }
      }

      /** Arrays of one number a cell are kept, others passed over and named. */
      void read_array(const std::string &name,
                      const long         components,
                      const long         values,
                      const std::string &type)
      {
        const bool may_be_ids = of_cells_ && components == 1 &&
                                values == static_cast<long>(cells_.size()) && type != "STRING";
        if (n_values_ > 0)
          left_out_.push_back((of_cells_ ? "data of cells \"" : "data of points \"") + shown(name) +
                              "\"");
        CellArray array;
        array.name = name;
        for (long i = 0; i < values * components; ++i)
          {
            std::string word;
            // Texts stand in lines of their own, which may be empty.
            if (type == "STRING" ? !text_.next_line(word) : (word = text_.next()).empty())
              text_.refuse("the file ends before a value of \"" + shown(name) + "\"");
            if (may_be_ids)
              {
                array.words.push_back(word);
                array.lines.push_back(text_.line());
              }
            else if (type != "STRING" && upper_case(word) != "NAN" && upper_case(word) != "-NAN" &&
                     !plain_number(word))
              text_.refuse("expected a number (a value of \"" + shown(name) + "\"), got \"" +
                           shown(word) + "\"");
          }
        if (may_be_ids)
          arrays_.push_back(std::move(array));
      }

      /** The array of cells whose name is most like one of the ids of regions. */
      void choose_ids()
      {
        const auto chosen =
          std::min_element(arrays_.begin(), arrays_.end(), [](const auto &a, const auto &b) {
            return rank_of_ids(a.name) < rank_of_ids(b.name);
          });
        if (chosen == arrays_.end() || rank_of_ids(chosen->name) == no_ids)
          return;
        for (std::size_t i = 0; i < cells_.size(); ++i)
          {
            const auto id = plain_number(chosen->words[i]);
            if (!id || *id != std::floor(*id) || std::abs(*id) > 1e9)
              text_.refuse("expected a whole number as id of \"" + shown(chosen->name) +
                           "\" in line " + std::to_string(chosen->lines[i]) + ", got \"" +
                           shown(chosen->words[i]) + "\"");
            cells_[i].id = static_cast<long>(*id);
          }
        left_out_.erase(std::remove(left_out_.begin(),
                                    left_out_.end(),
                                    "data of cells \"" + shown(chosen->name) + "\""),
                        left_out_.end());
        for (const CellArray &other : arrays_)
          if (&other != &*chosen && rank_of_ids(other.name) != no_ids &&
              other.words != chosen->words)
            collector_.add_warning("regions have the ids of \"" + shown(chosen->name) +
                                   "\"; the ids of \"" + shown(other.name) + "\" differ");
      }

      void add(const VtkCell &cell)
      {
        const auto &nodes = cell.nodes;
        if (cell.type == vtk_hexahedron)
          collector_.add_hexahedron(nodes, corner_of_files, cell.id, cell.line);
        else if (cell.type == vtk_voxel)
          collector_.add_hexahedron(nodes, corner_of_voxel, cell.id, cell.line);
        else if (cell.type == vtk_quadrilateral)
          collector_.add_face(nodes, cell.id, cell.line);
        else if (cell.type == vtk_pixel)
          collector_.add_face({nodes[0], nodes[1], nodes[3], nodes[2]}, cell.id, cell.line);
      }

      MeshText                 text_;
      GridCollector            collector_;
      std::vector<VtkCell>     cells_;
      std::vector<CellArray>   arrays_;
      std::vector<std::string> left_out_; ///< for the log
      bool                     has_types_ = false;
      bool                     of_cells_  = false; ///< the present data
      long                     n_values_  = 0;     ///< of the present data
    };
  } // namespace

  FileMesh read_vtk(const std::string &path)
  {
    return VtkReader(path).read();
  }
} // namespace vfife
