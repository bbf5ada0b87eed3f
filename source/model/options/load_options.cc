// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/model/options/load_options.h>

namespace vfife
{
  namespace
  {
    const Choices<LoadKind> load_kinds = {{"force", LoadKind::force},
                                          {"moment", LoadKind::moment},
                                          {"pressure", LoadKind::pressure},
                                          {"acceleration", LoadKind::acceleration}};
  }

  void LoadOptions::declare_kind(dealii::ParameterHandler &prm)
  {
    declare_choice(prm, "kind", kind, load_kinds, "Type of load");
  }

  void LoadOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_kind(prm);
    selection.declare(prm);
    history.declare(prm);
    // Each kind has the entry of its own quantity only: others in its section are refused as
    // unknown.
    if (kind == LoadKind::force)
      declare_vector(prm, "force", vector, "N", "Resultant force with fixed direction in space");
    if (kind == LoadKind::moment)
      declare_vector(prm,
                     "moment",
                     vector,
                     "N mm",
                     "Resultant moment about the centre of the nodes, with fixed direction in "
                     "space; the nodal forces sum to zero");
    if (kind == LoadKind::pressure)
      declare_quantity(prm,
                       "pressure",
                       pressure,
                       "MPa",
                       "Pressure on the deformed faces, positive into the body; follows the faces");
    if (kind == LoadKind::acceleration)
      declare_vector(
        prm, "acceleration", vector, "mm/s^2", "Acceleration as a body force, such as gravity");
  }

  void LoadOptions::add_to(Model &model, const std::string &name, const std::string &section) const
  {
    Load load;
    load.name     = name;
    load.kind     = kind;
    load.body     = selection.find_body(model.bodies, section);
    load.nodes    = selection.find_nodes(model.bodies[load.body], section);
    load.faces    = selection.find_faces(model.bodies[load.body], load.nodes, section);
    load.vector   = vector;
    load.pressure = pressure;
    load.history  = history;
    // Formula or file are read now, so that a mistake is found before anything is computed.
    load.history.check(section);
    model.loads.push_back(load);
  }
} // namespace vfife
