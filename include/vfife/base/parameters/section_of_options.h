// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_section_of_options_h
#define vfife_base_parameters_section_of_options_h

#include <vfife/base/parameters/parameters.h>

#include <string>

namespace vfife
{
  /** Declares options that have a section of their own, which they do not name themselves. */
  template <typename Options>
  void declare_section(dealii::ParameterHandler &prm, const std::string &name, Options &options)
  {
    const Subsection section(prm, name);
    options.declare(prm);
  }
} // namespace vfife

#endif
