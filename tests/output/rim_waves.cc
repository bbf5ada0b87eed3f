// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// rim.csv of a turning ring with waves of known amplitudes, about an axis askew.
#include "../made_state.h"
#include "../tests.h"
#include "ring_askew.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/model/body_frame.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/observers/rim_writer.h>

using namespace vfife;

/** The driven gear is a ring of 24 sectors that has turned by 2.5 rad, all of it the rim. */
Model make_model()
{
  Model        model;
  Transmission pair;
  pair.driven         = model.add_body(ring_askew("gear", Material()));
  pair.driven_teeth   = 24;
  pair.driven_rim     = all_nodes(model.bodies[0]);
  model.transmissions = {pair};
  return model;
}

State make_moved_state(const Model &model)
{
  const Matrix3 turn = rotation_about(model.bodies[0].axis.direction, 2.5);
  State state = made_state(model, [&](const Body &ring, const unsigned int i, const Vector3 &) {
    const Vector3 &X     = ring.node_positions()[i];
    const double   alpha = std::atan2(X[1], X[0]);
    // r: 3 um; theta: 2 sin(10 alpha); z: 5 cos(alpha) - 4 sin(3 alpha)
    const Vector3 u =
      1e-3 * Vector3(3, 2 * std::sin(10 * alpha), 5 * std::cos(alpha) - 4 * std::sin(3 * alpha));
    const Vector3 moved = ring.placement.rotation * (X + compute_cylindrical_axes(ring, X) * u);
    return Vector3(ring.axis.point + turn * moved);
  });
  state.body_motion[0].rotation    = turn * model.bodies[0].placement.rotation;
  state.body_motion[0].translation = model.bodies[0].axis.point;
  state.time                       = 1e-3;
  state.step                       = 10;
  return state;
}

int main(int argc, char **argv)
{
  MpiSession   session(argc, argv);
  const Model  model = make_model();
  State        state = make_moved_state(model);
  OutputFolder folder("rim_waves_results", session.world());
  RimWriter    rim(folder, model, 10);
  rim.observe(model, state);
  state.step = 11;
  rim.observe(model, state);
  rim.finish(model, state);
  const Table &table = rim.table();
  check("a row at samples only", table.n_rows() == 1);
  check("time and three components of 21 waves", table.columns().size() == 64);
  // Round-off of coordinates of 30 mm is 1e-11 um; a ring of 24 sectors has waves of 10 diameters.
  for (const Table::Column &column : table.columns())
    {
      const double known = column.name == "time"           ? 1e-3
                           : column.name == "r cos 0"      ? 3
                           : column.name == "theta sin 10" ? 2
                           : column.name == "z cos 1"      ? 5
                           : column.name == "z sin 3"      ? -4
                                                           : 0;
      if (known != 0)
        check_close(column.name, column.numbers[0], known, 1e-10);
      else if (!(std::abs(column.numbers[0]) < 1e-10))
        check_below(column.name, column.numbers[0], 1e-10);
    }
  return 0;
}
