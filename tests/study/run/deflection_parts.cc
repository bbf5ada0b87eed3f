// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of the transmission error, stiffness and inertia of the swing of made-up states, and the
// lag of penalty springs under a rigid tilt, each against its closed form.
#include "../../dynamics/one_solver.h"
#include "../../made_state.h"
#include "../../model_parts.h"
#include "../../parts.h"
#include "../../tests.h"

#include <vfife/mesh/body_mesh.h>
#include <vfife/study/run/pair_preload.h>

using namespace vfife;

constexpr double arm = 37., driver_start = 0.2, driven_start = 0.3;

/** Rings of @p scale that stand for a pair with axes askew: the driven one of 20 to 40 mm, its
 * hub the inner radius, its rim what lies beyond 33 mm; flanks are the outer surfaces. */
Model make_pair(const double scale, const double driven_sense)
{
  const auto ring = [&](const char                        *name,
                        const Vector3                     &size,
                        const std::array<unsigned int, 3> &cells,
                        const Vector3                     &axis,
                        const Vector3                     &point) {
    Body body(name,
              make_ring(scale * size[0], scale * size[1], scale * size[2], cells),
              Material());
    place_on_axis(body, scale * point, axis);
    return body;
  };
  Model        model;
  Transmission t;
  t.driver = model.add_body(
    ring("driver", Vector3(10, 15, 6), {{2, 24, 1}}, Vector3(3, -1, 2), Vector3(-4, 55, 2)));
  t.driven = model.add_body(
    ring("driven", Vector3(20, 40, 10), {{4, 48, 2}}, Vector3(1, 2, 2), Vector3(10, -4, 3)));
  const Body &driven = model.bodies[t.driven];
  t.driver_teeth     = 12;
  t.driven_teeth     = 31;
  t.driven_sense     = driven_sense;
  t.driver_sense     = -driven_sense;
  t.driver_start     = driver_start;
  t.driven_start     = driven_start;
  t.driven_bore      = driven.node_set("inner");
  for (unsigned int i = 0; i < driven.n_nodes(); ++i)
    if (driven.node_positions()[i].head<2>().norm() > 33. * scale)
      t.driven_rim.push_back(i);
  // Neither point, normal nor arm belong together: each is seen for itself.
  t.contact_point     = driven.placement(scale * Vector3(28., 28., 7.));
  t.contact_normal    = Vector3(2., -3., 6.) / 7.;
  t.arm               = scale * arm;
  model.transmissions = {t};
  model.contacts.push_back(contact_of("", {t.driver, "outer"}, {t.driven, "outer"}));
  return model;
}

/** What moves: the driver, shifted; of the driven body the hub, turned by an angle about the
 * axis, and the rim, by shift + turn x (x - point of the axis). */
struct Imposed
{
  Vector3 driver_shift = Vector3::Zero();
  double  hub          = 0;
  Vector3 shift = Vector3::Zero(), turn = Vector3::Zero();
};

State move(const Model &model, const Imposed &imposed, const double scale = 1.)
{
  const Body &driven = model.bodies[model.only_transmission()->driven];
  return made_state(model, [&](const Body &body, const unsigned int i, const Vector3 &start) {
    if (&body != &driven)
      return Vector3(start + imposed.driver_shift);
    const Vector3 r      = start - body.axis.point;
    const double  radius = body.node_positions()[i].head<2>().norm() / scale;
    if (radius < 22)
      return Vector3(body.axis.point + rotation_about(body.axis.direction, imposed.hub) * r);
    return radius > 33 ? Vector3(start + imposed.shift + imposed.turn.cross(r)) : start;
  });
}

void parts()
{
  for (const double sense : {1., -1.})
    {
      const std::string   name  = sense > 0 ? "sense +: " : "sense -: ";
      const Model         model = make_pair(1., sense);
      const Transmission &t     = *model.only_transmission();
      const Vector3      &a = model.bodies[t.driven].axis.direction, &n = t.contact_normal;
      Communicator        self(MPI_COMM_SELF);
      DeflectionProbe     probe(model, self);
      // Small against the radii: squares of these over the radius are 1e-5 of them.
      Imposed spun, loaded;
      spun.driver_shift = Vector3(1e-4, 3e-4, -2e-4);
      spun.hub          = 3e-6;
      spun.shift        = Vector3(-4e-4, 1e-4, 2e-4);
      State at_spin     = move(model, spun);
      probe.take_spun(at_spin);
      loaded.driver_shift = Vector3(5e-4, -5e-4, 7e-4);
      loaded.hub          = 17e-6;
      loaded.shift        = Vector3(2e-4, 5e-4, -3e-4);
      loaded.turn         = Vector3(7e-6, -9e-6, 4e-6);
      State at_load       = move(model, loaded);

      const DeflectionParts found = probe.take_loaded(at_load);
      const double          start = driven_start - 12. / 31. * driver_start;
      check_close(name + "total: the hub's lead", found.total, start + sense * 17e-6, 1e-10);
      check_close(name + "centrifugal: (n . u_g - n . u_p)/p of the spun state",
                  found.centrifugal,
                  n.dot(spun.shift - spun.driver_shift) / arm,
                  1e-12);
      // The rim's mean angle is the turn about the axis: shift and tilt have no mean.
      check_close(name + "windup: hub before rim, loaded less spun",
                  found.web_windup,
                  sense * (17e-6 - a.dot(loaded.turn) - 3e-6),
                  1e-9);
      const Vector3 tilt = loaded.turn - a.dot(loaded.turn) * a;
      check_close(name + "tilt and shift: at the mean contact, over the arm",
                  found.rim_tilt,
                  n.dot(loaded.shift - spun.shift +
                        tilt.cross(t.contact_point - model.bodies[t.driven].axis.point)) /
                    arm,
                  1e-11);
      check_close(name + "all parts add up",
                  found.teeth + found.centrifugal + found.web_windup + found.rim_tilt,
                  found.total,
                  1e-15);
    }
}

