// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/measures/bearing_columns.h>
#include <vfife/output/observers/bearing_writer.h>
#include <vfife/study/conventional/loaded_contact_tables.h>
#include <vfife/study/conventional/loaded_supports.h>

namespace vfife
{
  LoadedSupports::LoadedSupports(const Model &model)
    : model_(model)
    , mounting_(model)
    , leads_(model)
    , bearings_(make_loaded_bearing_table())
    , misalignments_(make_loaded_misalignment_table())
  {
  }

  void LoadedSupports::add_position(const FemSpace              &space,
                                    const double                 position,
                                    const PairEquilibriumResult &result)
  {
    const auto columns = list_bearing_columns();
    for (std::size_t b = 0; b < model_.bearings.size(); ++b)
      bearings_.add_row(columns.make_row(position, {model_.bearings[b].name, result.bearings[b]}));
    if (!PairMounting::changes(model_))
      return;
    // Nodes of a body where it has turned, displaced in its own axes.
    const Transmission &t          = *model_.only_transmission();
    const auto          motions_of = [&](const double driven_turn, const std::vector<double> &u) {
      return [&, driven_turn](const unsigned int b, const BodyRing &ring) {
        const double       turn  = b == t.driven
                                              ? t.driven_sense * t.ratio() * result.driver_turn + driven_turn
                                              : t.driver_sense * result.driver_turn;
        const Axis        &axis  = model_.bodies[b].axis;
        const Matrix3      R     = rotation_about(axis.direction, turn);
        const unsigned int first = space.find_part(b)->first_point;
        return ring.measure([&](const std::size_t i) {
          return Vector3(axis.point + R * (ring.places()[i] +
                                           Eigen::Map<const Vector3>(
                                             u.data() + 3 * std::size_t(first + ring.nodes()[i])) -
                                           axis.point));
        });
      };
    };
    const auto touching = motions_of(result.touch_turn, result.touch_displacements),
               loaded   = motions_of(result.turn, result.displacements);
    std::vector<Table::Cell> row =
      list_mounting_columns().make_row(position, mounting_.measure(loaded));
    const SupportParts parts =
      SupportLeads::find_parts(leads_.measure(touching), leads_.measure(loaded));
    row.push_back(parts.bearings / arcsecond);
    row.push_back(parts.bending / arcsecond);
    misalignments_.add_row(row);
  }

  void LoadedSupports::write(const OutputFolder &folder) const
  {
    if (!model_.bearings.empty())
      {
        write_csv(folder, "bearings.csv", bearings_);
        write_bearing_curves(folder, model_.bearings);
      }
    if (PairMounting::changes(model_))
      write_csv(folder, "misalignment.csv", misalignments_);
  }
} // namespace vfife
