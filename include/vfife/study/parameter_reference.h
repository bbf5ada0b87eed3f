// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_parameter_reference_h
#define vfife_study_parameter_reference_h

#include <iosfwd>

namespace vfife
{
  /**
   * Writes all sections and entries of all kinds of studies as a page of Markdown, from what the
   * kinds declare: default, meaning, what is allowed, and which kinds read the section. Sections
   * that exist once a body, load, ... appear once, NAME standing for the name, and a body's entries
   * for each of its meshes.
   */
  void write_parameter_reference(std::ostream &out);
} // namespace vfife

#endif