/** Axial waves of a rim of 48 sectors, turned to any place: A cos(n theta - phase) at the
 * contact, whose tooth follows its sector. Waves 0 and 1 are rigid motions, nine is as short as
 * teeth. */
void rim_bending()
{
  Model model                              = make_pair(1., 1.);
  model.transmissions.front().driven_teeth = 48;
  const Transmission &t                    = *model.only_transmission();
  const Body         &driven               = model.bodies[t.driven];
  Communicator        self(MPI_COMM_SELF);
  constexpr double    amplitude = 1e-3, phase = .7, contact = pi / 4;
  for (const unsigned int waves : {0u, 1u, 2u, 3u, 8u, 9u})
    {
      const auto wave = [&](const double theta) {
        return amplitude * std::cos(waves * theta - phase);
      };
      State spun =
        made_state(model, [](const Body &, unsigned int, const Vector3 &start) { return start; });
      State bent =
        made_state(model, [&](const Body &body, const unsigned int i, const Vector3 &start) {
          const Vector3 &X = body.node_positions()[i];
          return &body != &driven
                   ? start
                   : Vector3(start + wave(std::atan2(X[1], X[0])) * body.axis.direction);
        });
      DeflectionProbe probe(model, self);
      probe.take_spun(spun);
      const DeflectionParts found = probe.take_loaded(bent);
      const double full  = t.contact_normal.dot(driven.axis.direction) / arm * wave(contact);
      const double size  = std::abs(t.contact_normal.dot(driven.axis.direction)) * amplitude / arm;
      const bool   bends = waves >= 2 && waves <= 8;
      // A sector is rigid: of a wave whose nodes are n alpha apart it has that less (n
      // alpha)^2/12.
      check_close("bending with " + std::to_string(waves) + " diameters",
                  probe.rim_bending(),
                  bends ? full : 0.,
                  bends ? size * (std::pow(waves * 2 * pi / 48, 2) / 8 + 1e-3) : 1e-3 * size);
      check_close("all parts add up",
                  found.teeth + found.centrifugal + found.web_windup + found.rim_tilt +
                    probe.rim_bending(),
                  found.total,
                  1e-15);
    }
}

/** Shafts that their bearings let move, and that bend: the seats are the outer surfaces' ends of
 * the driven ring and the inner ones' of the driver. */
