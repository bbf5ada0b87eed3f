// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Constraints, loads, contacts and probes of a parameter file: what each kind makes of its entries,
// which nodes are chosen, histories; refusals.
#include "../parts.h"
#include "model_text.h"

#include <vfife/base/process/log.h>
#include <vfife/contact/surface/smooth_patch.h>
#include <vfife/model/options/bodies_at_start.h>

using namespace vfife;

/** A constraint of the bar or the ring with these entries. */
std::string constraint(const std::string &entries)
{
  return bar_and_ring("set constraints = hold\n",
                      "subsection Constraint hold\n" + entries + "end\n");
}

Constraint make_constraint(const std::string &entries)
{
  return make_model(constraint(entries)).constraints.at(0);
}

std::string load(const std::string &entries)
{
  return bar_and_ring("set loads = pull\n", "subsection Load pull\n" + entries + "end\n");
}

std::string contact(const std::string &entries)
{
  return bar_and_ring("set contacts = touch\n", "subsection Contact touch\n" + entries + "end\n");
}

std::string probe(const std::string &entries)
{
  return bar_and_ring("set probes = here\n", "subsection Probe here\n" + entries + "end\n");
}

const std::string of_bar = "set body = bar\n", of_ring = "set body = ring\n";

void selection()
{
  const auto count = [](const std::string &entries) {
    return make_constraint(entries).nodes.size();
  };
  check("all nodes", count(of_bar + "set nodes = all\n") == 11 * 5 * 3);
  check("a set", count(of_bar + "set nodes = x-\n") == 15);
  check("two sets, common nodes once", count(of_bar + "set nodes = x-, y+\n") == 15 + 33 - 3);
  check("a condition",
        count(of_bar + "set nodes = all\nset where = abs(y - 2) < 0.1 && x > 5\n") == 5 * 3);
  check("of a set", count(of_bar + "set nodes = z+\nset where = x == 3 || x >= 9.5\n") == 2 * 5);
  check("in the undeformed body frame",
        count(of_ring + "set nodes = bottom\nset where = sqrt(x^2 + y^2) > 29.999\n") == 24);
  const Constraint sorted = make_constraint(of_bar + "set nodes = z+, x+\n");
  check("sorted", std::is_sorted(sorted.nodes.begin(), sorted.nodes.end()));
  check("of the body that is named", make_constraint(of_ring + "set nodes = all\n").body == 1);

  refuse(constraint("set nodes = x-\n"));
  refuse(constraint("set body = rings\nset nodes = all\n"));
  refuse(constraint(of_bar));
  refuse(constraint(of_ring + "set nodes = outher\n"));
  refuse(constraint(of_bar + "set nodes = x-\nset where = x > 1\n"));
  refuse(constraint(of_bar + "set nodes = x-\nset where = x > r\n"));
}

