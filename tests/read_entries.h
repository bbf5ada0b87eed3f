// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_read_entries_h
#define vfife_tests_read_entries_h

#include <deal.II/base/parameter_handler.h>

#include <string>

/** Reads @p text as the section of the options. */
template <typename Options>
void read_entries(Options &options, const std::string &text)
{
  dealii::ParameterHandler prm;
  options.declare(prm);
  prm.parse_input_from_string(text);
}

#endif
