// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Constraints that share a node: rank and span of what they hold, the displacement that meets all
// of them, shares of a force; what contradicts itself.
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/constraints/node_constraints.h>

using namespace vfife;

/** A ring about an oblique axis. */
Body make_body()
{
  Body body("ring", make_ring(20., 30., 6., {{2, 24, 1}}), Material());
  body.placement.rotation    = rotation_about(Vector3(2., -1., 2.).normalized(), .8);
  body.placement.translation = Vector3(7., 1., -3.);
  body.axis                  = {body.placement(Vector3::Zero()), body.placement.rotation.col(2)};
  return body;
}

Constraint lead(const std::string         &name,
                const bool                 cylindrical,
                const std::array<bool, 3> &prescribed,
                const Vector3             &displacement)
{
  Constraint constraint;
  constraint.name         = name;
  constraint.kind         = ConstraintKind::directions;
  constraint.cylindrical  = cylindrical;
  constraint.prescribed   = prescribed;
  constraint.displacement = displacement;
  return constraint;
}

Constraint of_kind(const std::string &name, const ConstraintKind kind)
{
  Constraint constraint;
  constraint.name = name;
  constraint.kind = kind;
  return constraint;
}

double full(const Constraint &)
{
  return 1.;
}

void oblique()
{
  const Body       body = make_body();
  const Vector3    arm = Vector3(20., 0., 4.), place = body.placement(arm);
  const Vector3    e_r    = body.placement.rotation.col(0);
  const Constraint radius = lead("radius", true, {{true, false, false}}, Vector3(.03, 0., 0.)),
                   plane  = lead("plane", false, {{false, true, false}}, Vector3(0., -.05, 0.)),
                   third  = lead("third", false, {{true, false, true}}, Vector3(.02, 0., .04));
  NodeConstraints node(body, place);
  node.add(radius);
  node.add(plane);
  check("oblique: two directions", node.n_held() == 2);
  const Vector3 u = node.compute_displacement(full);
  check_close("oblique: radius [mm]", e_r.dot(u), .03, 1e-15);
  check_close("oblique: y [mm]", u[1], -.05, 1e-15);
  const Matrix3 axes = node.axes();
  check_below("oblique: axes are orthonormal",
              (axes.transpose() * axes - Matrix3::Identity()).norm(),
              1e-15);
  check_below("oblique: the free axis is across, as is the displacement",
              std::abs(e_r.dot(axes.col(2))) + std::abs(axes(1, 2)) + std::abs(u.dot(axes.col(2))),
              1e-15);
  // A third constraint holds x and z: with y all, and the radius depends on them.
  NodeConstraints all(body, place);
  all.add(plane);
  all.add(third);
  all.add(radius);
  check("three directions: held altogether", all.n_held() == 3 && all.independent().size() == 3);
  check("four equations: values are to be compared", all.has_values_to_compare());
  print_refused_entry([&] { all.compute_displacement(full); });
  // What agrees: a radius that follows from x, y, z.
  const Constraint agreeing = lead("agreeing",
                                   true,
                                   {{true, false, false}},
                                   Vector3(e_r.dot(Vector3(.02, -.05, .04)), 0., 0.));
  NodeConstraints  same(body, place);
  for (const Constraint *constraint : {&agreeing, &plane, &third})
    same.add(*constraint);
  check_below("an agreeing radius [mm]",
              (same.compute_displacement(full) - Vector3(.02, -.05, .04)).norm(),
              1e-14);
}

void nearly_parallel()
{
  // The corner of a mesh file: a millionth of a radian off the plane is on it.
  const Body       body{"block", make_block(Vector3(1., 1., 1.), {{1, 1, 1}}), Material()};
  const Constraint radius = lead("radius", true, {{true, false, false}}, Vector3(.01, 0., 0.)),
                   plane  = lead("plane", false, {{false, true, false}}, Vector3(0., .01, 0.));
  for (const double off : {5e-5, .05})
    {
      NodeConstraints node(body, Vector3(off, 50., 0.));
      node.add(plane);
      node.add(radius);
      check(off < 1e-3 ? "parallel: one direction" : "a thousandth: two directions",
            node.n_held() == (off < 1e-3 ? 1 : 2));
      check_close("y [mm]", node.compute_displacement(full)[1], .01, 1e-15);
    }
}

void axis()
{
  const Body       body   = make_body();
  const Vector3    centre = body.placement(Vector3(1e-13, 0., 2.));
  const Constraint radius = lead("radius", true, {{true, false, false}}, Vector3::Zero()),
                   grown  = lead("grown", true, {{true, false, false}}, Vector3(1., 0., 0.));
  NodeConstraints node(body, centre);
  node.add(radius);
  check("on the axis both ways across are held", node.n_held() == 2);
  check_ratio("and the free one is the axis",
              std::abs(node.axes().col(2).dot(body.axis.direction)),
              1e-14);
  print_refused_entry([&] { node.add(grown); });
}

void refuse(const Body &body, const std::vector<Constraint> &constraints)
{
  NodeConstraints node(body, body.placement(Vector3(20., 0., 0.)));
  for (const Constraint &constraint : constraints)
    node.add(constraint);
  print_refusal([&] { node.check(); });
}

void kinds()
{
  Body body              = make_body();
  body.rate              = 10;
  const Constraint fixed = of_kind("fixed", ConstraintKind::held),
                   drive = of_kind("drive", ConstraintKind::prescribed_rotation),
                   hub   = of_kind("hub", ConstraintKind::rigid_hub),
                   bore  = of_kind("bore", ConstraintKind::free_rotation),
                   z     = lead("z", true, {{false, false, true}}, Vector3::Zero()),
                   theta = lead("theta", true, {{false, true, false}}, Vector3::Zero());
  const Vector3   place  = body.placement(Vector3(20., 0., 0.));
  NodeConstraints turning(body, place);
  for (const Constraint *constraint : {&z, &bore, &hub})
    turning.add(*constraint);
  turning.check();
  check("a hub with radius and axial position twice turns", turning.turning() == &hub);
  NodeConstraints driven(body, place);
  for (const Constraint *constraint : {&drive, &bore, &z})
    driven.add(*constraint);
  driven.check();
  check("a bore that is driven does not turn freely",
        driven.n_held() == 3 && driven.turning() == nullptr);
  // A body that turns is not held; at rest it may be.
  refuse(body, {fixed, drive});
  refuse(body, {drive, theta});
  refuse(body, {hub, theta});
  refuse(body, {hub, of_kind("other hub", ConstraintKind::rigid_hub)});
  body.rate = 0;
  NodeConstraints resting(body, place);
  resting.add(fixed);
  resting.add(drive);
  resting.check();
  check("at rest both hold", resting.n_held() == 3);
}

void shares()
{
  Eigen::Matrix3Xd directions(3, 3);
  directions << 1., 1., 0., //
    0., 0., .6,             //
    0., 0., .8;
  const Eigen::VectorXd shares = share_force(directions, Vector3(4., 3., 4.));
  check_below("a force: equal directions share alike, the third has its own",
              (shares - Vector3(2., 2., 5.)).norm(),
              1e-14);
  check_below("what nothing carries is left out",
              share_force(directions, Vector3(0., .8, -.6)).norm(),
              1e-14);
}

int main()
{
  return run_parts({oblique, nearly_parallel, axis, kinds, shares});
}
