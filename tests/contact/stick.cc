// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Friction that sticks elastically, between rigid surfaces that are moved as is told: closed forms
// of spring and slider, work of a cycle, rigid motions of the pair, what is kept and what is
// forgotten.
#include "../parts.h"
#include "../tests.h"
#include "surfaces.h"

#include <Eigen/Geometry>

#include <sstream>

using namespace test_surfaces;

constexpr double depth = 0.002, penalty = 1e4, mu = 0.3, ratio = 0.8, side = 4.; // [mm], [N/mm^3]
constexpr double area = side * side, normal_force = penalty * depth * area;
constexpr double k             = ratio * penalty * area,
                 elastic_limit = mu * normal_force / k; // [N/mm], [mm]

ContactOptions make_options()
{
  ContactOptions options;
  options.surface                  = ContactSurfaceKind::flat_facets;
  options.depth_limit              = 0.2;
  options.search_skin              = 0.05;
  options.penalty.value            = penalty;
  options.friction.coefficient     = mu;
  options.friction.stiffness_ratio = ratio;
  return options;
}

/** A plate of 4 mm, pressed 2 um deep, on a plate of 20 mm. */
struct Plates
{
  MovingSurface slave, master;
  Contact       contact;

  explicit Plates(const ContactOptions &options = make_options())
    : slave(plane(3, 3, -0.5 * side, 0.5 * side, -0.5 * side, 0.5 * side, 0., true))
    , master(plane(7, 9, -10., 10., -10., 10., 0.))
    , contact(slave.surface, master.surface, options)
  {
  }

  /** Force on the slave that is moved by @p way over the master, both then by @p common. */
  Vector3
  move(const Vector3 &way, const RigidMotion &common = {}, const PointShare &share = PointShare())
  {
    RigidMotion over = common;
    over.translation = common(way - depth * Vector3::UnitZ());
    slave.place(over);
    master.place(common);
    slave.clear_forces();
    master.clear_forces();
    contact.find_candidates(slave.body, master.body, 1.);
    contact.set_shares({share});
    add_forces(contact, slave, master, 1e-7);
    return slave.force();
  }

  double energy() const
  {
    return contact.results().at(0).energy;
  }
  double loss() const
  {
    return contact.results().at(0).friction_loss;
  }
};

void spring_and_slider()
{
  Plates plates;
  // 1. Sticks: traction zero at first, then k times the way, to the last digits.
  check_below("comes to stick without traction", plates.move({0., 0., 0.})[0], 1e-12);
  const Vector3 half = plates.move({0.3 * elastic_limit, -0.4 * elastic_limit, 0.});
  check_close("sticks: along x, over k u", half[0] / (k * 0.3 * elastic_limit), -1., 1e-9);
  check_ratio("sticks: along y, over k u", half[1] / (k * 0.4 * elastic_limit), 1e-9);
  check_ratio("normal force as without friction", half[2] / normal_force, 1e-12);
  check_ratio("stored energy",
              plates.energy() /
                (0.5 * normal_force * depth + 0.5 * k * std::pow(0.5 * elastic_limit, 2)),
              1e-9);
  check_close("nothing is lost", plates.loss(), 0., 0.);
  check_below("comes back without traction", plates.move({0., 0., 0.}).head<2>().norm(), 1e-9);
  // 2. Slides with mu N, whatever the way, over facets of the master.
  double largest = 0.;
  for (unsigned int i = 1; i <= 100; ++i)
    {
      const Vector3 force = plates.move({0.06 * i, 0.03 * i, 0.});
      largest             = std::max(largest,
                         (force - mu * normal_force * Vector3(-2., -1., 0.) / std::sqrt(5.) -
                          normal_force * Vector3::UnitZ())
                           .norm());
    }
  check_below("slides: deviation from mu N over N", largest / normal_force, 1e-9);
  check("many wide searches on the way", plates.contact.n_wide_searches() > 20);
  // 3. Lets go: pressed anew, there is no traction.
  plates.move({6., 3., 0.01});
  check_ratio("the spring's energy is lost when it opens",
              plates.loss() / (0.5 * k * elastic_limit * elastic_limit),
              1e-9);
  check_below("pressed anew without traction", plates.move({6.01, 3., 0.}).head<2>().norm(), 1e-9);
}

void cycle()
{
  // Forth and back four times the elastic limit: work by the trapezoidal rule, as central
  // differences do it, against energies and losses, step by step and over the cycle.
  Plates       plates;
  const double far    = 4. * elastic_limit;
  Vector3      before = plates.move({0., 0., 0.}), place = Vector3::Zero();
  double       work = 0., loss = 0., largest = 0., stored = plates.energy();
  const double at_start = stored;
  double       of_cycle = 0.;
  for (unsigned int i = 1; i <= 5 * 64; ++i)
    {
      // 0 to far, then to -far and back, and again: triangles of 64 steps a quarter.
      const double  t    = i / 64.;
      const double  x    = t <= 1. ? t : t <= 3. ? 2. - t : t - 4.;
      const Vector3 next = {far * x, 0., 0.};
      const Vector3 now  = plates.move(next);
      work += 0.5 * (before + now).dot(next - place);
      loss += plates.loss();
      stored = plates.energy();
      largest =
        std::max(largest, std::abs(work + loss + stored - at_start) / (mu * normal_force * far));
      before = now;
      place  = next;
      if (i == 64)
        of_cycle = -loss;
      if (i == 5 * 64)
        of_cycle += loss;
    }
  check_below("work + losses + stored energy, over mu N times the way", largest, 1e-9);
  // A slider of 2 mu N behind the spring: each way 2 (far - elastic limit).
  check_ratio("loss of a cycle over 4 mu N (way - elastic limit)",
              of_cycle / (4. * mu * normal_force * (far - elastic_limit)),
              1e-9);
}

