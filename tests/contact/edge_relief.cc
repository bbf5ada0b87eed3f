// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Relief of edges: its shape, forces as the slope of the energy, points that cross an edge.
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"
#include "surfaces.h"

#include <vfife/contact/surface/edge_relief.h>

using namespace test_surfaces;

constexpr double penalty = 1e5;

ContactOptions options_for(const double width, const double depth)
{
  ContactOptions options;
  options.penalty.value     = penalty;
  options.depth_limit       = 0.5;
  options.edge_fading       = 0.; // the relief alone
  options.edge_relief_width = width;
  options.edge_relief_depth = depth;
  return options;
}

/** Numbers the borders of a surface in the plane: y = high "tip" 1, ends 2 and 3, none at low y.
 */
void number_edges(FacetSurface &surface, const double x0, const double x1, const double tip)
{
  surface.edges.assign(surface.facets.size(), {{0, 0, 0, 0}});
  for (unsigned int f = 0; f < surface.facets.size(); ++f)
    for (unsigned int side = 0; side < 4; ++side)
      {
        const Vector3 middle   = 0.5 * (surface.positions[surface.facets[f][side]] +
                                      surface.positions[surface.facets[f][(side + 1) % 4]]);
        surface.edges[f][side] = std::abs(middle[1] - tip) < 1e-9  ? 1
                                 : std::abs(middle[0] - x0) < 1e-9 ? 2
                                 : std::abs(middle[0] - x1) < 1e-9 ? 3
                                                                   : 0;
      }
}

void check_shape()
{
  // facets of 2 x 0.5 mm: the width reaches over two rows and half a column
  std::mt19937 random(5);
  FacetSurface surface = plane(3, 4, 0., 6., 0., 2., 0.);
  turn_facets(surface, random);
  number_edges(surface, 0., 6., 2.);
  const double     width = 0.9, depth = 0.02;
  const EdgeRelief relief(surface, options_for(width, depth));
  const auto       ramp = [=](const double d) {
    return d < width ? depth * (1. - d / width) * (1. - d / width) : 0.;
  };
  double deviation = 0., slope_deviation = 0., largest = 0.;
  for (unsigned int f = 0; f < surface.facets.size(); ++f)
    for (unsigned int i = 0; i <= 100; ++i)
      {
        const double xi = 0.1 * (i % 10), eta = 0.1 * (i / 10), h = 1e-6;
        const auto   N = bilinear_weights(xi, eta);
        Vector3      x = Vector3::Zero();
        for (unsigned int k = 0; k < 4; ++k)
          x += N[k] * surface.positions[surface.facets[f][k]];
        const double expected = ramp(2. - x[1]) + ramp(x[0]) + ramp(6. - x[0]);
        const double value    = relief.value(f, xi, eta);
        raise_to(largest, value);
        raise_to(deviation, std::abs(value - expected));
        const auto   slope = relief.gradient(f, xi, eta);
        const double by_xi =
          (relief.value(f, xi + h, eta) - relief.value(f, xi - h, eta)) / (2. * h);
        const double by_eta =
          (relief.value(f, xi, eta + h) - relief.value(f, xi, eta - h)) / (2. * h);
        slope_deviation =
          largest_of({slope_deviation, std::abs(slope[0] - by_xi), std::abs(slope[1] - by_eta)});
      }
  check_below("relief of a plane: deviation from the sum over its edges [mm]", deviation, 1e-15);
  check_close("relief at a corner of two edges [mm]", largest, 2. * depth, 1e-15);
  check("the largest is known", relief.largest() >= largest);
  // the second derivative jumps at the width: h times 2 depth (facet/width)^2
  check_below("slopes against differences [mm]", slope_deviation, 1e-6);

  check("no depth, no relief", EdgeRelief(surface, options_for(0.9, 0.)).empty());
  surface.edges.clear();
  const EdgeRelief all(surface, options_for(width, depth));
  double           low = 0.;
  for (unsigned int f = 0; f < surface.facets.size(); ++f)
    raise_to(low, all.value(f, 0.5, 0.5));
  // A corner facet of 0.5 mm has three corners on the border, so its centre is at a quarter of
  // that.
  check_close("without numbers the whole border is one edge [mm]", low, ramp(0.125), 1e-15);
}

void check_refusal()
{
  check("a relief deeper than a tenth of its width is refused",
        entry_and_message_of([] {
          options_for(0.5, 0.051).check("Contact");
        }).find("Contact/edge relief depth: ") == 0);
  options_for(0.5, 0.05).check("Contact");
}

struct Bodies
{
  MovingSurface slave, master;
  Contact       contact;

  Bodies(const FacetSurface &s, const FacetSurface &m, const ContactOptions &options)
    : slave(s)
    , master(m)
    , contact(s, m, options)
  {
  }

  /** Forces at the positions; returns the energy. */
  double compute()
  {
    contact.find_candidates(slave.body, master.body, 1.);
    slave.clear_forces();
    master.clear_forces();
    add_forces(contact, slave, master);
    return contact.results().empty() ? 0. : contact.results()[0].energy;
  }
};

