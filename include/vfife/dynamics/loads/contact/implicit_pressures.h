// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_contact_implicit_pressures_h
#define vfife_dynamics_loads_contact_implicit_pressures_h

#include <vfife/base/types.h>
#include <vfife/contact/touching_point.h>
#include <vfife/dynamics/loads/contact/contact_nodes.h>

#include <map>
#include <vector>

namespace vfife
{
  class Communicator;
  class ContactRanks;
  class NodeField;
  struct Partition;

  /**
   * The pressures of the pairs that are integrated implicitly. They follow from the gaps at both
   * ends of a step (PressureSolver), and so from where the nodes are without contact at its end.
   * Each cluster of points is solved for by all ranks that share it, in one order.
   */
  class ImplicitPressures
  {
  public:
    /** All must outlive the object. */
    ImplicitPressures(const Model &model, const ContactPairs &pairs, const ContactRanks &ranks);

    /** Masses of this rank's nodes [t]. Collective. */
    void set_masses(const std::vector<double> &masses,
                    const Partition           &partition,
                    const Communicator        &communicator);

    /** Sets ContactSurface::free_velocities of @p nodes that this rank owns, after a step @p dt [s]
     * under @p forces. */
    void find_free_velocities(const std::vector<ContactNode> &nodes,
                              const NodeField                &velocities,
                              const NodeField                &forces,
                              double                          dt) const;

    /** Sets the pressures of this rank's @p points of the pairs. Collective between ranks that
     * share points. */
    void solve(double dt, std::vector<std::vector<TouchingPoint>> &points);

  private:
    /** A point in the solution, and whose it is. */
    struct SharedPoint;

    Matrix3                    inverse_mass(unsigned int number) const;
    std::vector<TouchingPoint> solve_cluster(double                                  dt,
                                             const std::vector<const SharedPoint *> &shared);

    const Model        &model_;
    const ContactPairs &pairs_;
    const ContactRanks &ranks_;
    /** Of the nodes of all surfaces by their numbers: 1/m [1/t]; instead, of nodes with held
     * directions, a matrix that is zero along these. */
    std::vector<double>             inverse_masses_;
    std::map<unsigned int, Matrix3> held_;
    /** Place of a node in the solution for a cluster, while there is one. */
    std::vector<unsigned int> places_;
  };
} // namespace vfife

#endif
