// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/mesh/gear/gear_meridian.h>
#include <vfife/study/cases/body_figures.h>

#include <cstdio>

namespace vfife
{
  namespace
  {
    /** Of each element over that of the first material; empty: all have this one. */
    std::vector<double> relative_densities(const Body &body)
    {
      std::vector<double> densities;
      if (body.materials().size() > 1)
        for (unsigned int e = 0; e < body.n_elements(); ++e)
          densities.push_back(body.material(e).density / body.materials().front().density);
      return densities;
    }

    /** Difference to the true body [%]. */
    double percent(const double mesh, const double exact)
    {
      return 100. * (mesh / exact - 1.);
    }

    /** A figure of the mesh with its difference to the true body, for the log. */
    std::string compared(const double mesh, const double exact, const std::string &unit)
    {
      char text[64];
      std::snprintf(
        text, sizeof text, "%.6g %s (%+.3f %%)", mesh, unit.c_str(), percent(mesh, exact));
      return text;
    }
  } // namespace

  BodyFigures::BodyFigures(const Body            &body,
                           const GearGeometry    &gear,
                           const GearBodyOptions &options)
    : name(body.name())
    , has_one_material(body.materials().size() == 1)
    , density(body.materials().front().density)
    , quality(compute_mesh_quality(body.mesh().triangulation))
    , mesh(compute_solid_integrals(body.mesh().triangulation))
    , exact(compute_true_integrals(gear, options))
    , weighted(compute_solid_integrals(body.mesh().triangulation, relative_densities(body)))
  {
  }

  void BodyFigures::write_to(Log &log) const
  {
    log.line(name,
             ": ",
             quality.cells,
             " elements, ",
             quality.nodes,
             " nodes, least scaled Jacobian ",
             quality.least_scaled_jacobian,
             ", least edge ",
             quality.least_edge,
             " mm, largest aspect ratio ",
             quality.largest_aspect_ratio);
    // Integrals are those of volume [mm^3, mm^5].
    const double to_kg = 1e3 * density; // t to kg
    if (!has_one_material)
      {
        log.line(name,
                 ": mass ",
                 to_kg * weighted.volume,
                 " kg of several materials, polar inertia ",
                 to_kg * weighted.polar(),
                 " kg mm^2, transverse inertia ",
                 to_kg * weighted.transverse(),
                 " kg mm^2, volume ",
                 compared(mesh.volume, exact.volume, "mm^3"),
                 "; in brackets the difference to the true body");
        return;
      }
    log.line(name,
             ": mass ",
             compared(to_kg * mesh.volume, to_kg * exact.volume, "kg"),
             ", polar inertia ",
             compared(to_kg * mesh.polar(), to_kg * exact.polar(), "kg mm^2"),
             ", transverse inertia ",
             compared(to_kg * mesh.transverse(), to_kg * exact.transverse(), "kg mm^2"),
             "; in brackets the difference to the true body");
  }

  Table body_figures_table(const std::vector<BodyFigures> &bodies)
  {
    Table table;
    table.add_text_column("body");
    for (const char *column :
         {"elements", "nodes", "least scaled jacobian", "largest aspect ratio"})
      table.add_column(column, "-");
    for (const char *column : {"least edge", "largest edge", "least height"})
      table.add_column(column, "mm");
    // Mesh and true body have the same integrals in this order; the body's own units are t and mm.
    const std::pair<const char *, const char *> integrals[] = {{"volume", "mm^3"},
                                                               {"mass", "kg"},
                                                               {"centre of mass z", "mm"},
                                                               {"polar inertia", "kg mm^2"},
                                                               {"transverse inertia", "kg mm^2"}};
    for (const auto &column : integrals)
      table.add_column(column.first, column.second);
    for (const auto &column : integrals)
      table.add_column(std::string("true ") + column.first, column.second);
    for (const char *column : {"mass", "polar inertia", "transverse inertia"})
      table.add_column(std::string(column) + " difference", "%");

    for (const BodyFigures &body : bodies)
      {
        const MeshQuality       &q     = body.quality;
        std::vector<Table::Cell> row   = {body.name,
                                          q.cells,
                                          q.nodes,
                                          q.least_scaled_jacobian,
                                          q.largest_aspect_ratio,
                                          q.least_edge,
                                          q.largest_edge,
                                          q.least_height};
        const double             to_kg = 1e3 * body.density;
        // The true body is not cut where materials meet.
        const double known = body.has_one_material ? 1. : not_known;
        const auto   add = [&](const double volume, const SolidIntegrals &s, const double factor) {
          for (const double value : {volume,
                                     factor * to_kg * s.volume,
                                     factor * s.centre(),
                                     factor * to_kg * s.polar(),
                                     factor * to_kg * s.transverse()})
            row.push_back(value);
        };
        add(body.mesh.volume, body.weighted, 1.);
        add(body.exact.volume, body.exact, known);
        // One density: the difference of the mass is that of the volume.
        row.push_back(known * percent(body.mesh.volume, body.exact.volume));
        row.push_back(known * percent(body.mesh.polar(), body.exact.polar()));
        row.push_back(known * percent(body.mesh.transverse(), body.exact.transverse()));
        table.add_row(row);
      }
    return table;
  }
} // namespace vfife
