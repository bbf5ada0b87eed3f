// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_static_solver_h
#define vfife_fem_static_solver_h

#include <vfife/element/stress.h>
#include <vfife/fem/assembly.h>
#include <vfife/fem/fem_options.h>

#include <functional>
#include <vector>

namespace vfife
{
  /** What acts on the bodies at rest, in axes that turn with them. */
  struct StaticLoads
  {
    double part_of_torques = 1;     ///< of the model's torques
    bool   centrifugal     = false; ///< at each body's rate
    /** Centrifugal force acts on the displaced mass: K - rate^2 S instead of K. */
    bool spin_softening = false;
    /** At the model's nodes, fixed frame [N]; empty: none. */
    std::vector<Vector3> nodal_forces;
    /** Force per volume at a place of the fixed frame [N/mm^3]; empty: none. */
    std::function<Vector3(const Vector3 &)> body_force;
  };

  struct StaticResult
  {
    /** Of all points of the discretization, 3 a point, fixed frame [mm]; equal on all ranks. */
    std::vector<double> displacements;
    double              strain_energy = 0; ///< half the work of the loads [mJ]
    unsigned int        n_iterations  = 0; ///< 0: direct solver
  };

  /**
   * Small displacements of some bodies of a model at rest; contact is not looked at. Constraints
   * are as in explicit dynamics, a prescribed rotation holds its nodes (in the turning axes).
   */
  class StaticSolver
  {
  public:
    /** Throws InputError, naming the motion, where a body can move rigidly. Collective. */
    StaticSolver(const Model                     &model,
                 const std::vector<unsigned int> &bodies,
                 const FemOptions                &options,
                 const Communicator              &communicator);

    const Discretization &discretization() const
    {
      return discretization_;
    }

    /** Collective; throws NumericalError where the solver fails. */
    StaticResult solve(const StaticLoads &loads) const;

    /** See the function of this name. */
    std::vector<Stress> compute_node_stresses(const StaticResult &result) const;

  private:
    std::vector<double> make_forces(const StaticLoads &loads) const;

    const Model        &model_;
    FemOptions          options_;
    const Communicator &communicator_;
    Discretization      discretization_;
  };

  /**
   * Stresses at the model's nodes (xx yy zz xy yz zx, fixed frame [MPa]) under displacements of all
   * points (3 a point), averages of the values of the elements that meet there; zero on bodies that
   * are not part of the discretization. Points of the elements are extrapolated to the nodes by the
   * functions through them.
   */
  std::vector<Stress> compute_node_stresses(const Discretization      &discretization,
                                            const std::vector<double> &displacements);
} // namespace vfife

#endif
