// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The contact's options: defaults, words and units of the parameter file, refusals.
#include "../read_entries.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/contact/law/contact_options.h>

#include <functional>

using namespace vfife;

bool refused(const std::function<void(ContactOptions &)> &spoil, const std::string &entry)
{
  ContactOptions options;
  spoil(options);
  return entry_and_message_of([&] { options.check("Contact"); }).find(entry + ": ") == 0;
}
FrictionLawKind find_friction_law(const std::string &name)
{
  const auto &laws = friction_laws();
  return std::find_if(laws.begin(), laws.end(), [&](const auto &law) { return law.first == name; })
    ->second;
}
/** At the voted step, elements (4/step^2) and springs together have the highest frequency that
 * central differences allow; a spring moves one node at a wall, two between bodies. */
void check_vote()
{
  const double step = 1e-7, mass_per_area = 3e-9;
  for (const unsigned int n_moving : {1u, 2u})
    {
      PenaltyOptions    penalty(n_moving);
      const std::string name   = n_moving == 1 ? "wall: " : "two bodies: ";
      double            dt     = penalty.vote_of_stick(step);
      const double      spring = PenaltyOptions::stick_value(mass_per_area, dt) / mass_per_area;
      check_close(name + "frequency at the voted step, points that stick",
                  (4. / (step * step) + n_moving * spring) * dt * dt,
                  4.,
                  1e-14);
      check_close(name + "mass of a penalty",
                  penalty.mass_per_area_for(spring * mass_per_area, dt),
                  mass_per_area,
                  1e-23);
      penalty.value = 2e5;
      dt            = penalty.vote_on_step(step, mass_per_area);
      check_close(name + "frequency at the voted step, given penalty",
                  (4. / (step * step) + n_moving * penalty.value / mass_per_area) * dt * dt,
                  4.,
                  1e-14);
      // omega^2 = n k/m = (2 fraction)^2
      check_close(name + "mass for a relaxation",
                  n_moving * 3. / penalty.relaxation_mass(3., 0.8),
                  1.6 * 1.6,
                  1e-14);
    }
}

int main()
{
  ContactOptions options;
  read_entries(options,
               "set discretization = two pass\n"
               "set surface = flat facets\n"
               "set points per facet = 4\n"
               "set penalty = 4e6\n"
               "set friction coefficient = 0.08\n"
               "set search tolerance = 50 um\n");
  check("discretization", options.discretization == ContactDiscretization::two_pass);
  check("surface", options.surface == ContactSurfaceKind::flat_facets);
  check("points per facet", options.points_per_facet.number == 4);
  check_close("friction coefficient", options.friction.coefficient, 0.08, 0.);
  check_close("search skin [mm]", options.search_skin, 0.05, 1e-15);
  check_close("edge fading keeps its default", options.edge_fading, 0.15, 0.);
  check_close("given penalty", options.penalty.value, 4e6, 0.);
  check_close("stiffness of points that stick", PenaltyOptions::stick_value(2e-9, 5e-8), 4e5, 1e-4);

  check("points across a contact: four, at least 3, at most 12 per facet",
        points_across(1.7, .754) == 10 && points_across(.1, .754) == 3 &&
          points_across(10., .754) == 12);
  check("no points are refused",
        refused([](ContactOptions &o) { o.points_per_facet.number = 0; },
                "Contact/points per facet"));
  check("a static friction coefficient of Coulomb's law is refused",
        refused([](ContactOptions &o) { o.friction.static_coefficient = 0.2; },
                "Contact/static friction coefficient"));
  ContactOptions unused;
  unused.friction.static_coefficient = 0.2;
  check("the message names the law that uses it",
        entry_and_message_of([&] { unused.check("Contact"); }) ==
          "Contact/static friction coefficient: expected auto with the friction law \"Coulomb\", "
          "got 0.2. Set friction law to exponential decay.");
  check("a decay speed of Coulomb's law is refused",
        refused([](ContactOptions &o) { o.friction.decay_speed = 50.; },
                "Contact/friction decay speed"));
  const auto decay = [](ContactOptions &o) {
    o.friction.law                = find_friction_law("exponential decay");
    o.friction.coefficient        = 0.1;
    o.friction.static_coefficient = 0.2;
    o.friction.decay_speed        = 50.;
  };
  check("decaying friction", !refused(decay, "Contact/friction decay speed"));
  ContactOptions decaying;
  check("no friction by default", !decaying.friction.acts());
  decay(decaying);
  decaying.friction.coefficient = 0.;
  check("friction at rest alone acts", decaying.friction.acts());
  check("friction that grows with the slip is refused",
        refused(
          [&](ContactOptions &o) {
            decay(o);
            o.friction.static_coefficient = 0.05;
          },
          "Contact/static friction coefficient"));
  check("a decay without its speed is refused",
        refused(
          [&](ContactOptions &o) {
            decay(o);
            o.friction.decay_speed = 0.;
          },
          "Contact/friction decay speed"));
  check("a negative penalty is refused",
        refused([](ContactOptions &o) { o.penalty.value = -1.; }, "Contact/penalty"));
  check("an open penalty is accepted",
        !refused([](ContactOptions &o) { o.penalty.value = 0.; }, "Contact/penalty"));
  // Springs of 5 (m/A)/dt^2: two and forty of them in dynamics/impact.
  check_close("penalty that rattles", PenaltyOptions::rattling_value(2e-9, 5e-8), 4e6, 1e-3);
  check_vote();
  return 0;
}
