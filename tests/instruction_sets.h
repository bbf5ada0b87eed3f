// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_instruction_sets_h
#define vfife_tests_instruction_sets_h

#include <vfife/element/kernels/kernels.h>

#include <functional>
#include <iostream>
#include <string>

/** What a test returns that this processor cannot run: ctest reports it as skipped. */
constexpr int test_is_skipped = 77;

/** Calls @p checks for the instruction set with the name @p word; the exit code of the test. */
inline int run_instruction_set(const std::string                                      &word,
                               const std::function<void(const vfife::InstructionSet)> &checks)
{
  using vfife::InstructionSet;
  for (const InstructionSet set : {InstructionSet::generic,
                                   InstructionSet::sse2,
                                   InstructionSet::avx2,
                                   InstructionSet::avx512})
    if (word == vfife::name_of(set))
      {
        if (!vfife::is_available(set))
          {
            std::cout << "this processor does not have " << word << std::endl;
            return test_is_skipped;
          }
        checks(set);
        return 0;
      }
  std::cout << "FAILED: there is no instruction set " << word << std::endl;
  return 1;
}

#endif
