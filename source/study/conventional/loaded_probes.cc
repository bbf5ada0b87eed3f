// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/model/body_frame.h>
#include <vfife/study/cases/probe_copies.h>
#include <vfife/study/conventional/loaded_probes.h>

#include <cmath>

namespace vfife
{
  LoadedProbes::LoadedProbes(const Model &model)
    : model_(model)
  {
    for (const ProbeQuantity &quantity : list_probe_quantities(column::cylindrical_axes))
      if (quantity.kind == ProbeQuantityKind::equivalent_stress ||
          quantity.kind == ProbeQuantityKind::stress)
        stresses_.push_back(quantity);
    for (const Probe &probe : model.probes)
      copies_.push_back(list_copies(model, probe));
    table_.add_column(column::after_mean_contact, "mesh cycles");
    table_.add_text_column(column::probe);
    for (const ProbeQuantity &stress : stresses_)
      table_.add_column(stress.name, stress.unit);
  }

  void LoadedProbes::add_position(const double position, const std::vector<Stress> &stresses)
  {
    for (std::size_t p = 0; p < copies_.size(); ++p)
      {
        const Probe &probe     = model_.probes[p];
        const Body  &body      = model_.bodies[probe.body];
        const double n         = copies_[p].size();
        const double from_mesh = position - meshes_to_contact(model_, probe);
        for (std::size_t m = 0; m < copies_[p].size(); ++m)
          {
            const unsigned int node = copies_[p][m].node;
            // In the axes r, theta, z of the copy, which are those of the probe when it has come
            // there.
            const ProbeValue value =
              make_probe_value(Vector3::Zero(),
                               stresses[body.first_node + node],
                               {body.placement.rotation *
                                compute_cylindrical_axes(body, body.node_positions()[node])});
            // Half a turn before the mesh and half a turn after it.
            const double             after = from_mesh + m;
            std::vector<Table::Cell> row   = {after - n * std::floor(after / n + .5), probe.name};
            for (const ProbeQuantity &stress : stresses_)
              row.push_back(stress.value(value));
            table_.add_row(row);
          }
      }
  }

  std::size_t LoadedProbes::find_largest(const std::string &probe) const
  {
    const std::vector<double> &stresses = table_.numbers(column::von_mises);
    std::size_t                largest  = stresses.size();
    for (std::size_t i = 0; i < stresses.size(); ++i)
      if (table_.column(column::probe).texts[i] == probe &&
          (largest == stresses.size() || stresses[i] > stresses[largest]))
        largest = i;
    return largest;
  }
} // namespace vfife
