// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/output/folder/file_list.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace vfife
{
  namespace
  {
    namespace fs = std::filesystem;
  } // namespace

  FileList::FileList(std::string folder)
    : folder_(std::move(folder))
  {
    std::ifstream file(fs::path(folder_) / file_name);
    if (!file)
      return;
    for (std::string name; std::getline(file, name);)
      // A line that leads out of the folder is none of the program's.
      if (!name.empty() && name[0] != '/' && name.find("..") == std::string::npos)
        names_.insert(name);
    names_.insert(file_name);
  }

  void FileList::add(const std::string &file)
  {
    const std::string name = file.substr(0, std::min(file.find('/'), file.size() - 1) + 1);
    if (!names_.insert(name).second)
      return;
    // Listed before it is written: what a killed program leaves is known too. A disk that takes no
    // line takes no file either, which is the one that says so.
    std::ofstream out(fs::path(folder_) / file_name, std::ios::app);
    if (names_.insert(file_name).second)
      for (const std::string &known : names_)
        out << known << '\n';
    else
      out << name << '\n';
  }

  bool FileList::has_result_ending(const std::string &file)
  {
    static const std::set<std::string> endings = {".csv",
                                                  ".json",
                                                  ".prm",
                                                  ".pvd",
                                                  ".vtu",
                                                  ".pvtu",
                                                  ".xdmf",
                                                  ".h5",
                                                  ".mtx",
                                                  ".svg",
                                                  ".png",
                                                  ".html",
                                                  ".bin",
                                                  ".part"};
    return endings.count(fs::path(file).extension().string()) > 0;
  }
} // namespace vfife
