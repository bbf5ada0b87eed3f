// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/sample_columns.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>
#include <vfife/output/measures/contact_pattern.h>

#include <algorithm>
#include <map>

namespace vfife
{
  namespace
  {
    /** A place of a flank: a row of pattern.csv. */
    struct Place
    {
      const std::string &body, &side;
      Vector2            r_z;              ///< [mm]
      double             largest_pressure; ///< [MPa]
    };

    /** All columns in the order of the file. */
    SampleColumns<Place> list_columns()
    {
      SampleColumns<Place> columns;
      columns.add_text("body", [](const Place &place) { return place.body; });
      columns.add_text(column::side, [](const Place &place) { return place.side; });
      columns.add("r", "mm", [](const Place &place) { return place.r_z[0]; });
      columns.add("z", "mm", [](const Place &place) { return place.r_z[1]; });
      columns.add(column::largest_pressure, "MPa", [](const Place &place) {
        return place.largest_pressure;
      });
      return columns;
    }

    ContactPattern::Flank make_flank(const Model       &model,
                                     const unsigned int b,
                                     const std::string &surface,
                                     const std::string &side)
    {
      // Nodes of all teeth with their areas.
      const Body           &body = model.bodies[b];
      ContactPattern::Flank flank;
      flank.body  = b;
      flank.side  = side;
      flank.nodes = body.mesh().surfaces.at(surface).nodes;
      flank.areas = compute_nodal_areas(body, flank.nodes);

      std::map<unsigned int, unsigned int> place_of;
      for (std::size_t i = 0; i < flank.nodes.size(); ++i)
        {
          const unsigned int node = flank.nodes[i];
          const auto [place, is_new] =
            place_of.emplace(body.structure().first_copy(node),
                             static_cast<unsigned int>(flank.r_z.size()));
          flank.places.push_back(place->second);
          if (is_new)
            {
              const Vector3 &x = body.node_positions()[node];
              // Radius and height are the same on all teeth: a place of the flank, seen on each of
              // them.
              flank.r_z.emplace_back(x.head<2>().norm(), x[2]);
              flank.place_areas.push_back(flank.areas[i]);
            }
        }
      flank.largest_pressure.assign(flank.r_z.size(), 0.);
      return flank;
    }
  } // namespace

  Vector2 ContactPattern::Flank::centre() const
  {
    Vector2 sum    = Vector2::Zero();
    double  weight = 0;
    for (std::size_t i = 0; i < r_z.size(); ++i)
      {
        const double force = largest_pressure[i] * place_areas[i];
        sum += force * r_z[i];
        weight += force;
      }
    return sum / weight;
  }

  ContactPattern::ContactPattern(const Model &model)
  {
    for (const ContactPair &pair : model.contacts)
      {
        flanks_.push_back(make_flank(model, pair.slave_body, pair.slave_surface, pair.side));
        flanks_.push_back(make_flank(model, pair.master_body, pair.master_surface, pair.side));
      }
  }

  void ContactPattern::add(const NodalForce &force)
  {
    for (Flank &flank : flanks_)
      for (std::size_t i = 0; i < flank.nodes.size(); ++i)
        if (flank.areas[i] > 0)
          {
            double &largest = flank.largest_pressure[flank.places[i]];
            largest         = std::max(largest, force(flank.body, flank.nodes[i]) / flank.areas[i]);
          }
  }

  Table ContactPattern::table(const Model &model) const
  {
    const SampleColumns<Place> columns = list_columns();
    Table                      table;
    columns.add_to(table);
    for (const Flank &flank : flanks_)
      for (std::size_t i = 0; i < flank.r_z.size(); ++i)
        table.add_row(columns.cells_of(
          {model.bodies[flank.body].name(), flank.side, flank.r_z[i], flank.largest_pressure[i]}));
    return table;
  }
} // namespace vfife
