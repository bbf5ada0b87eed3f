// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_dynamics_one_solver_h
#define vfife_tests_dynamics_one_solver_h

#include "../model_parts.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/timers.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/mesh/primitives/primitives.h>

#include <functional>
#include <iostream>

/** A solver with what it refers to, without damping, ready to run from the undeformed bodies. */
struct OneSolver
{
  vfife::DynamicsOptions options;
  vfife::Communicator    communicator;
  vfife::Log             log;
  vfife::Timers          timers;
  vfife::ExplicitSolver  solver;
  vfife::State           state;

  explicit OneSolver(const vfife::Model &model, const vfife::DynamicsOptions &dynamics_options)
    : options(dynamics_options)
    , communicator(MPI_COMM_SELF)
    , log(std::cerr, true, vfife::Verbosity::quiet)
    , solver(model, options, communicator, log, timers)
  {
    solver.set_step(solver.stable_step());
    solver.start(state);
  }
};

/** Contact of a surface of body 0 with one of body 1. */
inline vfife::ContactPair contact_of(const std::string              &side,
                                     const std::string              &slave_surface,
                                     const std::string              &master_surface,
                                     const vfife::ContactSurfaceKind kind)
{
  vfife::ContactPair pair = contact_of(side, {0, slave_surface}, {1, master_surface});
  pair.options.surface    = kind;
  return pair;
}

inline vfife::DynamicsOptions undamped()
{
  vfife::DynamicsOptions options;
  options.damping      = 0;
  options.mesh_damping = 0;
  return options;
}

/** Calls a function with every so many states. */
class Watcher : public vfife::Observer
{
public:
  using Function = std::function<void(const vfife::State &)>;

  Watcher(const unsigned int every, const Function &function)
    : every_(every)
    , function_(function)
  {
  }

  bool due(const vfife::State &state) const override
  {
    return state.step % every_ == 0;
  }

  void observe(const vfife::Model &, const vfife::State &state) override
  {
    function_(state);
  }

private:
  unsigned int every_;
  Function     function_;
};

inline vfife::Observers watch(const unsigned int every, const Watcher::Function &function)
{
  vfife::Observers observers;
  observers.push_back(std::make_unique<Watcher>(every, function));
  return observers;
}

/** Momentum and angular momentum about the origin, velocities half a step back [t mm/s, t mm^2/s].
 */
struct Momentum
{
  vfife::Vector3 linear  = vfife::Vector3::Zero();
  vfife::Vector3 angular = vfife::Vector3::Zero();

  Momentum(const vfife::State &state, const std::vector<double> &masses)
  {
    for (std::uint32_t i = 0; i < state.partition->n_local(); ++i)
      {
        // x(t) - dt v(t - dt/2)/2 is the middle of the step; its part along v adds nothing to x
        // cross v
        const vfife::Vector3 p = masses[i] * state.node_velocity(i);
        linear += p;
        angular += state.node_position(i).cross(p);
      }
  }
};

#endif
