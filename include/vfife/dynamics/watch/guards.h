// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_watch_guards_h
#define vfife_dynamics_watch_guards_h

#include <string>
#include <vector>

namespace vfife
{
  class Communicator;
  class ContactSystem;
  class RigidWalls;
  struct BodySums;
  struct ElementMeasures;
  struct Model;
  struct State;

  // What a run is given up for (doc/theory/dynamics.md, Guards). All throw NumericalError with time
  // and step, on all ranks alike: they are collective. EnergyBook::check() is the fourth guard.

  /** Time and step in words. */
  std::string describe_instant(const State &state);

  /** The kinetic energy of the bodies' @p sums over all ranks is not finite. Names this rank's
   * first node of @p now that is not finite, and its most distorted element in @p last_measured. */
  void check_motion(const Model                 &model,
                    const std::vector<BodySums> &sums,
                    const State                 &last_measured,
                    const State                 &now);

  /** A point of a contact is deeper than the pair's penetration limit, or a node deeper behind a
   * wall than its limit. */
  void check_penetration(const Model         &model,
                         const ContactSystem &contact,
                         const RigidWalls    &walls,
                         const State         &now);

  /** In words: the deepest point of what presses, between bodies or at a wall. Collective. */
  std::string
  describe_deepest(const Model &model, const ContactSystem &contact, const RigidWalls &walls);

  /** An element of the state that was measured, with these @p measures, is inverted. */
  void check_elements(const Model           &model,
                      const State           &measured,
                      const ElementMeasures &measures,
                      const Communicator    &communicator);
} // namespace vfife

#endif
