// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_registered_test_h
#define vfife_tests_registered_test_h

#include <functional>
#include <map>
#include <string>

/** A test of this program by its name: the main() of a source. */
struct RegisteredTest
{
  using Main = std::function<int(int, char **)>;

  RegisteredTest(const std::string &name, int (*main)(int, char **))
  {
    all()[name] = main;
  }

  RegisteredTest(const std::string &name, int (*main)())
  {
    all()[name] = [main](int, char **) { return main(); };
  }

  static std::map<std::string, Main> &all()
  {
    static std::map<std::string, Main> tests;
    return tests;
  }
};

#endif
