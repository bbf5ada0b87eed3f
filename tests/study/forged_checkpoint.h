// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_study_forged_checkpoint_h
#define vfife_tests_study_forged_checkpoint_h

#include "child_program.h"

#include <boost/crc.hpp>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>

using ChangeBytes = std::function<void(std::string &)>;

/** Bytes of a checkpoint before its state. */
constexpr std::size_t checkpoint_header = 40;

/** Writes the checkpoint @p from into a folder as the only one there, after @p change of what
 * stands behind its header, with the size and the checksum that belong to it. */
inline void
forge_checkpoint(const std::string &from, const std::string &folder, const ChangeBytes &change)
{
  namespace fs                  = std::filesystem;
  constexpr std::size_t size_at = 24, checksum_at = 32;
  std::string           bytes = read_text(from), state = bytes.substr(checkpoint_header);
  change(state);
  boost::crc_32_type crc;
  crc.process_bytes(state.data(), state.size());
  const std::uint64_t size = state.size(), checksum = crc.checksum();
  bytes.replace(size_at, 8, reinterpret_cast<const char *>(&size), 8);
  bytes.replace(checksum_at, 8, reinterpret_cast<const char *>(&checksum), 8);
  fs::create_directory(folder);
  std::ofstream(folder + "/checkpoint.bin", std::ios::binary)
    << bytes.substr(0, checkpoint_header) << state;
  fs::remove(folder + "/checkpoint.previous.bin");
}

/** Changes one of @p parts: each is its name and its bytes, both with their length before them. */
inline void change_part(std::string &parts, const std::string &name, const ChangeBytes &change)
{
  const auto length_at = [&](const std::size_t at) {
    std::uint64_t length = 0;
    std::memcpy(&length, parts.data() + at, 8);
    return length;
  };
  for (std::size_t at = 0; at < parts.size();)
    {
      const std::string found = parts.substr(at + 8, length_at(at));
      at += 8 + found.size();
      const std::size_t length = length_at(at);
      if (found == name)
        {
          std::string bytes = parts.substr(at + 8, length);
          change(bytes);
          const std::uint64_t now = bytes.size();
          parts.replace(at,
                        8 + length,
                        std::string(reinterpret_cast<const char *>(&now), 8) + bytes);
          return;
        }
      at += 8 + length;
    }
}

#endif
