// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_watch_measurement_h
#define vfife_dynamics_watch_measurement_h

#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <vector>

namespace vfife
{
  class Communicator;
  class ContactSystem;
  class RigidWalls;
  class VfifeOperator;

  /** Sets what the measurements say of contact pairs and walls, of the forces added last.
   * Collective. */
  void
  measure_contact(const ContactSystem &contact, const RigidWalls &walls, Measurements &measured);

  /** Displacement in the turning body and stress at @p probes, those of the model or other nodes of
   * its bodies; elements' nodal stresses averaged. Collective. */
  std::vector<ProbeValue> measure_probes(const Model              &model,
                                         const std::vector<Probe> &probes,
                                         const State              &state,
                                         const VfifeOperator      &vfife,
                                         const Communicator       &communicator);
} // namespace vfife

#endif
