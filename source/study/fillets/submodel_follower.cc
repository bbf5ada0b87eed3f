// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/study/fillets/submodel_follower.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace vfife
{
  SubmodelFollower::SubmodelFollower(const Model         &model,
                                     const RootSubmodels &submodels,
                                     const Communicator  &communicator)
    : model_(model)
    , submodels_(submodels)
    , communicator_(communicator)
  {
    for (unsigned int b = 0; b < nodes_.size(); ++b)
      {
        const BodyStructure &structure = model.bodies[b].structure();
        Nodes               &nodes     = nodes_[b];
        for (const SectorSubmodel &submodel : submodels.of_body(b))
          for (const unsigned int node : submodel.followed_nodes())
            for (unsigned int tooth = 0; tooth < structure.n_sectors(); ++tooth)
              nodes.followed.push_back(structure.copy(node, tooth));
        std::sort(nodes.followed.begin(), nodes.followed.end());
        nodes.followed.erase(std::unique(nodes.followed.begin(), nodes.followed.end()),
                             nodes.followed.end());
        nodes.flanks = submodels.of_body(b).front().list_flank_nodes();
        nodes.place.assign(model.bodies[b].n_nodes(), 0);
        for (std::size_t i = 0; i < nodes.followed.size(); ++i)
          nodes.place[nodes.followed[i]] = i;
      }
  }

  std::vector<double> SubmodelFollower::gather(const State                     &state,
                                               const NodeField                 &field,
                                               const unsigned int               body,
                                               const std::vector<unsigned int> &nodes) const
  {
    std::vector<double> values(3 * nodes.size(), 0.);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (const std::uint32_t local =
            state.partition->find_owned(model_.bodies[body].first_node + nodes[i]);
          local != Partition::absent)
        Eigen::Map<Vector3>(values.data() + 3 * i) = field.value(local);
    communicator_.sum(values);
    return values;
  }

  RootSubmodels::MemberState SubmodelFollower::follow(const State       &state,
                                                      const unsigned int body) const
  {
    const Nodes              &nodes     = nodes_[body];
    const auto               &submodels = submodels_.of_body(body);
    const std::vector<double> x         = gather(state, state.position, body, nodes.followed);
    Eigen::Matrix3Xd          undeformed(3, nodes.followed.size());
    for (std::size_t i = 0; i < nodes.followed.size(); ++i)
      undeformed.col(i) = model_.bodies[body].node_positions()[nodes.followed[i]];
    const Eigen::Map<const Eigen::Matrix3Xd> places(x.data(), 3, nodes.followed.size());
    // Strains are linear in what is left without the mean motion.
    const Eigen::Matrix4d  motion = Eigen::umeyama(undeformed, places, false);
    const Matrix3          back   = motion.topLeftCorner<3, 3>().transpose();
    const Eigen::Matrix3Xd u =
      back * (places.colwise() - Vector3(motion.topRightCorner<3, 1>())) - undeformed;

    RootSubmodels::MemberState member;
    member.rate     = state.measured.body_rates[body];
    member.followed = [&submodels, &nodes, u](const std::size_t k, const unsigned int sector) {
      return submodels[k].follow(sector, [&](const unsigned int node) -> Vector3 {
        return u.col(nodes.place[node]);
      });
    };
    const std::vector<double> forces = gather(state, state.contact_force, body, nodes.flanks);
    for (std::size_t i = 0; i < nodes.flanks.size(); ++i)
      if (const Eigen::Map<const Vector3> force(forces.data() + 3 * i); !force.isZero(0.))
        submodels.front().add_nodal_force(nodes.flanks[i], back * force, member.forces);
    return member;
  }

  FilletStrains SubmodelFollower::measure(const State &state) const
  {
    return submodels_.of({{follow(state, 0), follow(state, 1)}});
  }
} // namespace vfife
