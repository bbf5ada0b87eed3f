// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_options_bodies_at_start_h
#define vfife_model_options_bodies_at_start_h

namespace vfife
{
  class Log;
  struct Model;

  /**
   * Looks at how the undeformed bodies of a general model lie to each other and to its walls.
   * Throws InputError, naming the contact, where the surface of one body lies deeper inside the
   * other one than contact looks for it, and where a body lies behind a wall as a whole. Warns
   * where bodies of a contact overlap elsewhere, and of nodes deep in a wall that is soft on
   * purpose.
   */
  void check_start(const Model &model, Log &log);
} // namespace vfife

#endif
