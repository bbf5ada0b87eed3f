// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Every parameter file of prm/ passes --check. What a file is to be is written in it:
// - one without a section Study is a part of others, which include it;
// - one whose head says "# Expected of --check: refused" shows what is refused;
// - one that reads what another case leaves names it below its folder of results, which is the
//   output folder of a file of prm/; where those results are missing, that is what is said.
#include "../../parts.h"
#include "../../read_files.h"
#include "../quick_pair.h"

#include <filesystem>
#include <regex>

using namespace vfife;

namespace fs = std::filesystem;

struct ShippedFile
{
  std::string path, text;

  bool has(const std::string &part) const
  {
    return has_text(text, part);
  }
};

std::vector<ShippedFile> list_files()
{
  std::vector<ShippedFile> files;
  for (const auto &entry : fs::recursive_directory_iterator(tree_folder() + "/prm"))
    if (entry.path().extension() == ".prm")
      {
        files.push_back({entry.path().lexically_normal().string(), read_text(entry.path())});
      }
  std::sort(files.begin(), files.end(), [](const ShippedFile &a, const ShippedFile &b) {
    return a.path < b.path;
  });
  return files;
}

/** What --check says against a file; empty: nothing. */
std::string find_fault(const ShippedFile &file, Communicator &world)
{
  try
    {
      check_case(file.path, world);
    }
  catch (const std::exception &error)
    {
      return error.what()[0] == '\0' ? "no message" : error.what();
    }
  return "";
}

/** Whether @p fault is that results are missing which a file of prm/ makes and @p file names. */
bool lacks_results(const ShippedFile              &file,
                   const std::string              &fault,
                   const std::vector<ShippedFile> &files)
{
  static const std::regex folder("results/[^/,;\" \n]+");
  for (std::sregex_iterator named(file.text.begin(), file.text.end(), folder), none; named != none;
       ++named)
    if (has_text(fault, named->str()) &&
        std::any_of(files.begin(), files.end(), [&](const ShippedFile &other) {
          return other.path != file.path &&
                 std::regex_search(other.text,
                                   std::regex("set output folder *= " + named->str() + "\n"));
        }))
      return true;
  return false;
}

void check_files(Communicator &world)
{
  const std::vector<ShippedFile> files = list_files();
  unsigned int                   n = 0, n_parts = 0, n_refused = 0;
  bool                           good = true;
  const auto                     fail = [&](const ShippedFile &file, const std::string &text) {
    std::cout << file.path << ": " << text << std::endl;
    good = false;
  };
  for (const ShippedFile &file : files)
    {
      ++n;
      if (!file.has("subsection Study\n"))
        {
          ++n_parts;
          const std::regex include("include [^\n]*" + fs::path(file.path).filename().string() +
                                   "\n");
          if (std::none_of(files.begin(), files.end(), [&](const ShippedFile &other) {
                return std::regex_search(other.text, include);
              }))
            fail(file, "has no section Study, and no file includes it");
          continue;
        }
      const bool        to_be_refused = file.has("# Expected of --check: refused\n");
      const std::string fault         = find_fault(file, world);
      n_refused += to_be_refused;
      if (to_be_refused && fault.empty())
        fail(file, "is to be refused");
      if (!to_be_refused && !fault.empty() && !lacks_results(file, fault, files))
        fail(file, fault);
    }
  check("every file of prm/ passes --check", good);
  check("most of them are cases", n > 20 && n_parts + n_refused < n / 10);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {check_files});
}
