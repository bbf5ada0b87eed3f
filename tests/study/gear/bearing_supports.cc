// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Members of a pair as rigid bodies in their bearings: natural rates, damping ratios and static
// compliance of the lumped model's supports by hand.
#include "../../model_parts.h"
#include "../../parts.h"
#include "../../refusal.h"
#include "../../tests.h"

#include <vfife/bearing/shaft_seat.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/model.h>
#include <vfife/study/gear/bearing_supports.h>

#include <Eigen/LU>

using namespace vfife;

constexpr double length = 60, arm = 80, radial = 2e4, axial = 5e4, tilting = 3e7, damping = 4;

std::shared_ptr<const BearingLaw> law(const double along)
{
  Vector5 k, c;
  k << radial, radial, along, tilting, tilting;
  c << damping, damping, 0., 0., 0.;
  return std::make_shared<LinearBearing>(Matrix5(k.asDiagonal()),
                                         Matrix5(c.asDiagonal()),
                                         Vector5(Vector5::Zero()));
}

/** Two rings with axes askew, @p floating in bearings at both ends of their bores. */
Model make_pair(const std::array<bool, 2> &floating, const double along)
{
  Model model;
  for (unsigned int b = 0; b < 2; ++b)
    {
      Body body(b == 0 ? "pinion" : "gear",
                make_ring(20., b == 0 ? 30. : 50., length, {{2, 24, 4}}),
                Material());
      const Vector3 axis = b == 0 ? Vector3(1., .2, .1) : Vector3(-.1, .3, 1.);
      place_on_axis(body, Vector3(10. * b, 5., 2.), axis);
      body.floats = floating[b];
      model.add_body(std::move(body));
    }
  for (unsigned int b = 0; b < 2; ++b)
    for (const double z : {0., length})
      {
        const Body               &body = model.bodies[b];
        std::vector<unsigned int> ring;
        for (const unsigned int node : body.node_set("inner"))
          if (std::abs(body.node_positions()[node][2] - z) < 1e-9)
            ring.push_back(node);
        if (floating[b])
          model.bearings.push_back({"seat", b, ring, axes_along(body.axis.direction), law(along)});
      }
  Transmission t;
  t.contact_point     = Vector3(40., 30., 70.);
  t.contact_normal    = Vector3(2., -3., 6.) / 7.;
  t.arm               = arm;
  model.transmissions = {t};
  return model;
}

void one_member()
{
  const Model model    = make_pair({{false, true}}, axial);
  const Body &gear     = model.bodies[1];
  const auto  supports = find_bearing_supports(model);
  // Lumped masses of the ring: by its nodes, about the middle.
  double transverse = 0;
  for (unsigned int i = 0; i < gear.n_nodes(); ++i)
    {
      const Vector3 r = gear.node_positions()[i] - Vector3(0., 0., .5 * length);
      transverse += gear.node_masses()[i] * (r[1] * r[1] + r[2] * r[2]);
    }
  const double m     = gear.mass();
  const double shift = std::sqrt(2 * radial / m), along = std::sqrt(2 * axial / m),
               tilt = std::sqrt((2 * radial * length * length / 4 + 2 * tilting) / transverse);
  std::vector<double> expected = {shift, shift, along, tilt, tilt}, found, ratios;
  for (const LumpedSupport &support : supports)
    found.push_back(std::sqrt(support.stiffness / support.inertia));
  std::sort(expected.begin(), expected.end());
  double difference = std::abs(double(found.size()) - 5.);
  for (std::size_t k = 0; k < 5; ++k)
    raise_to(difference, std::abs(found.at(k) / expected[k] - 1.));
  check_below("natural rates of a ring between two bearings", difference, 1e-9);
  for (std::size_t k = 0; k < 5; ++k)
    if (std::abs(found[k] / shift - 1) < 1e-6)
      check_close("damping ratio of a shift",
                  supports[k].damping_ratio,
                  2 * damping / (2 * m * shift),
                  1e-9);
  check("names of the supports", supports[0].name == "gear in bearings 1");

  // What a force F n at the contact point moves there along n, over F: shift, and tilt about the
  // centre of mass.
  const Transmission &t = *model.only_transmission();
  const Vector3       a = gear.axis.direction;
  const Vector3       r = t.contact_point - (gear.axis.point + .5 * length * a),
                moment  = r.cross(t.contact_normal);
  const double n_along  = a.dot(t.contact_normal);
  const double compliance =
    n_along * n_along / (2 * axial) + (1 - n_along * n_along) / (2 * radial) +
    (moment - a.dot(moment) * a).squaredNorm() / (2 * radial * length * length / 4 + 2 * tilting);
  double sum = 0;
  for (const LumpedSupport &support : supports)
    sum += support.lever * support.lever / support.stiffness;
  check_ratio("static compliance at the contact over that by hand",
              sum * arm * arm / compliance,
              1e-9);
}

void two_members()
{
  const auto supports = find_bearing_supports(make_pair({{true, true}}, axial));
  check("five motions of each member", supports.size() == 10);
  check("none with ideal bores", find_bearing_supports(make_pair({{false, false}}, axial)).empty());
  // The transmission has the gear driven: what moves the pinion along n opens the gap.
  const auto opposite = [&](const unsigned int b) {
    Model model = make_pair({{b == 0, b == 1}}, axial);
    std::swap(model.transmissions.front().driver, model.transmissions.front().driven);
    const auto swapped = find_bearing_supports(model),
               own     = find_bearing_supports(make_pair({{b == 0, b == 1}}, axial));
    double difference  = 0;
    for (std::size_t k = 0; k < 5; ++k)
      raise_to(difference, std::abs(swapped[k].lever + own[k].lever));
    return difference;
  };
  check_below("driver and driven: opposite levers", opposite(0) + opposite(1), 1e-12);
}

void refusals()
{
  print_refusal([] { find_bearing_supports(make_pair({{true, true}}, 0.)); });
}

int main()
{
  return run_parts({one_member, two_members, refusals});
}
