// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_fillets_submodel_follower_h
#define vfife_study_fillets_submodel_follower_h

#include <vfife/model/state.h>
#include <vfife/study/fillets/root_submodels.h>

#include <array>
#include <vector>

namespace vfife
{
  class Communicator;

  /** Strains of fillets by submodels that follow a run: displacements of its nodes on top of each
   * body's mean rigid motion, nodal forces of its contact, its rates. */
  class SubmodelFollower
  {
  public:
    /** Everything given must outlive the object. */
    SubmodelFollower(const Model         &model,
                     const RootSubmodels &submodels,
                     const Communicator  &communicator);

    /** Collective. */
    FilletStrains measure(const State &state) const;

  private:
    /** Of one body. */
    struct Nodes
    {
      std::vector<unsigned int> followed, flanks; ///< by all submodels; of the teeth
      std::vector<unsigned int> place;            ///< by node, among those followed
    };

    /** Values of nodes of a body from all ranks, 3 each. */
    std::vector<double>        gather(const State                     &state,
                                      const NodeField                 &field,
                                      unsigned int                     body,
                                      const std::vector<unsigned int> &nodes) const;
    RootSubmodels::MemberState follow(const State &state, unsigned int body) const;

    const Model         &model_;
    const RootSubmodels &submodels_;
    const Communicator  &communicator_;
    std::array<Nodes, 2> nodes_;
  };
} // namespace vfife

#endif
