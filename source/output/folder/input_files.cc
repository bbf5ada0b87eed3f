// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/declared_section.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameter_statement.h>
#include <vfife/output/folder/input_files.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace vfife
{
  namespace
  {
    void
    add_named_files(const DeclaredSection &section, const std::string &before, TextsByEntry &names)
    {
      for (const DeclaredSection::Entry &entry : section.entries)
        if (names_a_file(entry.pattern, entry.value))
          names.emplace_back(before + entry.name, entry.value);
      for (const DeclaredSection &below : section.sections)
        add_named_files(below, before + below.name + "/", names);
    }
  } // namespace

  TextsByEntry list_named_files(const DeclaredSection &declared)
  {
    TextsByEntry names;
    add_named_files(declared, "", names);
    return names;
  }

  TextsByEntry list_digests(const DeclaredSection &declared)
  {
    TextsByEntry digests;
    for (const auto &[entry, name] : list_named_files(declared))
      if (const std::string digest = digest_of_file(name); !digest.empty())
        digests.emplace_back(entry, digest);
    return digests;
  }

  std::string digest_of_file(const std::string &path)
  {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
      return "";
    std::ifstream      file(path, std::ios::binary);
    boost::crc_32_type crc;
    std::uintmax_t     size = 0;
    // Piece by piece: meshes may be large.
    for (std::array<char, 65536> piece; file;)
      {
        file.read(piece.data(), piece.size());
        crc.process_bytes(piece.data(), file.gcount());
        size += file.gcount();
      }
    if (!file.eof())
      return "";
    std::ostringstream text;
    text << "CRC-32 " << std::hex << std::setw(8) << std::setfill('0') << crc.checksum() << ", "
         << std::dec << size << " bytes";
    return text.str();
  }

  std::vector<std::string> list_parameter_files(const std::string &path)
  {
    std::vector<std::string> files = {path};
    for (const ParameterStatement &statement : read_statements(path))
      {
        // "file.prm:12"
        const std::string file = statement.place.substr(0, statement.place.rfind(':'));
        if (std::find(files.begin(), files.end(), file) == files.end())
          files.push_back(file);
      }
    return files;
  }
} // namespace vfife
