// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_start_stresses_h
#define vfife_study_reduced_start_stresses_h

#include <vfife/output/files/figures.h>

namespace vfife
{
  class Communicator;
  class Compliance;
  class Log;
  struct FemOptions;
  struct Model;

  /**
   * The largest stress of web, rim and hub of the pair at rest in its first position, under torque
   * and spin, of all nodes: a reduced body knows stresses of its probes and fillets alone. Says in
   * the log what it finds, or why nothing. @p compliance: of the model's bodies of elements @p fem;
   * nullptr: is factorized here. Collective.
   */
  NamedFigures find_start_stresses(const Model        &model,
                                   const FemOptions   &fem,
                                   Compliance         *compliance,
                                   const Communicator &communicator,
                                   Log                &log);
} // namespace vfife

#endif
