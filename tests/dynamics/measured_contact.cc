// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What is measured of two punches that stand in a floor at different depths: every number of either
// against penalty, depth and size.
#include "../parts.h"
#include "../tests.h"
#include "one_solver.h"

using namespace vfife;

constexpr double penalty = 5000.; // [N/mm^3]

/** A block whose lower face of @p length x @p width lies @p depth below the floor's surface. */
struct Punch
{
  double x, length, width, depth; // [mm]
};

const Punch punches[] = {{3., 6., 2., 1e-3}, {14., 3., 4., 2e-3}};

Model make_model()
{
  Model model = model_of({"floor", make_block(Vector3(20., 10., 2.), {{20, 10, 1}}), Material()});
  for (const Punch &p : punches)
    {
      const unsigned int number = model.bodies.size();
      Body               body("punch " + std::to_string(number),
                make_block(Vector3(p.length, p.width, 2.), {{4, 4, 1}}),
                Material());
      body.placement.translation = Vector3(p.x, 3., 2. - p.depth);
      model.add_body(std::move(body));
      ContactPair pair =
        contact_of("side " + std::to_string(number), "z-", "z+", ContactSurfaceKind::flat_facets);
      pair.slave_body                      = number;
      pair.master_body                     = 0;
      pair.options.points_per_facet.number = 2; // of equal weights
      pair.options.edge_fading             = 0.;
      pair.options.penalty.value           = penalty;
      model.contacts.push_back(pair);
    }
  return model;
}

void measure()
{
  const Model model = make_model();
  OneSolver   run(model, undamped());
  run.solver.measure_at_rest(run.state);
  const Measurements &m = run.state.measured;
  check("two contacts", m.teeth.size() == 2 && m.contact_forces.size() == 2);
  double total = 0., energy = 0.;
  for (std::size_t i = 0; i < 2; ++i)
    {
      const Punch        &p     = punches[i];
      const ToothContact &found = m.teeth.at(i);
      const double        area = p.length * p.width, force = penalty * p.depth * area;
      const std::string   name = model.contacts[found.contact].side + ": ";
      check_close(name + "area [mm^2]", found.area, area, 1e-9);
      check_close(name + "normal force [N]", found.normal_force, force, 1e-7);
      check_below(name + "force on the slave less that [N]",
                  (found.force - Vector3(0., 0., force)).norm(),
                  1e-7);
      check_close(name + "pressure [MPa]", found.largest_pressure, penalty * p.depth, 1e-8);
      check_close(name + "penetration [mm]", found.penetration, p.depth, 1e-12);
      // Of a constant pressure <x^2> = w^2/12, of Hertz's over its width 1/16 of it.
      check_ratio(name + "width over sqrt(16/12) of the narrower side",
                  found.width / (std::sqrt(16. / 12.) * std::min(p.length, p.width)),
                  1e-9);
      check_below(name + "force of the contact less that [N]",
                  (m.contact_forces.at(i) - Vector3(0., 0., force)).norm(),
                  1e-7);
      total += force;
      energy += 0.5 * force * p.depth;
    }
  check_close("contact force of both [N]", m.contact_force, total, 1e-7);
  check_close("deepest [mm]", m.largest_penetration, 2e-3, 1e-12);
  check_close("energy of the springs [mJ]", m.energy.contact, energy, 1e-9);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {measure});
}
