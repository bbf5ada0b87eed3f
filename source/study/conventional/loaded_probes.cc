// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/column_names.h>
#include <vfife/model/body_frame.h>
#include <vfife/study/conventional/loaded_probes.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** The node of the body at @p place of the fixed frame at time zero. */
    unsigned int find_node(const Body &body, const Vector3 &place)
    {
      const auto &nodes    = body.node_positions();
      const auto  distance = [&](const Vector3 &X) { return (body.placement(X) - place).norm(); };
      const auto  nearest =
        std::min_element(nodes.begin(), nodes.end(), [&](const Vector3 &a, const Vector3 &b) {
          return distance(a) < distance(b);
        });
      if (!(distance(*nearest) < 1e-6 * place.norm()))
        throw InputError("body \"" + body.name() + "\": its sectors are not copies of each other");
      return nearest - nodes.begin();
    }
  } // namespace

  LoadedProbes::LoadedProbes(const Model &model, const unsigned int meshes)
    : model_(model)
  {
    if (!model.transmission)
      throw InputError("the model is no gear pair");
    const Transmission &t = *model.transmission;
    for (const Probe &probe : model.probes)
      {
        const bool    is_driver = probe.body == t.driver;
        const Body   &body      = model.bodies[probe.body];
        const double  pitch     = 2 * pi / (is_driver ? t.driver_teeth : t.driven_teeth);
        const double  sense     = is_driver ? t.driver_sense : t.driven_sense;
        const Vector3 arm = body.placement(body.node_positions()[probe.node]) - body.axis.point;
        // In the position of m tooth meshes later the probe is where its copy m pitches ahead is
        // now: the copies at the positions of one mesh make the probe's passage through all.
        std::vector<unsigned int> nodes;
        for (unsigned int m = 0; m <= meshes; ++m)
          nodes.push_back(find_node(
            body, body.axis.point + rotation_about(body.axis.direction, sense * m * pitch) * arm));
        copies_.push_back(nodes);
      }
    table_.add_column(column::time, "tooth meshes");
    table_.add_text_column(column::probe);
    table_.add_column(column::von_mises, "MPa");
    for (const std::string &stress : column::stresses(column::cylindrical_axes))
      table_.add_column(stress, "MPa");
  }

  void LoadedProbes::add_position(const double position, const std::vector<Stress> &stresses)
  {
    for (std::size_t p = 0; p < copies_.size(); ++p)
      {
        const Body &body = model_.bodies[model_.probes[p].body];
        for (std::size_t m = 0; m < copies_[p].size(); ++m)
          {
            const unsigned int node = copies_[p][m];
            const Stress      &here = stresses[body.first_node + node];
            // In the axes r, theta, z of the copy, which are those of the probe when it has come
            // there.
            const Stress turned =
              turn_stress(here,
                          body.placement.rotation *
                            compute_cylindrical_axes(body, body.node_positions()[node]));
            std::vector<Table::Cell> row = {position + m, model_.probes[p].name, von_mises(here)};
            row.insert(row.end(), turned.data(), turned.data() + 6);
            table_.add_row(row);
          }
      }
  }
} // namespace vfife
