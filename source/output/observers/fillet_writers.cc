// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/model/model.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/observers/fillet_writers.h>

#include <algorithm>
#include <utility>

namespace vfife
{
  FilletPlaces::FilletPlaces(const Model        &model,
                             const RootStress   &stress,
                             const Communicator &communicator)
    : model_(model)
    , communicator_(communicator)
    , index_(model.n_nodes(), 0)
  {
    for (const MemberFillet &member : stress.fillets())
      for (unsigned int tooth = 0; tooth < member.fillet.n_teeth(); ++tooth)
        for (unsigned int column = 0; column <= member.fillet.n_columns(); ++column)
          for (unsigned int row = 0; row <= member.fillet.n_rows(); ++row)
            nodes_.push_back(model.bodies[member.body].first_node +
                             member.fillet.node(column, row, tooth));
    // Two fillets share the root land between them.
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    for (unsigned int i = 0; i < nodes_.size(); ++i)
      index_[nodes_[i]] = i;
  }

  FilletStrains FilletPlaces::measure(const State &state)
  {
    places_.assign(3 * nodes_.size(), 0.);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      {
        const std::uint32_t local = state.partition->find_owned(nodes_[i]);
        if (local != Partition::absent)
          Eigen::Map<Vector3>(places_.data() + 3 * i) = state.node_position(local);
      }
    communicator_.sum(places_);
    return strains_of_places(model_, [this](const unsigned int body, const unsigned int node) {
      return Vector3(Eigen::Map<const Vector3>(
        places_.data() + 3 * std::size_t(index_[model_.bodies[body].first_node + node])));
    });
  }

  RootStressWriter::RootStressWriter(const OutputFolder &folder,
                                     const std::uint64_t steps_between,
                                     RootStress         &stress,
                                     FilletMeasure       measure)
    : SampledTable(folder, "root_stress.csv", list_root_stress_columns(), steps_between)
    , folder_(folder)
    , stress_(stress)
    , measure_(std::move(measure))
  {
  }

  void RootStressWriter::add_rows(const Model &model, const State &state)
  {
    for (const RootStressSample &sample : stress_.measure(
           model.only_transmission()->meshes(state.time), state.measured.teeth, measure_(state)))
      add_row(state, sample);
  }

  void RootStressWriter::serialize(ByteStream &stream)
  {
    SampledTable::serialize(stream);
    // Beside the columns of the table, which are parts too.
    stream.pass_required_part("envelope", [this](ByteStream &part) { stress_.serialize(part); });
    stream.pass_part("passages", [this](ByteStream &part) { stress_.serialize_passages(part); });
  }

  void RootStressWriter::finish(const Model &model, const State &state)
  {
    SampledTable::finish(model, state);
    write_csv(folder_, "fillet_envelope.csv", stress_.envelope());
    write_csv(folder_, "root_sections.csv", stress_.sections());
  }

  GaugeWriter::GaugeWriter(const OutputFolder &folder,
                           const std::uint64_t steps_between,
                           const RootStress   &stress,
                           FilletMeasure       measure)
    : SampledTable(folder, "gauges.csv", list_gauge_columns(), steps_between)
    , stress_(stress)
    , measure_(std::move(measure))
  {
  }

  void GaugeWriter::add_rows(const Model &model, const State &state)
  {
    for (const GaugeSample &sample :
         stress_.read_gauges(model.only_transmission()->meshes(state.time), false, measure_(state)))
      add_row(state, sample);
  }
} // namespace vfife