/** Forces against differences of the energy as the slave is shifted in x, y and z. */
double shift_error(Bodies &bodies, const RigidMotion &place)
{
  bodies.slave.place(place);
  bodies.compute();
  const Vector3 force = bodies.slave.force();
  Vector3       slope;
  for (unsigned int i = 0; i < 3; ++i)
    {
      const double h = 1e-5;
      double       energy[2];
      for (unsigned int k = 0; k < 2; ++k)
        {
          RigidMotion moved = place;
          moved.translation[i] += k == 0 ? h : -h;
          bodies.slave.place(moved);
          energy[k] = bodies.compute();
        }
      slope[i] = -(energy[0] - energy[1]) / (2. * h);
    }
  return (force - slope).norm() / force.norm();
}

void check_gradient()
{
  std::mt19937                           random(3);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  const ContactOptions                   options = options_for(0.8, 0.03);
  {
    FacetSurface master = plane(3, 4, -3., 3., -1., 1., 0.);
    number_edges(master, -3., 3., 1.);
    Bodies      bodies(plane(3, 3, -0.4, 0.4, -0.4, 0.4, -0.05, true), master, options);
    double      worst = 0., tangential = 0.;
    RigidMotion place;
    for (unsigned int i = 0; i < 20; ++i)
      {
        place.translation = Vector3(2.7 + 0.2 * uniform(random), 0.8 + 0.2 * uniform(random), 0.);
        raise_to(worst, shift_error(bodies, place));
        bodies.slave.place(place);
        bodies.compute();
        const Vector3 f = bodies.slave.force();
        raise_to(tangential, std::hypot(f[0], f[1]) / f[2]);
      }
    // Second derivatives jump where a point comes under the relief or under pressure; points that
    // leave the border at a relief below the depth jump: the slave's own relief keeps them open.
    check_below("plane, edges and corner: force against differences of the energy", worst, 1e-4);
    check("with a force along the plane", tangential > 0.01);
  }
  {
    Bodies      bodies(sphere_patch_down(30., 0.1, 10), sphere_patch(50., 0.25, 10), options);
    double      worst = 0.;
    RigidMotion place;
    for (unsigned int i = 0; i < 20; ++i)
      {
        // the border of the master stands at an angle of 0.245 from the pole
        place.rotation = rotation_about(Vector3::UnitY(), 0.235 + 0.008 * uniform(random)) *
                         rotation_about(Vector3::UnitX(), 0.1 * uniform(random));
        place.translation = place.rotation * Vector3(0., 0., 80. - 0.01);
        raise_to(worst, shift_error(bodies, place));
      }
    check_below("spheres at the border: force against differences of the energy", worst, 1e-3);
  }
}

/** A slave facet leaves the plane over its tip: penetration 4 um, relief 10 um over 0.4 mm. */
void check_crossing()
{
  const double depth = 0.01, width = 0.4, penetration = 0.004;
  FacetSurface master = plane(2, 2, -1., 1., 1., 3., 0.);
  number_edges(master, -1., 1., 3.);
  FacetSurface slave = plane(1, 1, -0.1, 0.1, -0.001, 0.001, -penetration, true);
  slave.edges.assign(1, {{0, 0, 0, 0}});
  for (const bool relieved : {true, false})
    {
      ContactOptions options          = options_for(relieved ? width : 0., relieved ? depth : 0.);
      options.points_per_facet.number = 1;
      Bodies       bodies(slave, master, options);
      const double full = penalty * penetration * 4e-4, move = 2e-4;
      double       step = 0., deviation = 0., last = full;
      for (unsigned int i = 0; i <= 4000; ++i)
        {
          RigidMotion motion;
          motion.translation[1] = 2.4 + move * i;
          bodies.slave.place(motion);
          bodies.compute();
          const double force = bodies.slave.force()[2] / full;
          const double d     = 3. - motion.translation[1];
          const double t     = std::max(0., 1. - d / width);
          const double gap   = depth * t * t - penetration;
          if (relieved)
            raise_to(deviation, std::abs(force - (d > 0. ? std::max(0., -gap / penetration) : 0.)));
          raise_to(step, std::abs(force - last / full));
          last = force * full;
        }
      const std::string name = relieved ? "relieved tip" : "sharp tip";
      if (relieved)
        {
          check_below(name + ": force is that of the relieved gap", deviation, 1e-10);
          check_below(name + ": largest step of the force",
                      step,
                      2. * depth / width * move / penetration);
        }
      else
        check_ratio(name + ": the force jumps", step, 1e-12);
    }
}

void check_off()
{
  ContactOptions with       = options_for(0.5, 0.), without;
  without                   = with;
  without.edge_relief_width = 0.;
  const auto slave = sphere_patch_down(30., 0.1, 10), master = sphere_patch(50., 0.25, 10);
  std::vector<Vector3> forces;
  for (const ContactOptions &options : {with, without})
    {
      Bodies      bodies(slave, master, options);
      RigidMotion place;
      place.translation[2] = 80. - 0.02;
      bodies.slave.place(place);
      bodies.compute();
      forces.push_back(bodies.slave.force());
    }
  check("without depth nothing changes", forces[0] == forces[1] && forces[0][2] > 0.);
}

int main()
{
  return run_parts({check_shape, check_refusal, check_gradient, check_crossing, check_off});
}
