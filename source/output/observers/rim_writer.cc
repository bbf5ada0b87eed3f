// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/column_names.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/measures/body_motion.h>
#include <vfife/output/observers/rim_writer.h>

#include <algorithm>
#include <utility>

namespace vfife
{
  namespace
  {
    /** All columns in the order of the file, which is that of the coefficients. */
    SampleColumns<RimWaves> list_columns(const unsigned int n_diameters)
    {
      SampleColumns<RimWaves> columns;
      std::size_t             k   = 0;
      const auto              add = [&](const std::string &name) {
        columns.add(name, "um", [k](const RimWaves &waves) { return waves[k]; });
        ++k;
      };
      for (const std::string component : column::cylindrical_axes)
        {
          add(component + " cos 0");
          for (unsigned int n = 1; n <= n_diameters; ++n)
            for (const char *wave : {" cos ", " sin "})
              add(component + wave + std::to_string(n));
        }
      return columns;
    }
  } // namespace

  unsigned int RimWriter::count_diameters(const Model &model)
  {
    const unsigned int teeth = model.transmission->driven_teeth;
    // Waves shorter than two teeth cannot be told from longer ones.
    return std::min(largest_diameters, teeth > 0 ? (teeth - 1) / 2 : 0);
  }

  RimWriter::RimWriter(const OutputFolder &folder,
                       const Model        &model,
                       const std::uint64_t steps_between,
                       Measure             measure)
    : SampledTable(folder, "rim.csv", list_columns(count_diameters(model)), steps_between)
    , folder_(folder)
    , measure_(std::move(measure))
    , n_diameters_(count_diameters(model))
  {
    // Share of the rim's mass, direction about the axis and axes of each node.
    const Body &gear = model.bodies[model.transmission->driven];
    double      mass = 0;
    for (const unsigned int i : model.transmission->driven_rim)
      mass += gear.node_masses()[i];
    for (const unsigned int i : model.transmission->driven_rim)
      {
        const Matrix3 axes = compute_cylindrical_axes(gear, gear.node_positions()[i]);
        nodes_.push_back({i,
                          gear.node_masses()[i] / mass,
                          axes(0, 0),
                          axes(1, 0),
                          gear.placement.rotation * axes});
      }
  }

  void RimWriter::add_rows(const Model &model, const State &state)
  {
    add_row(state, measure_ ? measure_(n_diameters_) : measure_positions(model, state));
  }

  RimWaves RimWriter::measure_positions(const Model &model, const State &state) const
  {
    const unsigned int b    = model.transmission->driven;
    const Body        &gear = model.bodies[b];
    // Sums over whole bodies only where the state does not tell.
    const Matrix3      turn          = state.body_motion.size() == model.bodies.size()
                                         ? compute_turn(gear, state.body_motion[b])
                                         : compute_body_motions(model, state, folder_.communicator())[b].rotation;
    const unsigned int per_component = 2 * n_diameters_ + 1;
    // u = c_0 + sum_n (c_n cos n alpha + s_n sin n alpha),  c_0 = sum share u,
    // c_n = 2 sum share u cos n alpha,  s_n alike: means over the rim, weighted with its mass
    // Sums over this rank's nodes, then over all ranks: per component cos 0, cos 1, sin 1...
    RimWaves sums(3 * per_component, 0.);
    for (const Node &node : nodes_)
      {
        const std::uint32_t local = state.partition->find_owned(gear.first_node + node.number);
        if (local == Partition::absent)
          continue;
        const Vector3 u =
          1e3 * node.share *
          (node.axes.transpose() *
           compute_displacement(gear, node.number, state.node_position(local), turn));
        for (unsigned int c = 0; c < 3; ++c)
          sums[c * per_component] += u[c];
        // 2 exp(i n alpha) for one n after the other.
        double cosine = 2., sine = 0.;
        for (unsigned int n = 1; n <= n_diameters_; ++n)
          {
            const double before = cosine;
            cosine              = before * node.cosine - sine * node.sine;
            sine                = before * node.sine + sine * node.cosine;
            for (unsigned int c = 0; c < 3; ++c)
              {
                sums[c * per_component + 2 * n - 1] += u[c] * cosine;
                sums[c * per_component + 2 * n] += u[c] * sine;
              }
          }
      }
    folder_.communicator().sum(sums);
    return sums;
  }
} // namespace vfife
