// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/output/formats/hdf5_fields.h>

#include <deal.II/base/config.h>

#ifdef DEAL_II_WITH_HDF5
#  include <hdf5.h>
#endif

#include <cstdint>
#include <cstdio>
#include <ostream>
#include <stdexcept>

namespace vfife
{
  namespace
  {
    /** "instants/00003". */
    std::string group_of(const unsigned int number)
    {
      char text[32];
      std::snprintf(text, sizeof text, "instants/%05u", number);
      return text;
    }

#ifdef DEAL_II_WITH_HDF5
    // HDF5's own functions: deal.II's classes ignore in release builds what HDF5 returns, so that a
    // full disk would not be noticed, and neither compress nor remove.
    void require(const std::int64_t status, const std::string &path)
    {
      if (status < 0)
        throw std::runtime_error("HDF5 cannot write \"" + path + "\"");
    }

    /** Something open in HDF5, which is closed at the end of its scope. */
    class Handle
    {
    public:
      Handle(const hid_t id, herr_t (*close)(hid_t), const std::string &path)
        : id_(id)
        , close_(close)
      {
        require(id, path);
      }
      ~Handle()
      {
        close_(id_);
      }
      Handle(const Handle &)            = delete;
      Handle &operator=(const Handle &) = delete;

      operator hid_t() const
      {
        return id_;
      }

    private:
      hid_t id_;
      herr_t (*close_)(hid_t);
    };

    /** A new file, or one that is there, for writing. */
    hid_t open_file(const std::string &path, const bool is_new)
    {
      // Exceptions say what is wrong, not HDF5's stack.
      H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
      const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, path);
#  if H5_VERSION_GE(1, 12, 1) || (H5_VERSION_GE(1, 10, 7) && !H5_VERSION_GE(1, 12, 0))
      // A run goes on while ParaView has the file open.
      require(H5Pset_file_locking(access, false, true), path);
#  endif
      const hid_t file = is_new ? H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access)
                                : H5Fopen(path.c_str(), H5F_ACC_RDWR, access);
      if (file < 0 && !is_new)
        throw std::runtime_error("\"" + path +
                                 "\": expected the fields of this run, got a file that "
                                 "HDF5 cannot open. Move it away to begin a new one");
      return file;
    }

    /** A number or a text beside a group or an array. */
    void write_attribute(const hid_t        place,
                         const char        *name,
                         const hid_t        type,
                         const void        *value,
                         const std::string &path)
    {
      const Handle space(H5Screate(H5S_SCALAR), H5Sclose, path);
      const Handle attribute(H5Acreate2(place, name, type, space, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose,
                             path);
      require(H5Awrite(attribute, type, value), path);
    }

    void write_unit(const hid_t place, const std::string &unit, const std::string &path)
    {
      const Handle text(H5Tcopy(H5T_C_S1), H5Tclose, path);
      require(H5Tset_size(text, unit.size()), path);
      write_attribute(place, "unit", text, unit.data(), path);
    }

    /** One row a point or cell; one column: an array of one dimension. */
    void write_rows(const hid_t        group,
                    const std::string &name,
                    const hid_t        type,
                    const void        *numbers,
                    const hsize_t      n_rows,
                    const hsize_t      n_columns,
                    const std::string &unit,
                    const std::string &path)
    {
      const hsize_t size[] = {n_rows, n_columns};
      const int     n      = n_columns > 1 ? 2 : 1;
      const Handle  space(H5Screate_simple(n, size, nullptr), H5Sclose, path);
      const Handle  properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path);
      if (n_rows > 0)
        {
          // Bytes of the same place of all numbers first: exponents and signs are alike.
          require(H5Pset_chunk(properties, n, size), path);
          require(H5Pset_shuffle(properties), path);
          require(H5Pset_deflate(properties, 1), path);
        }
      const Handle rows(
        H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
        H5Dclose,
        path);
      require(H5Dwrite(rows, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers), path);
      if (!unit.empty())
        write_unit(rows, unit, path);
    }

    void
    write_arrays(const hid_t group, const std::vector<VtuArray> &arrays, const std::string &path)
    {
      for (const VtuArray &array : arrays)
        write_rows(group,
                   array.name,
                   H5T_NATIVE_FLOAT,
                   array.values.data(),
                   array.values.size() / array.n_components,
                   array.n_components,
                   array.unit,
                   path);
    }

    void write_mesh(const hid_t file, const VtuGrid &grid, const std::string &path)
    {
      const std::vector<std::int32_t> corners    = grid.connectivity();
      const auto                      make_group = [&](const char *name) {
        return H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
      };
      const Handle mesh(make_group("mesh"), H5Gclose, path);
      const Handle instants(make_group("instants"), H5Gclose, path);
      write_rows(mesh, "cells", H5T_NATIVE_INT32, corners.data(), grid.n_cells(), 8, "", path);
      write_arrays(mesh, grid.cell_data, path);
    }