void rigid_motion()
{
  for (const Vector3 &axis : {Vector3(0., 0., 1.), Vector3(0.6, 0., 0.8), Vector3(1., 0., 0.)})
    {
      Plates        plates;
      const Vector3 way(0.7 * elastic_limit, 0., 0.);
      plates.move({0., 0., 0.});
      const Vector3 first  = plates.move(way);
      const double  stored = plates.energy();
      double        error = 0., moment = 0., energy = 0., loss = 0.;
      for (unsigned int degree = 1; degree <= 90; ++degree)
        {
          RigidMotion common;
          common.rotation    = Eigen::AngleAxisd(degree * pi / 180., axis).toRotationMatrix();
          common.translation = 0.5 * degree * Vector3(1., 0.3, -0.2);
          const Vector3 now  = plates.move(way, common);
          error  = std::max(error, (now - common.rotation * first).norm() / first.norm());
          moment = std::max(moment,
                            (plates.slave.moment() + plates.master.moment()).norm() /
                              (100. * normal_force));
          energy = std::max(energy, std::abs(plates.energy() / stored - 1.));
          loss += plates.loss();
        }
      std::ostringstream name;
      name << "a sticking pair turns by 90 degrees about " << axis.transpose() << ": ";
      check("tangential part", first.head<2>().norm() > 0.2 * normal_force * 0.7);
      // Round-off of coordinates of 50 mm against an elastic displacement of 0.5 um.
      check_below(name.str() + "traction turns along", error, 1e-9);
      check_below(name.str() + "energy", energy, 1e-9);
      check_close(name.str() + "loss", loss, 0., 0.);
      check_below(name.str() + "balance of moments", moment, 1e-12);
    }
}

void keeping()
{
  // 1. Shares of ranks have the history of their points; anchors of all of them are a checkpoint.
  Plates                     whole, first, second;
  std::vector<AnchorOfPoint> anchors;
  const Vector3              places[] = {{0., 0., 0.}, {5. * elastic_limit, 0., 0.}};
  for (const Vector3 &place : places)
    {
      whole.move(place);
      first.move(place, {}, {0, 2});
      second.move(place, {}, {1, 2});
    }
  for (const Plates *plates : {&first, &second})
    {
      const auto some = plates->contact.anchors();
      anchors.insert(anchors.end(), some.begin(), some.end());
    }
  Plates resumed;
  resumed.contact.restore_anchors(anchors);
  // Before the first forces they are a checkpoint again.
  check("anchors that are not used yet are kept",
        !anchors.empty() && resumed.contact.has_restored_anchors() &&
          resumed.contact.anchors().size() == anchors.size());
  AnchorOfPoint other = anchors.front();
  other.anchor.facet += 1000;
  check("anchors of these surfaces and of others",
        resumed.contact.has_place(anchors.front()) && !resumed.contact.has_place(other));
  const Vector3 on(4.8 * elastic_limit, 0.1 * elastic_limit, 0.);
  const Vector3 expected = whole.move(on);
  check_below("shares of two ranks",
              (first.move(on, {}, {0, 2}) + second.move(on, {}, {1, 2}) - expected).norm(),
              1e-9);
  check_below("gone on with the anchors of two ranks on one",
              (resumed.move(on) - expected).norm(),
              1e-9);
  check("they are used", !resumed.contact.has_restored_anchors());
  check("they pull", expected.head<2>().norm() > 0.5 * mu * normal_force);

  // 2. Held: the same place has the same force, whatever was looked at before, and lets nothing
  // slide until it is taken.
  Plates held;
  held.move({0., 0., 0.});
  held.contact.set_friction_mode(FrictionMode::held);
  const Vector3 there = held.move(on);
  held.move({-20. * elastic_limit, 3. * elastic_limit, 0.});
  held.move({0., 0., 0.02}); // open
  check_below("held: the same place has the same force", (held.move(on) - there).norm(), 1e-9);
  check_close("held: nothing is lost", held.loss(), 0., 0.);
  held.contact.set_friction_mode(FrictionMode::follows);
  check_below("taken: the same force", (held.move(on) - there).norm(), 1e-9);
  check("taken: lost", held.loss() > 0.);

  // 3. None.
  Plates none;
  none.contact.set_friction_mode(FrictionMode::none);
  none.move({0., 0., 0.});
  check_below("none: normal force alone", none.move(on).head<2>().norm(), 1e-12);
}

int main()
{
  return run_parts({spring_and_slider, cycle, rigid_motion, keeping});
}
