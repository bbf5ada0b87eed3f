// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of the transmission error and the swing of a pair, of made-up displacements of two rings:
// what is put in comes out, in the part where it belongs and with its sign.
#include "../output/whole_partition.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/study/run/deflection_parts.h>
#include <vfife/study/run/pair_preload.h>

#include <functional>

using namespace vfife;

namespace
{
  constexpr double arm = 33, start = 2e-4;

  /** The driven ring stands askew; its bore and its rim are the surfaces. */
  Model make_model()
  {
    Model model;
    model.add_body(Body("pinion", make_ring(10, 20, 6, {{2, 12, 2}}), Material()));
    Body gear("gear", make_ring(20, 40, 5, {{3, 24, 2}}), Material());
    gear.placement.rotation    = rotation_about(Vector3(1., 2., -1.).normalized(), 1.);
    gear.placement.translation = Vector3(7., -5., 3.);
    gear.axis                  = {gear.placement(Vector3::Zero()), gear.placement.rotation.col(2)};
    model.add_body(std::move(gear));
    ContactPair drive;
    drive.slave_body     = 0;
    drive.slave_surface  = "outer";
    drive.master_body    = 1;
    drive.master_surface = "top";
    model.contacts.push_back(drive);
    Transmission t;
    t.driver_teeth     = 12;
    t.driven_teeth     = 24;
    t.driven_sense     = -1;
    t.driven_start     = 3 * start;
    t.driver_start     = 4 * start; // half of it is the gear's
    t.driven_bore      = model.bodies[1].node_set("inner");
    t.driven_rim       = model.bodies[1].node_set("outer");
    t.contact_normal   = Vector3(2., -6., 3.) / 7.;
    t.contact_point    = model.bodies[1].placement(Vector3(30., 10., 5.));
    t.arm              = arm;
    model.transmission = t;
    return model;
  }

  /** Displacements [mm] of bore, rim and all else of the gear, and of the pinion; of the place from
   * a point of the gear's axis. */
  struct Displacements
  {
    using Field = std::function<Vector3(const Vector3 &)>;
    Field   bore, rim, rest;
    Vector3 pinion = Vector3::Zero();
  };

  State make_state(const Model &model, const Displacements &u)
  {
    State       state = undeformed_state(model);
    const Body &gear  = model.bodies[1];
    const auto  move  = [&](const unsigned int node, const Displacements::Field &field) {
      const Vector3 X = gear.placement(gear.node_positions()[node]);
      state.position.set(gear.first_node + node, X + field(X - gear.axis.point));
    };
    for (unsigned int i = 0; i < model.bodies[0].n_nodes(); ++i)
      state.position.set(i, model.bodies[0].node_positions()[i] + u.pinion);
    for (unsigned int i = 0; i < gear.n_nodes(); ++i)
      move(i, u.rest);
    for (const unsigned int i : gear.node_set("inner"))
      move(i, u.bore);
    for (const unsigned int i : gear.node_set("outer"))
      move(i, u.rim);
    return state;
  }

  Displacements::Field turn(const Vector3 &w, const Vector3 &shift = Vector3::Zero())
  {
    return [w, shift](const Vector3 &r) -> Vector3 { return shift + w.cross(r); };
  }

  void check_part(const std::string &name, const double part, const double expected)
  {
    // Small angles: 1e-5 leave 1e-5 of themselves.
    check_close(name, part / expected, 1., 1e-4);
  }

  void parts(const Communicator &communicator)
  {
    const Model         model = make_model();
    const Transmission &t     = *model.transmission;
    const Vector3      &a = model.bodies[1].axis.direction, n = t.contact_normal;
    DeflectionProbe     probe(model, communicator);

    // Spun: both flanks have moved, hub and rim have turned by unlike amounts.
    const Vector3 of_gear(4e-3, 1e-3, -2e-3), of_pinion(-1e-3, 5e-3, 3e-3);
    // The face "top" has nodes of bore and rim as well: all move alike, so that its mean is known.
    State spun = make_state(
      model,
      {turn({0, 0, 0}, of_gear), turn({0, 0, 0}, of_gear), turn({0, 0, 0}, of_gear), of_pinion});
    probe.take_spun(spun);

    // Loaded: the hub turns by -1e-5 about its axis, which is a lead of 1e-5; the rim by -4e-5 and
    // tilts and shifts besides.
    const Vector3 tilt   = 2e-5 * a.unitOrthogonal(), shift(1e-4, -2e-4, 3e-4);
    State         loaded = make_state(
      model,
      {turn(-1e-5 * a), turn(-4e-5 * a + tilt, of_gear + shift), turn({0, 0, 0}), Vector3::Zero()});
    const DeflectionParts parts = probe.take_loaded(loaded);
    // theta_g - (z_p/z_g) theta_p at the start is 3 - 4/2 times that angle.
    check_part("total", parts.total, start + 1e-5);
    check_part("centrifugal shift", parts.centrifugal, n.dot(of_gear - of_pinion) / arm);
    check_part("web windup: lead of the hub before the rim", parts.web_windup, 1e-5 - 4e-5);
    const Vector3 arm_of_tilt = t.contact_point - model.bodies[1].axis.point;
    check_part("rim tilt and shift", parts.rim_tilt, n.dot(shift + tilt.cross(arm_of_tilt)) / arm);
    check_close("teeth: all that is left",
                parts.teeth,
                parts.total - parts.centrifugal - parts.web_windup - parts.rim_tilt,
                1e-18);
    check("parts differ from each other and from nothing",
          std::abs(parts.centrifugal) > 1e-5 && std::abs(parts.rim_tilt) > 1e-6);
  }

  void swing(const Communicator &communicator)
  {
    const Model     model = make_model();
    const Body     &gear  = model.bodies[1];
    const Vector3  &a     = gear.axis.direction;
    DeflectionProbe probe(model, communicator);
    // From 0.9 of 8e5 N mm to all of it the gear turns by 5e-5 on, against the drive (a lag), and
    // the pinion is pushed aside by 1 um.
    const auto at = [&](const double angle, const double aside) {
      const auto field = turn(angle * a);
      return make_state(model, {field, field, field, Vector3(0., aside, 0.)});
    };
    State partly = at(3e-4, 2e-3), loaded = at(3.5e-4, 3e-3);
    probe.take_partly_loaded(partly, 7.2e5);
    const Swing  swing   = probe.compute_swing(loaded, probe.take_loaded(loaded), 8e5);
    const double inertia = gear.axial_inertia() + model.bodies[0].mass() * 1e-6 / (5e-5 * 5e-5);
    check_close("swing: stiffness over dT/psi", swing.stiffness / (8e4 / 5e-5), 1., 1e-6);
    check_close("swing: inertia of the shape", swing.inertia / inertia, 1., 1e-6);
    check_close("swing: frequency [Hz]",
                swing.frequency() / (std::sqrt(8e4 / 5e-5 / inertia) / (2 * pi)),
                1.,
                1e-6);
    check("swing: nothing known", Swing().frequency() == 0);
    // A spring 4e4 N/mm in by 2 um holds 0.08 mJ; under 80 N on an arm of 50 mm, 4000 N mm, it
    // turns the gear by 2e-3/50.
    check_close("lag of the penalty springs [rad]",
                compute_penalty_lag(.08, 4000.),
                2e-3 / 50,
                1e-18);
  }
} // namespace

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  parts(session.world());
  swing(session.world());
}