void supports()
{
  Model         model = make_pair(1., 1.);
  Transmission &t     = model.transmissions.front();
  t.driver_bore       = model.bodies[t.driver].node_set("outer");
  Vector5 stiffness;
  stiffness << 3e4, 3e4, 2e4, 0., 0.;
  const auto law = std::make_shared<LinearBearing>(Matrix5(stiffness.asDiagonal()),
                                                   Matrix5(Matrix5::Zero()),
                                                   Vector5(Vector5::Zero()));
  for (const unsigned int b : {t.driver, t.driven})
    {
      Body &body  = model.bodies[b];
      body.floats = true;
      for (const double z : {0., b == t.driver ? 6. : 10.})
        {
          std::vector<unsigned int> ring;
          for (const unsigned int node : body.node_set(b == t.driver ? "inner" : "outer"))
            if (std::abs(body.node_positions()[node][2] - z) < 1e-9)
              ring.push_back(node);
          model.bearings.push_back({"seat", b, ring, axes_along(body.axis.direction), law});
        }
    }
  // Rigid motions shift + turn x (x - point of the axis) of the seats, and others of the bores.
  struct Motion
  {
    Vector3 shift, turn;
  };
  const std::array<Motion, 2> seats = {{{{4e-4, 2e-4, -3e-4}, {5e-6, 2e-6, -1e-6}},
                                        {{-2e-4, 6e-4, 1e-4}, {3e-6, -4e-6, 8e-6}}}},
                              bores = {{{{6e-4, 1e-4, -5e-4}, {9e-6, -2e-6, 3e-6}},
                                        {{-5e-4, 7e-4, 3e-4}, {-2e-6, -6e-6, 5e-6}}}};
  const auto at = [&](const Motion &motion, const unsigned int b, const Vector3 &x) {
    return Vector3(motion.shift + motion.turn.cross(x - model.bodies[b].axis.point));
  };
  State rest = made_state(model, [](const Body &, unsigned int, const Vector3 &x) { return x; });
  State bent = made_state(model, [&](const Body &body, const unsigned int i, const Vector3 &x) {
    const unsigned int b      = &body == &model.bodies[0] ? 0 : 1;
    const double       radius = body.node_positions()[i].head<2>().norm();
    const bool         outer  = radius > (b == t.driver ? 12. : 33.);
    return Vector3(x + at(outer == (b == t.driver) ? bores[b] : seats[b], b, x));
  });
  // Their leads at the mean contact, without the turns about the axes.
  const auto lead = [&](const std::array<Motion, 2> &motions) {
    double sum = 0;
    for (const unsigned int b : {t.driver, t.driven})
      {
        Motion         motion = motions[b];
        const Vector3 &a      = model.bodies[b].axis.direction;
        motion.turn -= a.dot(motion.turn) * a;
        sum +=
          (b == t.driven ? 1. : -1.) * t.contact_normal.dot(at(motion, b, t.contact_point)) / arm;
      }
    return sum;
  };
  Communicator    self(MPI_COMM_SELF);
  DeflectionProbe probe(model, self);
  probe.take_spun(rest);
  const DeflectionParts found = probe.take_loaded(bent);
  // Tilts are a x R a: squares of 1e-5.
  check_close("shafts: what the bearings give way", probe.supports().bearings, lead(seats), 1e-10);
  check_close("shafts: bending of the shafts",
              probe.supports().bending,
              lead(bores) - lead(seats),
              1e-10);
  // The rim moves with the seats here, its hub with the bore.
  const std::array<Motion, 2> none = {{{Vector3::Zero(), Vector3::Zero()}, seats[1]}},
                              hub  = {{{Vector3::Zero(), Vector3::Zero()}, bores[1]}};
  check_close("shafts: tilt of the rim from the hub on",
              found.rim_tilt,
              lead(none) - lead(hub),
              1e-10);
  const double driver_turn = model.bodies[0].axis.direction.dot(bores[0].turn),
               driven_turn = model.bodies[1].axis.direction.dot(bores[1].turn);
  check_close("shafts: both hubs' turns in the transmission error",
              found.total - driven_start + 12. / 31. * driver_start,
              driven_turn + 12. / 31. * driver_turn,
              1e-9);
  check_close("shafts: all parts add up",
              found.teeth + found.centrifugal + found.web_windup + found.rim_tilt +
                probe.supports().bearings + probe.supports().bending,
              found.total,
              1e-15);
}

/** What a rim that is tilted shows of its flanks: the mean over a patch about the mean contact.
 */
double tilted_flank(const double scale)
{
  const Model     model = make_pair(scale, 1.);
  Communicator    self(MPI_COMM_SELF);
  DeflectionProbe probe(model, self);
  Imposed         spun;
  spun.turn   = Vector3(7e-6, -9e-6, 4e-6);
  State state = move(model, spun, scale);
  probe.take_spun(state);
  return probe.take_loaded(state).centrifugal;
}

void patch()
{
  const Model         model = make_pair(1., 1.);
  const Transmission &t     = *model.only_transmission();
  const Body         &gear  = model.bodies[t.driven];
  // A linear field's mean is its value at the mean place. 0.42 of the distance 2 pi p/z at which
  // flanks follow each other along the normal.
  const double width  = 0.42 * 2 * pi * arm / 31;
  Vector3      place  = Vector3::Zero();
  double       weight = 0;
  for (const unsigned int node : gear.node_set("outer"))
    {
      const Vector3 x = gear.placement(gear.node_positions()[node]);
      const double  w = std::exp(-(x - t.contact_point).squaredNorm() / (2 * width * width));
      place += w * x;
      weight += w;
    }
  const Vector3 mean = Vector3(7e-6, -9e-6, 4e-6).cross(place / weight - gear.axis.point);
  const double  psi  = t.contact_normal.dot(mean) / arm;
  check_ratio("patch of the flank: its mean displacement", tilted_flank(1.) / psi, 1e-9);
  check_ratio("a gear of a fifth: the same patch of its flank",
              tilted_flank(0.2) / tilted_flank(1.),
              1e-9);
}

