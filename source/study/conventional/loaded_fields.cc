// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/operator/whole_partition.h>
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/fem/system/fem_space.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/study/conventional/loaded_fields.h>

#include <limits>

namespace vfife
{
  namespace
  {
    std::shared_ptr<const Partition> make_empty_partition(const Model &model)
    {
      auto partition = std::make_shared<Partition>();
      partition->local_node.assign(model.n_nodes(), Partition::absent);
      partition->first_local_node.assign(model.bodies.size() + 1, 0);
      return partition;
    }
  } // namespace

  LoadedFields::LoadedFields(const OutputFolder  &folder,
                             const Model         &model,
                             const OutputOptions &output)
    : model_(model)
    , writer_(folder, model, output.field_format)
    , every_(output.fields_every)
    , next_(every_ > 0 ? -std::numeric_limits<double>::infinity()
                       : std::numeric_limits<double>::infinity())
  {
    // The first rank has all of the model.
    state_.partition =
      folder.communicator().is_root() ? make_whole_partition(model) : make_empty_partition(model);
    for (NodeField *field : {&state_.position, &state_.velocity, &state_.contact_force})
      *field = NodeField(state_.partition->n_local());
    state_.body_motion.resize(model.bodies.size());
  }

  void LoadedFields::add_position(const double                 position,
                                  const FemSpace              &space,
                                  const PairEquilibrium       &equilibrium,
                                  const PairEquilibriumResult &result,
                                  const std::vector<Stress>   &stresses)
  {
    // Positions that are multiples but for round-off.
    if (position < next_ - 1e-9)
      return;
    next_       = position + every_;
    state_.time = position;
    ++state_.step;
    std::vector<std::array<double, 6>> cylindrical(model_.n_nodes());
    for (const FemSpace::Part &part : space.parts())
      {
        const Body &body              = model_.bodies[part.body];
        state_.body_motion[part.body] = {equilibrium.rotation(part.body) * body.placement.rotation,
                                         equilibrium.place(part.body, body.placement.translation)};
        for (unsigned int node = 0; node < body.n_nodes(); ++node)
          {
            const std::size_t number = body.first_node + node;
            Eigen::Map<Stress>(cylindrical[number].data()) =
              turn_stress(stresses[number],
                          body.placement.rotation *
                            compute_cylindrical_axes(body, body.node_positions()[node]));
            const std::uint32_t local = state_.partition->local_node[number];
            if (local == Partition::absent)
              continue;
            const std::size_t point = part.first_point + node;
            state_.position.set(local,
                                equilibrium.place(part.body,
                                                  space.points()[point] +
                                                    Eigen::Map<const Vector3>(
                                                      &result.displacements[3 * point])));
          }
      }
    state_.contact_force.set_zero();
    for (const NodalForce &nodal : result.contact_forces)
      if (const std::uint32_t local =
            state_.partition->local_node[model_.bodies[nodal.body].first_node + nodal.node];
          local != Partition::absent)
        state_.contact_force.set(local, nodal.force);
    writer_.write(model_, state_, cylindrical);
  }
} // namespace vfife
