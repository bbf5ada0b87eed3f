// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_sealed_file_h
#define vfife_output_files_sealed_file_h

#include <cstdint>
#include <iosfwd>
#include <string>

namespace vfife
{
  /** A kind of binary file of the program: bytes behind a header that tells whose they are, in
   * which format, how many, and their checksum. */
  struct SealedFile
  {
    std::string   mark; ///< at most 15 characters
    std::string   noun; ///< what messages call such a file
    std::uint64_t format_version;

    void write(const std::string &bytes, std::ostream &out) const;

    /** Sets the @p bytes behind the header; returns what is wrong with the file, or nothing. */
    std::string read(const std::string &path, std::string &bytes) const;
  };
} // namespace vfife

#endif
