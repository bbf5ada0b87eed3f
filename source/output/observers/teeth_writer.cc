// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/model/model.h>
#include <vfife/output/observers/teeth_writer.h>

#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  namespace
  {
    using Pair         = const ToothSample &;
    using ToothColumns = SampleColumns<ToothSample>;

    /** All columns in the order of the file. */
    ToothColumns list_columns(const Model &model, const HertzContact &hertz)
    {
      ToothColumns      columns;
      const auto *const t     = model.only_transmission();
      const auto        tooth = [&](const unsigned int b) {
        return column::tooth_of(model.bodies[b].name());
      };
      std::vector<std::string> sides;
      for (const ContactPair &contact : model.contacts)
        sides.push_back(contact.side);
      columns.add_text(column::side, [sides](Pair pair) { return sides[pair.contact.contact]; });
      columns.add(t ? tooth(t->driver) : "slave facet group", "-", [](Pair pair) {
        return pair.first;
      });
      columns.add(t ? tooth(t->driven) : "master facet group", "-", [](Pair pair) {
        return pair.second;
      });
      columns.add(column::force, "N", [](Pair pair) { return pair.contact.force.norm(); });
      columns.add(column::torque, "N m", [](Pair pair) { return 1e-3 * pair.contact.torque; });
      columns.add(column::largest_pressure, "MPa", [](Pair pair) {
        return pair.contact.largest_pressure;
      });
      columns.add(column::area, "mm^2", [](Pair pair) { return pair.contact.area; });
      columns.add("mean pressure", "MPa", [](Pair pair) {
        return pair.contact.area > 0 ? pair.contact.normal_force / pair.contact.area : 0.;
      });
      // Of Hertz's ellipse under the pair's force, with the curvatures of the mean contact.
      if (hertz.largest_pressure(1.) > 0)
        columns.add("hertz pressure", "MPa", [hertz](Pair pair) {
          return hertz.largest_pressure(pair.contact.normal_force);
        });
      return columns;
    }

    /** Whether the slave surface belongs to the driven member. */
    bool is_driven_slave(const Model &model, const ContactPair &pair)
    {
      const Transmission *const t = model.only_transmission();
      return t && pair.slave_body == t->driven;
    }
  } // namespace

  TeethWriter::TeethWriter(const OutputFolder &folder,
                           const Model        &model,
                           const std::uint64_t steps_between,
                           const HertzContact &hertz)
    : SampledTable(folder, "teeth.csv", list_columns(model, hertz), steps_between)
  {
  }

  void TeethWriter::add_rows(const Model &model, const State &state)
  {
    for (const ToothContact &contact : state.measured.teeth)
      {
        ToothSample sample{contact, contact.slave_group, contact.master_group};
        if (is_driven_slave(model, model.contacts[contact.contact]))
          // Columns are named after the members, driver first, whoever is the slave.
          std::swap(sample.first, sample.second);
        add_row(state, sample);
      }
  }
} // namespace vfife