#endif

    /** An array of numbers in the HDF5 file. */
    void write_item(std::ostream      &out,
                    const std::string &place,
                    const char        *type,
                    const std::size_t  n_rows,
                    const std::size_t  n_columns)
    {
      out << "<DataItem Dimensions=\"" << n_rows;
      if (n_columns > 1)
        out << ' ' << n_columns;
      out << "\" NumberType=\"" << type << "\" Precision=\"4\" Format=\"HDF\">" << place
          << "</DataItem>";
    }

    void write_attributes(std::ostream                &out,
                          const std::string           &group,
                          const char                  *center,
                          const std::vector<VtuArray> &arrays,
                          const std::size_t            n_rows)
    {
      for (const VtuArray &array : arrays)
        {
          // The tensor keeps VTK's order of components, which is not that of XDMF's Tensor6.
          const char *kind = array.n_components == 1   ? "Scalar"
                             : array.n_components == 3 ? "Vector"
                                                       : "Matrix";
          out << "<Attribute Name=\"" << array.name
              << (array.unit.empty() ? "" : " [" + array.unit + "]") << "\" AttributeType=\""
              << kind << "\" Center=\"" << center << "\">";
          write_item(out, group + array.name, "Float", n_rows, array.n_components);
          out << "</Attribute>\n";
        }
    }
  } // namespace

#ifdef DEAL_II_WITH_HDF5
  void write_hdf5_instant(const std::string &path,
                          const VtuGrid     &grid,
                          const unsigned int number,
                          const double       time)
  {
    const Handle file(open_file(path, number == 0), H5Fclose, path);
    if (number == 0)
      write_mesh(file, grid, path);
    {
      const Handle group(
        H5Gcreate2(file, group_of(number).c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Gclose,
        path);
      write_attribute(group, "time", H5T_NATIVE_DOUBLE, &time, path);
      write_rows(group,
                 "points",
                 H5T_NATIVE_FLOAT,
                 grid.points.data(),
                 grid.points.size() / 3,
                 3,
                 "mm",
                 path);
      write_arrays(group, grid.point_data, path);
    }
    // What the disk does not take shows here, at the latest.
    require(H5Fflush(file, H5F_SCOPE_GLOBAL), path);
  }

  void remove_hdf5_instants(const std::string &path, unsigned int number)
  {
    const Handle file(open_file(path, false), H5Fclose, path);
    for (; H5Lexists(file, group_of(number).c_str(), H5P_DEFAULT) > 0; ++number)
      require(H5Ldelete(file, group_of(number).c_str(), H5P_DEFAULT), path);
    require(H5Fflush(file, H5F_SCOPE_GLOBAL), path);
  }
#else
  void write_hdf5_instant(const std::string &path, const VtuGrid &, unsigned int, double)
  {
    throw std::runtime_error("\"" + path + "\" requires a deal.II with HDF5");
  }

  void remove_hdf5_instants(const std::string &path, const unsigned int number)
  {
    write_hdf5_instant(path, {}, number, 0);
  }
#endif

  void write_xdmf(std::ostream              &out,
                  const std::string         &name,
                  const VtuGrid             &arrays,
                  const std::size_t          n_points,
                  const std::size_t          n_cells,
                  const std::vector<double> &times)
  {
    out << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
           "<Grid Name=\"fields\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    for (unsigned int i = 0; i < times.size(); ++i)
      {
        const std::string instant = name + ":/" + group_of(i) + "/", mesh = name + ":/mesh/";
        out << "<Grid Name=\"instant\" GridType=\"Uniform\">\n<Time Value=\"" << times[i]
            << "\"/>\n<Topology TopologyType=\"Hexahedron\" NumberOfElements=\"" << n_cells
            << "\">";
        write_item(out, mesh + "cells", "Int", n_cells, 8);
        out << "</Topology>\n<Geometry GeometryType=\"XYZ\">";
        write_item(out, instant + "points", "Float", n_points, 3);
        out << "</Geometry>\n";
        write_attributes(out, instant, "Node", arrays.point_data, n_points);
        write_attributes(out, mesh, "Cell", arrays.cell_data, n_cells);
        out << "</Grid>\n";
      }
    out << "</Grid>\n</Domain>\n</Xdmf>\n";
  }
} // namespace vfife
