// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_folder_input_files_h
#define vfife_output_folder_input_files_h

#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  struct DeclaredSection;

  /** Texts by the path of an entry, "A/B/name". */
  using TextsByEntry = std::vector<std::pair<std::string, std::string>>;

  /** Entries in force that name a file or a folder, with that name. */
  TextsByEntry list_named_files(const DeclaredSection &declared);

  /** Those that name a file that can be read, with the digest of its content. */
  TextsByEntry list_digests(const DeclaredSection &declared);

  /** What tells the content of a file from another one: CRC-32 (ISO 3309) and number of bytes as a
   * text. Empty for what is no file that can be read. */
  std::string digest_of_file(const std::string &path);

  /** A parameter file and all files that it includes, each once.
   * @throws InputError see read_statements(). */
  std::vector<std::string> list_parameter_files(const std::string &path);
} // namespace vfife

#endif
