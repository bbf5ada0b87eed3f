// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_refusal_h
#define vfife_tests_refusal_h

#include <vfife/base/errors.h>

#include <iostream>
#include <string>

/** What a user reads where @p act is refused; empty where it is accepted. */
template <typename Act>
std::string message_of(const Act &act)
{
  try
    {
      act();
    }
  catch (const vfife::InputError &error)
    {
      return error.what();
    }
  return "";
}

/** Prints that message: the .output file has it. */
template <typename Act>
void print_refusal(const Act &act)
{
  const std::string message = message_of(act);
  std::cout << (message.empty() ? "FAILED: accepted" : message) << std::endl;
}

#endif