void swing()
{
  for (const double sense : {1., -1.})
    {
      const std::string name   = sense > 0 ? "swing, sense +: " : "swing, sense -: ";
      const Model       model  = make_pair(1., sense);
      const Body       &driver = model.bodies[0], &driven = model.bodies[1];
      Communicator      self(MPI_COMM_SELF);
      DeflectionProbe   probe(model, self);
      // The gear turns back as a whole, the driver gives way; the last part takes psi.
      const double  before = 4e-4, psi = 1e-4, torque = 8e5, part = 0.9 * torque;
      const Vector3 yield(1e-3, -2e-3, 2e-3);
      const auto    turned = [&](const double lag, const Vector3 &shift) {
        return made_state(model, [&, lag](const Body &body, unsigned int, const Vector3 &start) {
          if (&body == &driver)
            return Vector3(start + shift);
          const Vector3 &c = body.axis.point;
          return Vector3(c + rotation_about(body.axis.direction, -sense * lag) * (start - c));
        });
      };
      State at_part = turned(before, 3 * yield), at_load = turned(before + psi, 4 * yield);
      probe.take_partly_loaded(at_part, part);
      probe.take_loaded(at_load);
      const Swing found = probe.compute_swing(at_load, torque);
      // Nodes go along chords: 2 sin(psi/2) of their radius. Angles of 1e-4 are differences of
      // coordinates of 40 mm.
      const double stiffness = 0.1 * torque / psi,
                   inertia   = (driven.axial_inertia() * 4 * std::pow(std::sin(psi / 2), 2) +
                              driver.mass() * yield.squaredNorm()) /
                             (psi * psi);
      check_ratio(name + "stiffness", found.stiffness / stiffness, 1e-9);
      check_ratio(name + "inertia, the driver's share with it", found.inertia / inertia, 1e-9);
      check("the driver's share counts",
            driver.mass() * yield.squaredNorm() > 0.01 * inertia * psi * psi);
      check_ratio(name + "frequency",
                  found.frequency() * 2 * pi / std::sqrt(stiffness / inertia),
                  1e-9);
    }
  check("no frequency of a swing that is not known", Swing().frequency() == 0.);
}

/** A block of 5 x 5 mm is pressed, rigid and tilted, into a plate that turns about an axis along
 * y: gaps d = d0 + g x of springs eps hold eps int d^2 dA/2 and push with eps int d (x - c) dA.
 */
void penalty_lag()
{
  constexpr double eps = 2e5, d0 = 1e-3, g = 4e-4, size = 5., axis = -30.;
  Model            model =
    model_of(Body("block", make_block(Vector3(size, size, 2), {{4, 4, 1}}), Material()));
  model.add_body(
    Body("plate", make_block(Vector3(9, 9, 2), {{9, 9, 1}}, Vector3(-2, -2, -2)), Material()));
  Body &block = model.bodies[0], &plate = model.bodies[1];
  // Its lower face goes down by d at x: turned about y.
  block.placement.rotation       = rotation_about(Vector3::UnitY(), std::asin(g));
  block.placement.translation[2] = -d0;
  plate.axis                     = {Vector3(axis, 7., -1.), Vector3::UnitY()};
  Transmission t;
  t.driven_bore              = plate.node_set("z-");
  t.driven_rim               = plate.node_set("z-");
  t.driver_teeth             = 1;
  t.driven_teeth             = 1;
  t.driven_sense             = 1;
  model.transmissions        = {t};
  ContactPair pair           = contact_of("face", "z-", "z+", ContactSurfaceKind::flat_facets);
  pair.options.penalty.value = eps;
  model.contacts.push_back(pair);

  OneSolver run(model, undamped());
  run.solver.measure_at_rest(run.state);
  const double first = size * size * (d0 + g * size / 2),                               // int d dA
    second           = size * (std::pow(d0 + g * size, 3) - std::pow(d0, 3)) / (3 * g), // d^2
    with_x           = size * (d0 * size * size / 2 + g * size * size * size / 3),      // d x
    turning          = with_x - axis * first;
  // Normals are those of the tilted faces: (g, 1) for (0, 1), squares of g and d g beside x - c.
  const Measurements &found = run.state.measured;
  check_ratio("tilt: force over its integral", found.contact_force / (eps * first), 1e-6);
  check_ratio("tilt: torque on the driven over its integral",
              found.contact_torque / (eps * turning),
              1e-4);
  check_close("tilt: deepest point within the deepest edge [mm]",
              found.largest_penetration,
              d0 + g * size,
              0.5 * g);
  check_ratio("tilt: lag of the springs over int d^2 dA / int d (x - c) dA",
              compute_penalty_lag(run.solver.contact().sums().energy(), found.contact_torque) *
                turning / second,
              1e-4);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {parts, rim_bending, supports, patch, swing, penalty_lag});
}
