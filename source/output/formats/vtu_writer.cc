// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/column_names.h>
#include <vfife/output/formats/vtu_writer.h>

#include <deal.II/base/utilities.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

namespace vfife
{
  namespace
  {
    /** VTK's types of hexahedra by degree: 8 points, triquadratic, Lagrange. */
    constexpr std::uint8_t vtk_hexahedra[] = {12, 29, 72};

    /** The 27 points of a triquadratic hexahedron in VTK's order (corners, edges, faces, inside) by
     * their places in the lexicographic order. */
    constexpr unsigned int vtk_places[27] = {0,  2,  8, 6,  18, 20, 26, 24, 1,  5,  7, 3,  19, 23,
                                             25, 21, 9, 11, 17, 15, 12, 14, 10, 16, 4, 22, 13};

    /** The points of a cell in VTK's order by their places in the lexicographic order. */
    std::vector<unsigned int> make_vtk_order(const unsigned int degree)
    {
      const unsigned int        n = degree + 1;
      std::vector<unsigned int> order;
      for (unsigned int e = 0; e < 27; ++e)
        {
          // Before version 2.2 of the files, the last two edges of Lagrange cells change places.
          const unsigned int place = vtk_places[degree > 2 && (e == 18 || e == 19) ? 37 - e : e];
          // Along each axis: the first point, those inside or the last one.
          std::array<unsigned int, 3> first, end;
          for (unsigned int d = 0, left = place; d < 3; ++d, left /= 3)
            {
              first[d] = left % 3 == 2 ? degree : left % 3;
              end[d]   = left % 3 == 1 ? degree : first[d] + 1;
            }
          for (unsigned int k = first[2]; k < end[2]; ++k)
            for (unsigned int j = first[1]; j < end[1]; ++j)
              for (unsigned int i = first[0]; i < end[0]; ++i)
                order.push_back(i + n * (j + n * k));
        }
      return order;
    }

    /** The word for a type of numbers. */
    const char *type_word(const float)
    {
      return "Float32";
    }
    const char *type_word(const std::int32_t)
    {
      return "Int32";
    }
    const char *type_word(const std::uint8_t)
    {
      return "UInt8";
    }

    /** Bytes in letters. */
    std::string letters_of(const void *data, const std::size_t size)
    {
      const auto *bytes = static_cast<const unsigned char *>(data);
      return dealii::Utilities::encode_base64({bytes, bytes + size});
    }

    /** What a DataArray says of itself. */
    void write_attributes(std::ostream      &out,
                          const char        *type,
                          const std::string &name,
                          const unsigned int n_components,
                          const std::string &unit)
    {
      // ParaView's lists and colour bars show nothing but names.
      out << " type=\"" << type << "\" Name=\"" << name << (unit.empty() ? "" : " [" + unit + "]")
          << "\"";
      // Readers take one component that is stated for rows of one number.
      if (n_components > 1)
        out << " NumberOfComponents=\"" << n_components << "\"";
      if (!unit.empty())
        out << " units=\"" << unit << "\"";
    }

    /** A stream of zlib's. */
    std::vector<Bytef> pack(const Bytef *data, const uLong size)
    {
      const auto pack_part = [data](const uLong part, const int level) {
        uLongf             packed = compressBound(part);
        std::vector<Bytef> block(packed);
        if (compress2(block.data(), &packed, data, part, level) != Z_OK)
          throw NumericalError("the numbers of a .vtu file could not be compressed");
        block.resize(packed);
        return block;
      };
      // Most digits of what is computed are noise: to search them costs more than all else of a
      // file and saves a seventh of it. Where the beginning does not shrink to half, all is stored.
      const uLong begin = std::min<uLong>(size, 16384);
      return pack_part(size,
                       2 * pack_part(begin, Z_BEST_SPEED).size() < begin ? Z_BEST_SPEED
                                                                         : Z_NO_COMPRESSION);
    }

    /** One block: four counts (blocks, their size, that of the last, compressed size), then the
     * compressed numbers. */
    template <typename Number>
    void write_array(std::ostream              &out,
                     const std::string         &name,
                     const unsigned int         n_components,
                     const std::vector<Number> &values,
                     const std::string         &unit = "")
    {
      const uLong              size  = values.size() * sizeof(Number);
      const std::vector<Bytef> block = pack(reinterpret_cast<const Bytef *>(values.data()), size);
      const std::uint32_t      counts[4] = {1,
                                            static_cast<std::uint32_t>(size),
                                            static_cast<std::uint32_t>(size),
                                            static_cast<std::uint32_t>(block.size())};
      out << "<DataArray";
      write_attributes(out, type_word(Number()), name, n_components, unit);
      out << " format=\"binary\">\n"
          << letters_of(counts, sizeof counts) << letters_of(block.data(), block.size())
          << "\n</DataArray>\n";
    }

