// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The program of a folder of tests: PROGRAM NAME [arguments] runs the test NAME.
#include "registered_test.h"
#include "tests.h"

std::string source_folder()
{
  return TEST_SOURCE_FOLDER;
}

std::string tree_folder()
{
  return TEST_TREE_FOLDER;
}

std::string program_file()
{
  return TEST_PROGRAM_FILE;
}

int main(const int argc, char **argv)
{
  const auto &tests = RegisteredTest::all();
  const auto  test  = argc > 1 ? tests.find(argv[1]) : tests.end();
  if (test == tests.end())
    {
      std::cerr << "usage: " << argv[0] << " NAME [arguments], NAME one of\n";
      for (const auto &named : tests)
        std::cerr << "  " << named.first << '\n';
      return 1;
    }
  const int          code   = test->second(argc - 1, argv + 1);
  const CheckCounts &counts = check_counts();
  if (counts.passed > 0)
    std::cout << counts.passed << " checks: ok" << std::endl;
  return code == 0 && counts.failed > 0 ? 1 : code;
}
