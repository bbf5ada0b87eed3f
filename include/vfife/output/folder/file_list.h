// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_folder_file_list_h
#define vfife_output_folder_file_list_h

#include <set>
#include <string>

namespace vfife
{
  /**
   * The names of all files that studies have written into a folder, kept there in the file
   * files.txt, a name per line. It tells results from a user's own files. A folder below has one
   * name that ends in "/". For one rank.
   */
  class FileList
  {
  public:
    static constexpr const char *file_name = "files.txt";

    /** Reads files.txt. A folder without it has no results. */
    explicit FileList(std::string folder);

    const std::set<std::string> &names() const
    {
      return names_;
    }

    /** Lists a file by its path in the folder; of a file in a folder below the name of that folder
     * is listed. Known names are not listed twice. */
    void add(const std::string &file);

    /** Whether a file in a folder below, such as "00003.vtu", has the ending of a result. */
    static bool has_result_ending(const std::string &file);

  private:
    std::string           folder_;
    std::set<std::string> names_;
  };
} // namespace vfife

#endif