    void write_cells(std::ostream &out, const VtuGrid &grid)
    {
      // Signed, as VTK's own cells are: its threshold filter crashes on others (ParaView 5.11).
      std::vector<std::int32_t> offsets;
      for (std::size_t i = 1; i <= grid.n_cells(); ++i)
        offsets.push_back(static_cast<std::int32_t>(i * grid.points_per_cell()));
      const std::uint8_t type = vtk_hexahedra[grid.degree - 1];
      out << "<Cells>\n";
      write_array(out, "connectivity", 1, grid.connectivity());
      write_array(out, "offsets", 1, offsets);
      write_array(out, "types", 1, std::vector<std::uint8_t>(grid.n_cells(), type));
      out << "</Cells>\n";
    }

    void write_arrays(std::ostream &out, const char *element, const std::vector<VtuArray> &arrays)
    {
      out << '<' << element << ">\n";
      for (const VtuArray &array : arrays)
        write_array(out, array.name, array.n_components, array.values, array.unit);
      out << "</" << element << ">\n";
    }

    void list_arrays(std::ostream &out, const char *element, const std::vector<VtuArray> &arrays)
    {
      out << '<' << element << ">\n";
      for (const VtuArray &array : arrays)
        {
          out << "<PDataArray";
          write_attributes(out, type_word(0.F), array.name, array.n_components, array.unit);
          out << "/>\n";
        }
      out << "</" << element << ">\n";
    }
  } // namespace

  std::vector<VtuArray> make_stress_arrays()
  {
    std::vector<VtuArray> arrays;
    for (const std::string &name : column::stresses(column::cylindrical_axes))
      arrays.push_back({name, "MPa"});
    arrays.push_back({"stress", "MPa", 6});
    for (const char *name :
         {"principal stress 1", "principal stress 2", "principal stress 3", "von mises"})
      arrays.push_back({name, "MPa"});
    return arrays;
  }

  std::vector<VtuArray>::iterator
  add_stress(const Stress &cylindrical, const Stress &fixed, std::vector<VtuArray>::iterator arrays)
  {
    const auto add = [&arrays](const double number) {
      arrays->values.push_back(static_cast<float>(number));
    };
    for (const double component : cylindrical)
      {
        add(component);
        ++arrays;
      }
    for (const double component : fixed)
      add(component);
    ++arrays;
    for (const double principal : compute_principal_stresses(cylindrical))
      {
        add(principal);
        ++arrays;
      }
    add(von_mises(cylindrical));
    return ++arrays;
  }

  void VtuGrid::add_point(const Vector3 &x)
  {
    for (unsigned int c = 0; c < 3; ++c)
      points.push_back(static_cast<float>(x[c]));
  }

  std::vector<std::int32_t> VtuGrid::connectivity() const
  {
    const std::vector<unsigned int> order = make_vtk_order(degree);
    std::vector<std::int32_t>       numbers;
    for (std::size_t first = 0; first < cells.size(); first += order.size())
      for (const unsigned int place : order)
        numbers.push_back(static_cast<std::int32_t>(cells[first + place]));
    return numbers;
  }

  void write_vtu(std::ostream &out, const VtuGrid &grid, const double time)
  {
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
           "compressor=\"vtkZLibDataCompressor\" byte_order=\"LittleEndian\">\n"
           "<UnstructuredGrid>\n";
    if (!std::isnan(time))
      out << "<FieldData>\n<DataArray type=\"Float32\" Name=\"TIME\" NumberOfTuples=\"1\" "
             "format=\"ascii\">"
          << time << "</DataArray>\n</FieldData>\n";
    out << "<Piece NumberOfPoints=\"" << grid.points.size() / 3 << "\" NumberOfCells=\""
        << grid.n_cells() << "\">\n<Points>\n";
    write_array(out, "Points", 3, grid.points);
    out << "</Points>\n";
    write_cells(out, grid);
    write_arrays(out, "PointData", grid.point_data);
    write_arrays(out, "CellData", grid.cell_data);
    out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }

  void write_pvtu(std::ostream &out, const VtuGrid &grid, const std::vector<std::string> &pieces)
  {
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\" "
           "byte_order=\"LittleEndian\">\n<PUnstructuredGrid GhostLevel=\"0\">\n<PPoints>\n"
           "<PDataArray type=\"Float32\" NumberOfComponents=\"3\"/>\n</PPoints>\n";
    list_arrays(out, "PPointData", grid.point_data);
    list_arrays(out, "PCellData", grid.cell_data);
    for (const std::string &piece : pieces)
      out << "<Piece Source=\"" << piece << "\"/>\n";
    out << "</PUnstructuredGrid>\n</VTKFile>\n";
  }
} // namespace vfife
