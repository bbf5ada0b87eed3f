// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_operator_halo_exchange_h
#define vfife_dynamics_operator_halo_exchange_h

#include <vfife/model/node_field.h>
#include <vfife/model/partition.h>

#include <mpi.h>

#include <vector>

namespace vfife
{
  class Communicator;
  struct Model;

  /**
   * Sums the vectors of a field over the ranks that share the node. Every rank adds the same parts
   * in the same order (ascending rank), so that all copies of a node stay equal to the last bit.
   */
  class HaloExchange
  {
  public:
    HaloExchange(const Model                      &model,
                 const Partition                  &partition,
                 const std::vector<std::uint32_t> &rank_of_element,
                 const Communicator               &communicator);

    /** The @p values of shared nodes become sums over ranks. Collective. */
    void add_over_ranks(NodeField &values);

    /** The same in two parts, between which @p values of other nodes may be worked on. */
    void start(NodeField &values);
    void finish(NodeField &values);

  private:
    struct Neighbour
    {
      unsigned int               rank;
      std::vector<std::uint32_t> nodes; ///< local, in the order of global numbers
      std::vector<double>        sent, received;
    };

    const Communicator        &communicator_;
    unsigned int               rank_;
    std::vector<Neighbour>     neighbours_; ///< ascending rank
    std::vector<std::uint32_t> shared_;     ///< all shared local nodes
    std::vector<double>        own_;        ///< this rank's part at them
    std::vector<MPI_Request>   requests_;
  };
} // namespace vfife

#endif
