// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/column_names.h>
#include <vfife/fem/statics/compliance.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/model/model.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/study/fillets/fillet_faces.h>
#include <vfife/study/fillets/pressed_flank.h>

namespace vfife
{
  void PressedFlankOptions::declare(dealii::ParameterHandler &prm)
  {
    const Subsection section(prm, "Pressed flank");
    declare_quantity(prm,
                     "pressure",
                     pressure,
                     "MPa",
                     "Uniform pressure on the whole flank of one tooth of a gear pair, whose "
                     "fillet stresses are recorded",
                     Range::positive().or_word("none"));
    declare_choice(
      prm, "member", on_gear, {{"pinion", false}, {"gear", true}}, "Member with this tooth");
    declare_integer(prm, "tooth", tooth, "Number of the tooth, from 0", 0, 100000);
    declare_choice(prm, "side", on_convex, {{"concave", false}, {"convex", true}}, "Pressed flank");
  }

  void PressedFlankOptions::check(const Model &model) const
  {
    if (!acts())
      return;
    if (model.transmissions.empty())
      throw InputError("Linear static/Pressed flank/pressure",
                       "expected none for a general model, got a pressure. Set a load in Model.");
    const unsigned int n_teeth = model.bodies[on_gear ? 1 : 0].structure().n_sectors();
    if (tooth >= n_teeth)
      throw InputError("Linear static/Pressed flank/tooth",
                       "expected at most " + std::to_string(n_teeth - 1) + ", got " +
                         std::to_string(tooth));
  }

  NamedFigures solve_pressed_flank(const Model               &model,
                                   const PressedFlankOptions &options,
                                   const FemOptions          &fem,
                                   const bool                 centrifugal,
                                   const OutputFolder        &folder,
                                   Log                       &log)
  {
    // 1. The pressure as forces at the points.
    const unsigned int b    = options.on_gear ? 1 : 0;
    const Body        &body = model.bodies[b];
    Load               load;
    load.name              = "pressed flank";
    load.kind              = LoadKind::pressure;
    load.body              = b;
    load.pressure          = options.pressure;
    const char *const side = options.on_convex ? surface_name::convex : surface_name::concave;
    for (const unsigned int node : body.mesh().surfaces.at(side).nodes)
      if (body.structure().sector_of(node) == options.tooth)
        load.nodes.push_back(node);
    const Compliance    compliance(model, fem, centrifugal, folder.communicator());
    const FemSpace     &space = compliance.space();
    std::vector<double> forces(3 * static_cast<std::size_t>(space.n_points()), 0.);
    add_load_forces(load, space, *space.find_part(b), 1., forces);
    const std::vector<double> pressed = compliance.solve(forces);
    const std::vector<double> u       = add_scaled(compliance.spun(), 1., pressed);
    log.line(compliance.n_unknowns(),
             " unknowns",
             compliance.by_sectors() ? ", by one sector of each body" : "");

    // 2. Stresses of its fillets.
    FilletOptions recorded;
    recorded.source      = FilletSource::elements;
    recorded.teeth       = RecordedTeeth::named;
    recorded.named_teeth = {body.name() + " " + std::to_string(options.tooth)};
    RootStress        stress(model, recorded);
    const FilletFaces faces(space, stress.fillets());
    const auto        columns = list_root_stress_columns();
    Table             table   = columns.make_table(column::position, "mesh cycles");
    for (const RootStressSample &sample : stress.measure(0., {}, faces.of(u)))
      table.add_row(columns.make_row(0., sample));
    write_csv(folder, "root_stress.csv", table);
    write_csv(folder, "fillet_envelope.csv", stress.envelope());
    write_csv(folder, "root_sections.csv", stress.sections());

    // 3. Figures of this member, and of the pressure.
    double  work = 0;
    Vector3 sum  = Vector3::Zero();
    for (std::size_t i = 0; i < forces.size(); i += 3)
      {
        const Eigen::Map<const Vector3> f(forces.data() + i);
        sum += f;
        work += .5 * f.dot(Eigen::Map<const Vector3>(pressed.data() + i));
      }
    NamedFigures figures;
    for (const auto &figure : list_root_figures(stress))
      if (figure.first.rfind(body.name() + " ", 0) == 0)
        figures.push_back(figure);
    figures.push_back({"resultant of the pressure", {sum.norm(), "N"}});
    figures.push_back({"work of the pressure", {work, "mJ"}});
    for (const auto &[name, figure] : figures)
      log.line(name, " ", figure.value, " ", figure.unit);
    return figures;
  }
} // namespace vfife