void constraints()
{
  using Kind              = ConstraintKind;
  const std::string nodes = of_ring + "set nodes = inner\n";
  check("fixed", make_constraint(nodes).kind == Kind::held);
  check("free rotation",
        make_constraint(nodes + "set kind = free rotation\n").kind == Kind::free_rotation);
  check("rigid hub", make_constraint(nodes + "set kind = rigid hub\n").kind == Kind::rigid_hub);
  const Constraint turning = make_constraint(nodes + "set kind = turning\n");
  check("turning", turning.kind == Kind::prescribed_rotation && !turning.angle);

  const Model       prescribed = make_model(bar_and_ring("set constraints = turn\n", R"(
  subsection Constraint turn
    set kind    = angle
    set body    = ring
    set nodes   = inner
    set angle   = 30 deg
    set history = sin(100*t)
  end
)"));
  const Constraint &angle      = prescribed.constraints.at(0);
  check("angle", angle.kind == Kind::prescribed_rotation && angle.angle);
  check_close("angle [rad]", *angle.angle, pi / 6, 1e-15);
  check_close("angle: its history", angle.history.value(.01), std::sin(1.), 1e-15);

  const Constraint fixed_axes = make_constraint(
    nodes + "set kind = displacement\nset directions = z, x\nset displacement = 1, 0, 3 um\n");
  check("displacement: along x and z",
        fixed_axes.kind == Kind::directions && !fixed_axes.cylindrical &&
          fixed_axes.prescribed == std::array<bool, 3>{{true, false, true}});
  check_below("displacement [mm]",
              (fixed_axes.displacement - Vector3(.001, 0., .003)).norm(),
              1e-18);
  check_close("without a history: at once", fixed_axes.history.value(0.), 1., 0.);
  const Constraint cylindrical =
    make_constraint(nodes + "set kind = displacement\nset directions = theta\n"
                            "set angle = -0.5 rad\n");
  check("displacement: along theta",
        cylindrical.cylindrical &&
          cylindrical.prescribed == std::array<bool, 3>{{false, true, false}} &&
          cylindrical.displacement == Vector3(0., -.5, 0.));

  const Model springs =
    make_model(constraint(nodes + "set kind = spring\nset stiffness = 1, 0, 2 N/um\n"));
  check("springs are a load",
        springs.constraints.empty() && springs.loads.at(0).kind == LoadKind::spring &&
          springs.loads[0].nodes == springs.bodies[1].node_set("inner") &&
          springs.loads[0].vector == Vector3(1000., 0., 2000.));

  refuse(constraint(nodes + "set kind = displacement\n"));
  refuse(constraint(nodes + "set kind = displacement\nset directions = x, theta\n"));
  // What would be passed over: along directions that are not prescribed, an angle beside x, y, z,
  // theta as a length.
  const std::string along = nodes + "set kind = displacement\nset directions = ";
  refuse(constraint(along + "z, x\nset displacement = 1, 2, 3 um\n"));
  refuse(constraint(along + "theta\nset displacement = 5, 0, 0 mm\n"));
  refuse(constraint(along + "x, y\nset angle = 1 deg\n"));
  refuse(constraint(along + "r, z\nset angle = 1 deg\n"));
  refuse(constraint(along + "r, theta\nset displacement = 0, 1, 0 mm\n"));
  refuse(constraint(nodes + "set kind = spring\nset stiffness = 1, -1, 0\n"));
  refuse(constraint(nodes + "set kind = fixd\n"));
  refuse(constraint(nodes + "set stiffness = 1, 1, 1\n"));
  refuse(constraint(nodes + "set kind = angle\nset history = sin(100*time)\n"));
}

void loads()
{
  const std::string nodes = of_bar + "set nodes = x+\nset where = y < 2.5\n";
  const auto        make  = [&](const std::string &entries) {
    const Load made = make_model(load(nodes + entries)).loads.at(0);
    check(entries.substr(0, entries.find('\n')) + ": nodes", made.nodes.size() == 9);
    return made;
  };
  check("force [N]",
        make("set kind = force\nset force = 1, 2, -3 kN\n").vector ==
          Vector3(1000., 2000., -3000.));
  check("moment [N mm]",
        make("set kind = moment\nset moment = 0, 0, 2 N m\n").vector == Vector3(0., 0., 2000.));
  check_close("pressure [MPa]",
              make("set kind = pressure\nset pressure = 3000 kPa\n").pressure,
              3.,
              1e-14);
  const Model heavy   = make_model(bar_and_ring("set loads = weight\n", R"(
  subsection Load weight
    set kind         = acceleration
    set body         = bar
    set nodes        = x+, x-
    set where        = y < 2.5
    set acceleration = 0, 0, -9.81 m/s^2
    set history      = min(t/0.002, 1)
  end
)"));
  const Load &gravity = heavy.loads.at(0);
  check("acceleration: nodes", gravity.nodes.size() == 18);
  check_below("acceleration [mm/s^2]", (gravity.vector - Vector3(0., 0., -9810.)).norm(), 1e-9);
  check_close("a ramp, half way", gravity.history.value(.001), .5, 1e-15);
  check_close("a ramp, at the end", gravity.history.value(1.), 1., 0.);

  std::ofstream("factors.csv") << "time [s], factor\n0, 0\n0.01, 4\n0.03, -2\n";
  const Load table = make("set kind = force\nset history = factors.csv\n");
  check_ratio("a table, between rows", table.history.value(.02), 1e-14);
  check_close("a table, before it", table.history.value(-1.), 0., 0.);
  check_close("a table, behind it", table.history.value(1.), -2., 0.);

  refuse(load(nodes + "set kind = pressure\nset force = 1, 2, 3\n"));
  refuse(load(nodes + "set kind = weight\n"));
  refuse(load(nodes + "set history = nothing.csv\n"));
  std::ofstream("backwards.txt") << "0 1\n2 3\n1 4\n";
  refuse(load(nodes + "set history = backwards.txt\n"));
}

void contacts()
{
  const std::string bodies = "set slave body = ring\nset slave surface = outer\n"
                             "set master body = bar\nset master surface = x-\n";
  const ContactPair pair =
    make_model(contact(bodies + "set penalty = 2e4\n"
                                "set damping ratio = 0.1\nset edge fading = 0\n"))
      .contacts.at(0);
  check("contact of two bodies",
        pair.side == "touch" && pair.slave_body == 1 && pair.slave_surface == "outer" &&
          pair.master_body == 0 && pair.master_surface == "x-");
  check("its options",
        pair.options.surface == ContactSurfaceKind::smooth_patches &&
          pair.options.penalty.value == 2e4 && pair.options.damping_ratio == .1 &&
          pair.options.edge_fading == 0.);

  FacetSurface corner;
  corner.positions = {Vector3(0, 0, 0),
                      Vector3(2, 0, 0),
                      Vector3(2, 3, 0),
                      Vector3(0, 3, 0),
                      Vector3(2, 0, 4),
                      Vector3(2, 3, 4)};
  corner.facets    = {{{0, 1, 2, 3}}};
  check("one facet has no edge inside", !has_sharp_edges(corner));
  corner.facets.push_back({{1, 4, 5, 2}});
  check("two across a corner have", has_sharp_edges(corner));

  const Model      model = make_model(contact(
    of_bar + "set kind = wall\nset nodes = z-\nset where = x > 8.5\nset wall point = 1, 2, -0.5\n"
                  "set wall normal = 0, 0, 5\nset penalty = 3e4 N/mm^3\n"
                  "set friction coefficient = 0.2\n"
                  "set tangential stiffness ratio = 0.5\n"));
  const RigidWall &wall  = model.walls.at(0);
  check("contact with a wall",
        model.contacts.empty() && wall.name == "touch" && wall.body == 0 &&
          wall.nodes.size() == 10 && wall.point == Vector3(1., 2., -.5) &&
          wall.normal == Vector3(0., 0., 1.));
  check("its penalty", wall.penalty.value == 3e4);

  check("its friction", wall.friction.coefficient == .2 && wall.friction.stiffness_ratio == .5);

  refuse(contact("set slave body = ring\nset slave surface = outer\n"));
  refuse(contact("set slave body = rink\nset slave surface = outer\n"));
  refuse(contact(of_bar + "set kind = wall\nset nodes = z-\n"
                          "set tangential stiffness ratio = 1.5\n"));
  refuse(contact(bodies + "set wall point = 0, 0, 0\n"));
  refuse(contact(bodies + "set edge relief width = 0.1\nset edge relief depth = 0.05\n"));
  refuse(contact(of_bar + "set kind = wall\nset nodes = z-\nset wall normal = 0, 0, 0\n"));
}

void probes()
{
  const Model  model = make_model(probe(of_bar + "set point = 0.0071, 0.0039, 0.0022 m\n"));
  const Probe &here  = model.probes.at(0);
  check("probe: the nearest node",
        here.body == 0 && here.fixed_axes &&
          model.bodies[0].node_positions()[here.node] == Vector3(7., 4., 2.));
  check("probe: axes of the body",
        !make_model(probe(of_bar + "set axes = r, theta, z\n")).probes[0].fixed_axes);
  refuse(probe(of_bar + "set axes = r, z\n"));
  refuse(probe("set point = 0, 0, 0\n"));
  check("probe: within an element's edge of the body",
        make_model(probe(of_bar + "set point = 10.9, 2, 2 mm\n")).probes[0].node ==
          make_model(probe(of_bar + "set point = 10, 2, 2 mm\n")).probes[0].node);
  refuse(probe(of_bar + "set point = 11.1, 2, 2 mm\n"));
  refuse(probe(of_ring + "set point = 0, 0, 0\n")); // in the hole
  refuse(bar_and_ring("set probes = here\n", "subsection Probe there\nend\n"));
}

/** Two blocks of 10 mm, the second one at @p place, and the contact @p entries. */
std::string two_blocks(const std::string &place, const std::string &entries)
{
  return "subsection Model\nset bodies = a, b\nset contacts = touch\n" +
         model_text::block("a", {{10, 10, 10}}, {{2, 2, 2}}) +
         model_text::block("b", {{10, 10, 10}}, {{2, 2, 2}}, "set position = " + place + "\n") +
         "subsection Contact touch\n" + entries + "end\nend\n";
}

/** What is said of the start. */
std::string start(const std::string &text)
{
  std::ostringstream screen;
  Log                log(screen, true);
  check_start(make_model(text), log);
  return screen.str();
}

void refuse_start(const std::string &text)
{
  print_refusal([&] { start(text); });
}

void starts()
{
  const std::string faces =
    "set slave body = a\nset slave surface = x+\nset master body = b\nset master surface = x-\n";
  check("bodies apart", start(two_blocks("10.1, 0, 0", faces)).empty());
  check("bodies that touch", start(two_blocks("10, 0, 0", faces)).empty());
  check("bodies a little inside each other", start(two_blocks("8, 0, 0", faces)).empty());
  check("bodies side by side", start(two_blocks("0, 10, 0", faces)).empty());
  check("where contact looks deeper",
        start(two_blocks("5, 0, 0", faces + "set contact depth limit = 6 mm\n")).empty());
  refuse_start(two_blocks("5, 0, 0", faces));
  // Through each other, so that the surfaces of the contact are out again.
  std::cout << start(two_blocks("-2, 0.1, 0.2", faces));
  // One wholly inside the other.
  refuse_start("subsection Model\nset bodies = a, b\nset contacts = touch\n" +
               model_text::block("a", {{2, 2, 2}}, {{1, 1, 1}}, "set position = 4, 4, 4 mm\n") +
               model_text::block("b", {{10, 10, 10}}, {{3, 3, 3}}) + "subsection Contact touch\n" +
               faces + "end\nend\n");

  const auto wall = [](const std::string &entries) {
    return two_blocks("30, 0, 0", "set kind = wall\nset body = a\nset nodes = z-\n" + entries);
  };
  check("on a wall", start(wall("set wall normal = 0, 0, 1\n")).empty());
  check("partly behind a wall",
        start(wall("set wall normal = 0, 0, 1\nset wall point = 0, 0, 4\n")).empty());
  std::cout << start(wall("set wall normal = 0, 0, 1\nset wall point = 0, 0, 4\n"
                          "set penalty = 100\n"));
  refuse_start(wall("set wall normal = 0, 0, -1\n"));
  refuse_start(wall("set wall normal = 0, 0, 1\nset wall point = 0, 0, 12\n"));
}

int main()
{
  return run_parts({selection, constraints, loads, contacts, probes, starts});
}
