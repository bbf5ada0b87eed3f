// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The contact's options: defaults, words and units of the parameter file, refusals.
#include "../tests.h"

#include <vfife/base/errors.h>
#include <vfife/contact/law/contact_options.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>

using namespace vfife;

namespace
{
  bool refused(const std::function<void(ContactOptions &)> &spoil, const std::string &entry)
  {
    ContactOptions options;
    spoil(options);
    try
      {
        options.check("Contact");
      }
    catch (const InputError &error)
      {
        return error.entry() == entry;
      }
    return false;
  }
} // namespace

int main()
{
  ContactOptions           options;
  dealii::ParameterHandler prm;
  options.declare(prm);
  prm.parse_input_from_string("set discretization = two pass\n"
                              "set surface = flat facets\n"
                              "set points per facet = 4\n"
                              "set penalty from step = no\n"
                              "set penalty = 4e6\n"
                              "set friction coefficient = 0.08\n"
                              "set search skin = 50 um\n");
  check("discretization", options.discretization == ContactDiscretization::two_pass);
  check("surface", options.surface == ContactSurfaceKind::flat_facets);
  check("points per facet", options.points_per_facet == 4);
  check_close("friction coefficient", options.friction_coefficient, 0.08, 0.);
  check_close("search skin [mm]", options.search_skin, 0.05, 1e-15);
  check_close("edge fading keeps its default", options.edge_fading, 0.15, 0.);
  check_close("given penalty", options.penalty_for(1e-9, 1e-7), 4e6, 0.);
  options.penalty_from_step = true;
  options.penalty_fraction  = 0.5;
  check_close("penalty from the step", options.penalty_for(2e-9, 5e-8), 4e5, 1e-4);

  check("no points are refused",
        refused([](ContactOptions &o) { o.points_per_facet = 0; }, "Contact/points per facet"));
  check("an unstable fraction is refused",
        refused([](ContactOptions &o) { o.penalty_fraction = 3.; }, "Contact/penalty fraction"));
  check("a negative penalty is refused",
        refused(
          [](ContactOptions &o) {
            o.penalty_from_step = false;
            o.penalty           = -1.;
          },
          "Contact/penalty"));
}
