// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameter_handler_h
#define vfife_base_parameter_handler_h

// For headers whose functions declare entries: the class of deal.II by its name alone.
namespace dealii
{
  class ParameterHandler;
}

#endif
