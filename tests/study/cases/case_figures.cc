// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Figures of a case before it moves: steps between samples, masses of meshes beside those of the
// true bodies, areas, and how wide contacts were when a run warns of them.
#include "../../parts.h"
#include "../../read_files.h"
#include "../gear_model.h"
#include "../quick_pair.h"

#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/study/cases/contact_resolution.h>
#include <vfife/study/pressure/contact_width_watch.h>

using namespace vfife;

std::string text()
{
  return coarse_pair("set body type = conical web", coarse_web) +
         "subsection Operation\n  set speed = 8000 rpm\n  set torque = 800 N m\nend\n";
}

/** 3600 mesh cycles a second, seven samples in each. */
void steps(Communicator &)
{
  std::ofstream("steps.prm") << text();
  const ParameterFile file("steps.prm");
  GearCase            gears;
  file.read_known([&](dealii::ParameterHandler &prm) { gears.declare(prm, file); });
  for (const double stable : {100e-9, 93e-9, 57.3e-9})
    {
      const double step = gears.choose_step(stable, 7), steps = 1. / (3600. * 7 * step);
      check_close("whole steps from sample to sample", steps, std::round(steps), 1e-9);
      check("stable, and not shorter than samples ask for",
            step <= stable && stable < step * (steps / (steps - 1)));
    }
}

void meshes(Communicator &world)
{
  std::ofstream("meshes.prm") << text() << "subsection Study\n  set kind = mesh\nend\n";
  run_pair("meshes.prm", "meshes", world, {});
  const auto mesh = read_columns("meshes/mesh.csv");
  for (const std::string figure : {"mass", "polar inertia", "transverse inertia"})
    for (const unsigned int body : {0, 1})
      check_close(figure + ": difference in per cent",
                  mesh.at(figure + " difference")[body],
                  100. * (mesh.at(figure)[body] / mesh.at("true " + figure)[body] - 1.),
                  1e-9);
  // A disc has twice as much about its axis as across it; the pinion on its shaft has not.
  const double about = mesh.at("polar inertia")[1], across = mesh.at("transverse inertia")[1];
  check("about and across the axis of the gear", about > 1.8 * across && about < 2. * across);
  // In the log, of the same body, in brackets.
  char difference[32];
  std::snprintf(difference, sizeof difference, "(%+.3f %%)", mesh.at("mass difference")[1]);
  check("difference of the mass in the log", has_text(read_text("meshes/run.log"), difference));
}

void areas(Communicator &)
{
  FacetSurface surface;
  surface.positions = {Vector3(0, 0, 0),
                       Vector3(2, 0, 0),
                       Vector3(2, 3, 0),
                       Vector3(0, 3, 0),
                       Vector3(2, 0, 4),
                       Vector3(2, 3, 4)};
  surface.facets    = {{{0, 1, 2, 3}}, {{1, 4, 5, 2}}};
  check_close("area of two rectangles", compute_area(surface), 2. * 3. + 4. * 3., 1e-14);
}

/** Facets of 1.7 mm under Hertz's contact, whose width is 2 x 0.377 mm under 800 N m and twice
 * that under eight times the load, have four points across it, at most twelve per facet. */
void points(Communicator &world)
{
  const std::string pair = "include " + tree_folder() +
                           "/prm/paper_pair.prm\nsubsection Gear pair\n  set mesh = "
                           "coarse\nend\nsubsection Operation\n  set speed = 20000 rpm\n"
                           "  set torque = ";
  const auto count = [&](const std::string &torque, const std::string &more) {
    return make_gear_model("points.prm", pair + torque + "\nend\n" + more, world)
      .contacts.back()
      .options.points_per_facet.number;
  };
  check("points by the width of the contact", count("6400 N m", "") == 5);
  check("at most twelve", count("100 N m", "") == 12);
  check("as many as are given",
        count("800 N m", "subsection Contact\n  set points per facet = 5\nend\n") == 5);
}

void widths(Communicator &world)
{
  const Model        model = make_gear_model("widths.prm", text(), world);
  const OutputFolder folder("widths", world);
  std::ostringstream said;
  Log                log(said, true, Verbosity::normal);
  ContactWidthWatch  watch(folder, model, 10, log);
  State              state;
  state.step = 5;
  check("between samples nothing is looked at", !watch.due(state));
  state.step = 20;
  check("at samples it is", watch.due(state));
  // Of the first pair: widths over forces that rise and fall again.
  for (const auto &[force, width] : {std::make_pair(10., .1), {300., .0625}, {200., .75}})
    {
      ToothContact contact;
      contact.normal_force = force;
      contact.area         = 1e-3;
      contact.width        = width;
      contact.facet_width  = .5;
      state.measured.teeth = {contact};
      watch.observe(model, state);
    }
  watch.finish(model, state);
  check("a warning of the width under the largest force",
        has_text(said.str(), "is 0.0625 mm wide"));
  check("and of that pair alone", said.str().find("wide") == said.str().rfind("wide"));
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {steps, meshes, areas, points, widths});
}
