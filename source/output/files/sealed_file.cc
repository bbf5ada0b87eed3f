// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/output/files/sealed_file.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** What a file begins with. */
    struct Header
    {
      std::array<char, 16> mark           = {};
      std::uint64_t        format_version = 0;
      std::uint64_t        size           = 0; ///< of what follows [bytes]
      std::uint64_t        checksum       = 0; ///< of what follows: CRC-32
    };

    Header make_header(const SealedFile &kind, const std::string &bytes)
    {
      Header header;
      std::copy(kind.mark.begin(), kind.mark.end(), header.mark.begin());
      header.format_version = kind.format_version;
      header.size           = bytes.size();
      boost::crc_32_type crc;
      crc.process_bytes(bytes.data(), bytes.size());
      header.checksum = crc.checksum();
      return header;
    }
  } // namespace

  void SealedFile::write(const std::string &bytes, std::ostream &out) const
  {
    const Header header = make_header(*this, bytes);
    out.write(reinterpret_cast<const char *>(&header), sizeof(header));
    out.write(bytes.data(), bytes.size());
  }

  std::string SealedFile::read(const std::string &path, std::string &bytes) const
  {
    std::ifstream file(path, std::ios::binary);
    if (!file)
      return "\"" + path + "\" does not exist";
    std::ostringstream content;
    content << file.rdbuf();
    bytes = content.str();

    // From the cheap to the dear: length, mark, version, length behind the header, checksum.
    Header header;
    if (bytes.size() < sizeof(header))
      return "\"" + path + "\" is damaged: it has " + std::to_string(bytes.size()) + " bytes";
    std::memcpy(&header, bytes.data(), sizeof(header));
    bytes.erase(0, sizeof(header));

    // First whose file it is, then which format, then whether it is whole.
    const Header known = make_header(*this, bytes);
    if (header.mark != known.mark)
      return "\"" + path + "\" is not a " + noun + " of vfife, or is damaged";
    if (header.format_version != format_version)
      return "\"" + path + "\" is a " + noun + " of " +
             (header.format_version < format_version ? "an older" : "a newer") +
             " version of vfife (format " + std::to_string(header.format_version) +
             "); this version reads format " + std::to_string(format_version);
    if (header.size != bytes.size())
      return "\"" + path + "\" is damaged: it has " + std::to_string(bytes.size()) + " of " +
             std::to_string(header.size) + " bytes";
    if (header.checksum != known.checksum)
      return "\"" + path + "\" is damaged: its checksum is wrong";
    return "";
  }
} // namespace vfife
