// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_refusal_h
#define vfife_tests_refusal_h

#include <vfife/base/errors.h>

#include <iostream>
#include <string>

/** What a user reads where @p act is refused by that exception; empty where it is accepted. */
template <typename Error = vfife::InputError, typename Act>
std::string message_of(const Act &act)
{
  try
    {
      act();
    }
  catch (const Error &error)
    {
      return error.what();
    }
  return "";
}

/** Whether @p act is refused by that exception. */
template <typename Error = vfife::InputError, typename Act>
bool refuses(const Act &act)
{
  return !message_of<Error>(act).empty();
}

/** "entry: message" of a refusal. */
template <typename Act>
std::string entry_and_message_of(const Act &act)
{
  try
    {
      act();
    }
  catch (const vfife::InputError &error)
    {
      return error.entry() + ": " + error.what();
    }
  return "";
}

inline void print_message(const std::string &message)
{
  std::cout << (message.empty() ? "FAILED: accepted" : message) << std::endl;
}

/** Prints the message of a refusal: the .output file has it. */
template <typename Error = vfife::InputError, typename Act>
void print_refusal(const Act &act)
{
  print_message(message_of<Error>(act));
}

/** The same with the entry before it. */
template <typename Act>
void print_refused_entry(const Act &act)
{
  print_message(entry_and_message_of(act));
}

#endif
