// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/shown_text.h>

#include "file_mesh.h"
#include "mesh_text.h"

#include <deal.II/grid/grid_in.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>

// Formats that deal.II reads and that have no reader of their own here.
namespace vfife
{
  namespace
  {
    const std::string of_hexahedra = "expected 8-node hexahedra, got ";
    const std::string convert      = ". Convert the file to .msh, .inp or .vtk";

    /** The first sentence of an exception: deal.II's have a page. */
    std::string reason_of(const std::exception &error)
    {
      std::ostringstream text;
      if (const auto *of_library = dynamic_cast<const dealii::ExceptionBase *>(&error))
        of_library->print_info(text);
      else
        text << error.what();
      std::string        sentence;
      std::istringstream words(text.str());
      for (std::string word; words >> word;)
        {
          sentence += (sentence.empty() ? "" : " ") + word;
          if (word.back() != '.')
            continue;
          sentence.pop_back();
          break;
        }
      return shown(sentence, 200);
    }

    /** I-DEAS writes exponents as Fortran does, 1.0D+00, which C++ does not read. */
    void read_unv(const std::string &path, dealii::GridIn<3> &grid)
    {
      std::ifstream file(path);
      std::string   text{std::istreambuf_iterator<char>(file), {}};
      for (std::size_t i = 1; i + 1 < text.size(); ++i)
        if (text[i] == 'D' && std::isdigit(static_cast<unsigned char>(text[i - 1])) != 0 &&
            (text[i + 1] == '+' || text[i + 1] == '-'))
          text[i] = 'E';
      std::istringstream in(text);
      grid.read_unv(in);
    }

    /** deal.II believes the counts and node numbers of the file, which are seen to before. */
    void read_xda(const std::string &path, dealii::GridIn<3> &grid)
    {
      MeshText    text(path);
      std::string line;
      text.next_line(line);
      const long n_elements = text.integer("the number of elements", 1);
      text.rest_of_this_line();
      const long n_nodes = text.integer("the number of nodes", 1);
      for (unsigned int i = 0; i < 8; ++i)
        text.next_line(line);
      for (long i = 0; i < 8 * n_elements; ++i)
        if (const long node = text.integer("the number of a node"); node >= n_nodes)
          text.refuse("node " + std::to_string(node) + " does not exist");
      for (long i = 0; i < n_nodes; ++i)
        text.point();
      std::ifstream in(path);
      grid.read_xda(in);
    }

    void read_vtu(const std::string &path, dealii::GridIn<3> &grid)
    {
      std::ifstream in(path);
      grid.read_vtu(in);
    }

#ifdef DEAL_II_TRILINOS_WITH_SEACAS
    void read_exodus(const std::string &path, dealii::GridIn<3> &grid)
    {
      grid.read_exodusii(path);
    }
    constexpr char no_exodus[] = "";
#else
    constexpr void (*read_exodus)(const std::string &, dealii::GridIn<3> &) = nullptr;
    constexpr char no_exodus[] = ", which a deal.II without Trilinos' SEACAS does not read";
#endif

    struct DealiiFormat
    {
      std::string end, name;
      void (*read)(const std::string &path, dealii::GridIn<3> &grid);
      std::string refusal = ""; ///< behind the name; where read is null
    };

    const std::vector<DealiiFormat> &formats()
    {
      static const std::vector<DealiiFormat> list = {
        {"unv", "UNV", &read_unv},
        {"xda", "XDA", &read_xda},
        {"vtu", "deal.II's VTU", &read_vtu},
        {"e", "Exodus II", read_exodus, no_exodus},
        {"exo", "Exodus II", read_exodus, no_exodus},
        {"mphtxt", "COMSOL", nullptr, ", of which deal.II reads tetrahedra and prisms alone"},
        {"dat", "Tecplot", nullptr, ", of which deal.II reads plane meshes alone"},
        {"dbmesh", "DB Mesh", nullptr, ", which is a format of plane meshes"}};
      return list;
    }
  } // namespace

  std::vector<std::string> dealii_formats()
  {
    std::vector<std::string> ends;
    for (const DealiiFormat &format : formats())
      if (format.read != nullptr)
        ends.push_back(format.end);
    return ends;
  }

  std::optional<FileMesh> read_by_dealii(const std::string &path)
  {
    const std::string end = path.substr(path.rfind('.') + 1);
    for (const DealiiFormat &format : formats())
      if (format.end == end)
        {
          if (format.read == nullptr)
            throw InputError(path + ": " + of_hexahedra + "a file of " + format.name +
                             format.refusal + convert);
          dealii::Triangulation<3> triangulation;
          dealii::GridIn<3>        grid(triangulation);
          try
            {
              format.read(path, grid);
            }
          catch (const InputError &)
            {
              throw;
            }
          catch (const std::exception &error)
            {
              // Whatever the libraries below throw at a damaged file.
              throw InputError(path + ": " + of_hexahedra + "a file of " + format.name +
                               " that deal.II does not read: " + reason_of(error) + convert);
            }
          return collect_file_mesh(path, triangulation);
        }
    return {};
  }

  FileMesh collect_file_mesh(const std::string &path, const dealii::Triangulation<3> &triangulation)
  {
    if (triangulation.n_active_cells() == 0)
      throw InputError(path + ": expected hexahedra, got none");
    if (!triangulation.all_reference_cells_are_hyper_cube())
      throw InputError(path + ": " + of_hexahedra +
                       "other cells. Mesh the body with hexahedra alone");
    if (triangulation.has_hanging_nodes())
      throw InputError(path + ": expected a mesh without hanging nodes, got one that is refined "
                              "locally. Refine all cells alike");
    FileMesh           mesh;
    FileMesh::Members  regions;
    FileMesh::Surfaces surfaces;
    for (const dealii::Point<3> &vertex : triangulation.get_vertices())
      mesh.nodes.emplace_back(vertex[0], vertex[1], vertex[2]);
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        const std::string region                 = "region " + std::to_string(cell->material_id());
        mesh.region_numbers[cell->material_id()] = region;
        regions[region].push_back(mesh.elements.size());
        CellNodes nodes;
        for (unsigned int v = 0; v < 8; ++v)
          nodes[v] = cell->vertex_index(v);
        mesh.elements.push_back(nodes);
        mesh.element_lines.push_back(0);
        for (const unsigned int f : cell->face_indices())
          {
            const auto face = cell->face(f);
            if (!face->at_boundary() || face->boundary_id() == 0)
              continue;
            // In turn, not in deal.II's order.
            surfaces["boundary " + std::to_string(face->boundary_id())].push_back(
              {{{face->vertex_index(0),
                 face->vertex_index(1),
                 face->vertex_index(3),
                 face->vertex_index(2)}},
               0});
          }
      }
    mesh.finish(path, {}, surfaces, regions);
    return mesh;
  }
} // namespace vfife
