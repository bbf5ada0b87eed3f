// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_vtu_file_h
#define vfife_tests_vtu_file_h

#include <vfife/base/types.h>

#include <deal.II/base/utilities.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/** The numbers of a .vtu file: points, hexahedra by their points, data of both. */
class VtuFile
{
public:
  explicit VtuFile(const std::string &path)
  {
    boost::property_tree::ptree vtu;
    boost::property_tree::read_xml(path, vtu);
    const auto &piece = vtu.get_child("VTKFile.UnstructuredGrid.Piece");
    for (const auto &array : piece.get_child("PointData"))
      if (array.first == "DataArray")
        {
          // "von mises [MPa]"
          const auto        written = array.second.get<std::string>("<xmlattr>.Name");
          const std::string name    = written.substr(0, written.find(" ["));
          arrays_[name]             = read_array(array.second);
          units_[name]              = written.substr(name.size());
        }
    for (const auto &array : piece.get_child("CellData"))
      if (array.first == "DataArray")
        cell_arrays_[array.second.get<std::string>("<xmlattr>.Name")] = read_array(array.second);
    points_  = read_array(piece.get_child("Points.DataArray"));
    corners_ = read_array(piece.get_child("Cells.DataArray")); // the first: connectivity
  }

  std::size_t n_cells() const
  {
    return corners_.size() / 8;
  }

  /** A point of a cell, @p corner in the file's order. */
  std::size_t corner(const std::size_t cell, const unsigned int corner) const
  {
    return static_cast<std::size_t>(corners_.at(8 * cell + corner));
  }

  double cell_number(const std::string &name, const std::size_t cell) const
  {
    return cell_arrays_.at(name).at(cell);
  }

  /** The first array of points whose name begins with this. */
  std::string find(const std::string &start) const
  {
    const auto found = arrays_.lower_bound(start);
    if (found == arrays_.end() || found->first.rfind(start, 0) != 0)
      throw std::runtime_error("no array is called " + start);
    return found->first;
  }

  /** What stands behind the name: " [MPa]", or nothing. */
  const std::string &unit(const std::string &name) const
  {
    return units_.at(name);
  }

  /** All components at a point. */
  std::vector<double> values(const std::string &name, const std::size_t point) const
  {
    const auto       &all  = arrays_.at(name);
    const std::size_t size = all.size() / n_points();
    return {all.begin() + point * size, all.begin() + (point + 1) * size};
  }

  std::size_t n_points() const
  {
    return points_.size() / 3;
  }

  std::size_t n_arrays() const
  {
    return arrays_.size();
  }

  vfife::Vector3 point(const std::size_t i) const
  {
    return component(points_, i);
  }

  double number(const std::string &name, const std::size_t point) const
  {
    return arrays_.at(name).at(point);
  }

  vfife::Vector3 vector(const std::string &name, const std::size_t point) const
  {
    return component(arrays_.at(name), point);
  }

private:
  static vfife::Vector3 component(const std::vector<double> &values, const std::size_t i)
  {
    return {values.at(3 * i), values.at(3 * i + 1), values.at(3 * i + 2)};
  }

  /** One compressed block, its sizes before it. */
  static std::vector<double> read_array(const boost::property_tree::ptree &array)
  {
    std::string text = array.get_value<std::string>();
    text.erase(std::remove_if(text.begin(), text.end(), [](const char c) { return c <= ' '; }),
               text.end());
    // 16 bytes of four counts are 24 letters: blocks, their size, that of the last, compressed.
    const auto    head = dealii::Utilities::decode_base64(text.substr(0, 24));
    std::uint32_t counts[4];
    std::memcpy(counts, head.data(), sizeof counts);
    const auto        type   = array.get<std::string>("<xmlattr>.type");
    const auto        packed = dealii::Utilities::decode_base64(text.substr(24));
    std::vector<char> bytes(counts[2]);
    uLongf            size = counts[2];
    if ((type != "Float32" && type != "Int32") || counts[0] != 1 ||
        uncompress(reinterpret_cast<Bytef *>(bytes.data()), &size, packed.data(), counts[3]) !=
          Z_OK)
      throw std::runtime_error("an array of the .vtu file cannot be read");
    return type == "Float32" ? numbers_of<float>(bytes) : numbers_of<std::int32_t>(bytes);
  }

  template <typename Number>
  static std::vector<double> numbers_of(const std::vector<char> &bytes)
  {
    std::vector<Number> numbers(bytes.size() / sizeof(Number));
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return {numbers.begin(), numbers.end()};
  }

  std::vector<double>                        points_, corners_;
  std::map<std::string, std::vector<double>> arrays_, cell_arrays_;
  std::map<std::string, std::string>         units_;
};

#endif
