// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The program has kernels of OpenBLAS for its processor's instruction set, or those that the user
// asks for.
#include "../child_program.h"

#include <vfife/base/process/blas_kernels.h>

#include <cstdlib>

/** What OpenBLAS says that it has chosen as it is loaded; empty where it is not the BLAS. */
std::string kernels_of_program()
{
  // An empty file is refused as soon as the program is loaded.
  std::ofstream("empty.prm") << "";
  const std::string text = run_program({"env", program_file(), "empty.prm", "--check"}).text;
  const auto        at   = text.find("Core: ");
  return at == std::string::npos ? "" : text.substr(at + 6, text.find('\n', at) - at - 6);
}

int main()
{
  setenv("OPENBLAS_VERBOSE", "2", 1);
  unsetenv("OPENBLAS_CORETYPE");
  const std::string own = kernels_of_program();
  vfife::prefer_blas_kernels();
  const char *const preferred = std::getenv("OPENBLAS_CORETYPE");
  check("kernels for the processor", own.empty() || preferred == nullptr || own == preferred);
  check("no kernels without AVX where there is AVX2",
        !__builtin_cpu_supports("avx2") || (own != "Prescott" && own != "Nehalem"));
  setenv("OPENBLAS_CORETYPE", "Nehalem", 1);
  check("the user's kernels", own.empty() || kernels_of_program() == "Nehalem");
  return 0;
}
