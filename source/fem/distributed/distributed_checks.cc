// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/distributed/distributed_checks.h>

namespace vfife
{
  namespace
  {
    [[noreturn]] void refuse_distributed(const std::string &got, const std::string &remedy)
    {
      throw InputError("Fem/distributed", "expected no, got yes with " + got + ". " + remedy);
    }

    std::string quoted(const std::string &name)
    {
      return "\"" + name + "\"";
    }

    /** What holds the body. */
    void check_supports(const Model &model, const unsigned int body)
    {
      for (const Constraint &constraint : model.constraints)
        if (constraint.body == body && (constraint.kind == ConstraintKind::free_rotation ||
                                        constraint.kind == ConstraintKind::rigid_hub))
          refuse_distributed("the hub " + quoted(constraint.name) + ", which rotates freely",
                             "Set no, or set another kind of constraint.");
      for (const Load &load : model.loads)
        if (load.kind == LoadKind::spring && load.body == body)
          refuse_distributed("the spring " + quoted(load.name),
                             "Set no, or replace the spring by a constraint.");
      for (const Bearing &bearing : model.bearings)
        if (bearing.body == body)
          refuse_distributed("the bearing " + quoted(bearing.name),
                             "Set no, or replace the bearing by a constraint.");
      for (const Coupling &coupling : model.couplings)
        if (coupling.body == body)
          refuse_distributed("the coupling " + quoted(coupling.name),
                             "Set no, or replace the coupling by a constraint.");
    }
  } // namespace

  void check_distributed(const FemOptions &options)
  {
    if (!options.distributed)
      return;
    if (options.element == FemElement::incompatible_modes)
      throw InputError("Fem/element type",
                       "expected full integration, quadratic or cubic with Fem/distributed = yes, "
                       "got incompatible modes. Set quadratic.");
    if (options.cyclic_symmetry)
      throw InputError("Fem/cyclic symmetry",
                       "expected no with Fem/distributed = yes, got yes. Set no.");
    if (options.coriolis)
      throw InputError("Fem/coriolis", "expected no with Fem/distributed = yes, got yes. Set no.");
    if (options.hold_hubs)
      throw InputError("Fem/hold hubs", "expected no with Fem/distributed = yes, got yes. Set no.");
    for (const double rate : options.rates())
      if (rate != 0)
        throw InputError("Fem/speeds",
                         "expected 0 with Fem/distributed = yes, got a speed. Set 0.");
  }

  void check_distributed(const FemOptions                &options,
                         const Model                     &model,
                         const std::vector<unsigned int> &bodies,
                         const bool                       spins)
  {
    if (!options.distributed)
      return;
    if (!model.transmissions.empty())
      refuse_distributed("a gear pair", "Set no.");
    if (bodies.size() != 1)
      refuse_distributed(std::to_string(bodies.size()) + " bodies", "Name one in Fem/bodies.");
    const Body &body = model.bodies[bodies.front()];
    for (const ContactPair &contact : model.contacts)
      refuse_distributed("the contact " + quoted(contact.side), "Set no, or remove the contact.");
    for (const RigidWall &wall : model.walls)
      refuse_distributed("the rigid wall " + quoted(wall.name), "Set no, or remove the wall.");
    check_supports(model, bodies.front());
    if (body.has_initial_strains())
      refuse_distributed("initial strains of body " + quoted(body.name()),
                         "Set no, or remove the temperature.");
    if (spins && body.rate != 0)
      refuse_distributed("centrifugal force on body " + quoted(body.name()),
                         "Set Linear static/centrifugal = no, or the speed of the body to 0.");
  }
} // namespace vfife
