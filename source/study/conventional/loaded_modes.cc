// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/fem/pair/coupled_modes.h>
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/fem/statics/compliance.h>
#include <vfife/model/model.h>
#include <vfife/output/files/mode_writer.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/study/conventional/field_grid.h>
#include <vfife/study/conventional/loaded_modes.h>
#include <vfife/study/turning_axes.h>

namespace vfife
{
  void write_loaded_modes(const Model                 &model,
                          const Compliance            &compliance,
                          const PairEquilibriumResult &result,
                          const LoadedModes           &what,
                          const OutputFolder          &folder,
                          Log                         &log)
  {
    // The points under pressure become springs; shapes are small vibrations about this position.
    const CoupledModes modes = find_coupled_modes(compliance,
                                                  what.fem,
                                                  what.spins,
                                                  result.ties,
                                                  result.bearing_tangent,
                                                  what.n_modes,
                                                  folder.communicator());
    if (what.spins)
      for (const FemSpace::Part &part : compliance.space().parts())
        if (model.bodies[part.body].rate != 0)
          warn_of_averaged_bearings(model, part.body, log);
    log.line("coupled modes: ",
             modes.n_unknowns,
             " unknowns, ",
             modes.counted ? "counted" : "not counted",
             ", stiffness ",
             1e-3 * modes.stiffness,
             " N m/rad");
    // Only modes that turn the hub are named: 2 % is the limit of the comparison with lines of a
    // run too.
    for (const auto *list : {&modes.turning, &modes.standing})
      for (const CoupledMode &mode : *list)
        if (mode.share_of_turn > .02)
          log.line(list == &modes.turning ? "  in the rotating frame " : "  in the fixed frame ",
                   mode.frequency,
                   " Hz: ",
                   100 * mode.share_of_turn,
                   " % of the static rotation");
    Table table = make_coupled_mode_table();
    add_coupled_modes(modes, table);
    write_tables(folder, "coupled_modes", table);
    folder.make_subfolder("modes");
    // Shapes as they stand in space, where the pair turns.
    const auto     &list = modes.standing.empty() ? modes.turning : modes.standing;
    const FemSpace &d    = compliance.space();
    for (const FemSpace::Part &part : d.parts())
      {
        const FieldGrid         shown(d, part);
        std::vector<NamedShape> shapes;
        for (std::size_t k = 0; k < list.size(); ++k)
          shapes.push_back({shape_name(k, list[k].frequency), shown.take(list[k].shape)});
        write_shapes(folder,
                     "modes/coupled_" + shown.body().name() + ".vtu",
                     shown.make_grid(),
                     shapes);
      }
  }
} // namespace vfife
