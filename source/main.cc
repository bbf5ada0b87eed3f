// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/blas_kernels.h>
#include <vfife/base/process/command_line.h>

#include <cstring>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <unistd.h>

// The program that users call. Loading deal.II with its 200 libraries and starting MPI take about a
// second: what needs neither is answered here, everything else by vfife-study, which stands beside
// this program and takes its place: same process, same arguments.

namespace
{
  /** Whether the arguments ask for a text alone, which is then printed. */
  bool answers(const int argc, const char *const *argv)
  {
    try
      {
        return vfife::print_requested_text(vfife::parse_command_line(argc, argv), std::cout);
      }
    catch (const vfife::InputError &)
      {
        return false; // vfife-study says what is wrong, as it does of all input
      }
  }
} // namespace

int main(int argc, char **argv)
{
  if (answers(argc, argv))
    return 0;
  std::error_code             error;
  const std::filesystem::path self  = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::string           study = (self.parent_path() / "vfife-study").string();
  vfife::prefer_blas_kernels();
  execv(study.c_str(), argv);
  std::cerr << "vfife: the program " << study << " cannot be started: " << std::strerror(errno)
            << std::endl;
  return 1;
}
