// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_statics_static_solver_h
#define vfife_fem_statics_static_solver_h

#include <vfife/element/stress.h>
#include <vfife/fem/fem_options.h>
#include <vfife/fem/system/spin_state.h>

#include <functional>
#include <optional>
#include <vector>

namespace vfife
{
  /** What acts on the bodies at rest, in axes that turn with them. */
  struct StaticLoads
  {
    double part_of_torques = 1; ///< of the model's torques
    double part_of_loads   = 1; ///< of the model's loads and prescribed displacements
    /** Instead of part_of_loads: the value of the histories at that time [s]. */
    std::optional<double> time        = {};
    bool                  centrifugal = false; ///< at each body's rate
    /** Centrifugal force acts on the displaced mass: K - rate^2 S instead of K. */
    bool spin_softening = false;
    /** The tangent stiffness at the state of spin instead of that of the undeformed bodies. */
    bool stress_stiffness = false;
    /** At the model's nodes, fixed frame [N]; empty: none. */
    std::vector<Vector3> nodal_forces;
    /** Force per volume at a place of the fixed frame [N/mm^3]; empty: none. */
    std::function<Vector3(const Vector3 &)> body_force;
  };

  struct StaticResult
  {
    /** Of all points of the space, 3 a point, fixed frame [mm]; equal on all ranks. */
    std::vector<double> displacements;
    /** What constraints exert on all points, 3 a point [N]: zero but for the solver's tolerance
     * where nothing is held. */
    std::vector<double> reactions;
    double              strain_energy = 0; ///< of bodies and springs to the ground [mJ]
    bool         turns = false; ///< bodies spin, and feel the mean of their bearings over all turns
    unsigned int n_iterations = 0; ///< of the last linear system; 0: direct solver
  };

  /**
   * Small displacements of some bodies of a model at rest; contact is not looked at. Constraints
   * are as in explicit dynamics, a prescribed rotation holds its nodes (in the turning axes) but
   * for its angle; loads act as on the undeformed bodies.
   */
  class StaticSolver
  {
  public:
    /**
     * @p rotation: of hubs that turn freely; pinned ones carry no moment about the axis. Throws
     * InputError, naming the motion, where a body can move rigidly. Collective.
     */
    StaticSolver(const Model                     &model,
                 const std::vector<unsigned int> &bodies,
                 const FemOptions                &options,
                 const Communicator              &communicator,
                 HubRotation                      rotation = HubRotation::free);

    const FemSpace &space() const
    {
      return space_;
    }

    /** Collective; throws NumericalError where the solver fails or the state of spin is not
     * stable. */
    StaticResult solve(const StaticLoads &loads) const;

  private:
    /** K u less what acts on the bodies, of all points [N]; adds up the strain energy [mJ]. */
    std::vector<double>  balance(const SystemMatrices      &matrices,
                                 const StaticLoads         &loads,
                                 const std::vector<double> &u,
                                 const std::vector<double> &spun,
                                 double                    &strain_energy) const;
    std::vector<double>  make_forces(const StaticLoads &loads) const;
    SystemMatrices::Rate body_rate(const StaticLoads &loads) const;
    /** What solves with @p K, which it checks to be positive. */
    LinearSolve
    prepare(const SystemMatrices &matrices, FemMatrix K, unsigned int &n_iterations) const;

    const Model              &model_;
    FemOptions                options_;
    const Communicator       &communicator_;
    FemSpace                  space_;
    HubRotation               rotation_;
    std::vector<unsigned int> pinned_; ///< shafts that turn freely in their bearings
  };

  /** Throws InputError for a body with so many free rigid motions, if there are any. */
  void refuse_free_motions(const Body &body, std::size_t n);

  /**
   * Stresses at all points (xx yy zz xy yz zx, fixed frame [MPa]) under their displacements (3 a
   * point), averages of the values of the elements that meet there. Values at the Gauss points of
   * the elements are extrapolated by the functions through them.
   */
  std::vector<Stress> compute_stresses(const FemSpace            &space,
                                       const std::vector<double> &displacements);

  /** Of values at all points those at the model's nodes; zero on bodies that are not part of the
   * space. */
  std::vector<Stress> take_nodes(const FemSpace &space, const std::vector<Stress> &stresses);

  /** The same of compute_stresses(). */
  std::vector<Stress> compute_node_stresses(const FemSpace            &space,
                                            const std::vector<double> &displacements);
} // namespace vfife

#endif
