// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/measures/body_motion.h>
#include <vfife/output/observers/rim_writer.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    unsigned int count_diameters(const Model &model)
    {
      const unsigned int teeth = model.transmission->driven_teeth;
      return std::min(RimWriter::largest_diameters, teeth > 0 ? (teeth - 1) / 2 : 0);
    }

    Table make_table(const unsigned int n_diameters)
    {
      Table table;
      table.add_column("time", "s");
      for (const std::string component : {"r", "theta", "z"})
        {
          table.add_column(component + " cos 0", "um");
          for (unsigned int n = 1; n <= n_diameters; ++n)
            for (const char *wave : {" cos ", " sin "})
              table.add_column(component + wave + std::to_string(n), "um");
        }
      return table;
    }
  } // namespace

  RimWriter::RimWriter(const OutputFolder &folder,
                       const Model        &model,
                       const std::uint64_t steps_between)
    : folder_(folder)
    , steps_between_(steps_between)
    , n_diameters_(count_diameters(model))
    , table_(make_table(n_diameters_))
    , file_(folder, "rim.csv", table_)
  {
    const Body &gear = model.bodies[model.transmission->driven];
    double      mass = 0;
    for (const unsigned int i : model.transmission->driven_rim)
      mass += gear.node_masses()[i];
    for (const unsigned int i : model.transmission->driven_rim)
      {
        const Matrix3 axes = compute_cylindrical_axes(gear, gear.node_positions()[i]);
        nodes_.push_back({i, gear.node_masses()[i] / mass, {axes(0, 0), axes(1, 0)}, axes});
      }
  }

  bool RimWriter::due(const State &state) const
  {
    return state.step % steps_between_ == 0;
  }

  void RimWriter::observe(const Model &model, const State &state)
  {
    if (!due(state))
      return;
    const unsigned int b    = model.transmission->driven;
    const Body        &gear = model.bodies[b];
    const Matrix3 turn = compute_body_motions(model, state, folder_.communicator())[b].rotation;
    const unsigned int  per_component = 2 * n_diameters_ + 1;
    std::vector<double> sums(3 * per_component, 0.);
    for (const Node &node : nodes_)
      {
        const std::uint32_t local = state.partition->find_owned(gear.first_node + node.number);
        if (local == Partition::absent)
          continue;
        const Vector3 u =
          1e3 * node.share * node.axes.transpose() *
          (gear.placement.rotation.transpose() *
           compute_displacement(gear, node.number, state.node_position(local), turn));
        for (unsigned int c = 0; c < 3; ++c)
          {
            double *sum = &sums[c * per_component];
            sum[0] += u[c];
            std::complex<double> wave = 2; // times exp(i n alpha)
            for (unsigned int n = 1; n <= n_diameters_; ++n)
              {
                wave *= node.direction;
                sum[2 * n - 1] += u[c] * wave.real();
                sum[2 * n] += u[c] * wave.imag();
              }
          }
      }
    folder_.communicator().sum(sums);
    std::vector<Table::Cell> row = {state.time};
    row.insert(row.end(), sums.begin(), sums.end());
    table_.add_row(row);
    file_.append_new_rows(table_);
  }

  void RimWriter::exchange(ByteStream &stream)
  {
    table_.exchange_rows(stream);
    file_.append_new_rows(table_); // a run that goes on writes them again
    file_.flush();
  }

  void RimWriter::finish(const Model &, const State &)
  {
    file_.flush();
  }

  const Table &RimWriter::table() const
  {
    return table_;
  }
} // namespace vfife
