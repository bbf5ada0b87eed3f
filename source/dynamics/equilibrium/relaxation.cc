// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/dynamics/equilibrium/relaxation.h>
#include <vfife/dynamics/equilibrium/standing_pattern.h>
#include <vfife/model/constraints/supports.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Elements and contact springs keep their largest frequency at this part of the limit of
     * central differences. */
    constexpr double stability_fraction = 0.9;

    constexpr unsigned int search_interval = 10;
    constexpr unsigned int report_interval = 500;

    /** Sums over the owned nodes of one step: what residual and damping follow from. */
    struct StepSums
    {
      std::vector<double> values = std::vector<double>(3, 0.);

      double &force_square()
      {
        return values[0];
      }
      double &work_of_change()
      {
        return values[1];
      }
      double &kinetic()
      {
        return values[2];
      }
    };

    /** Forces that may be round-off alone: they are where no step makes them smaller any more. */
    class Stagnation
    {
    public:
      /** Whether @p force has not fallen for many calls. */
      bool lasts(const double force)
      {
        if (force < .9 * least_)
          {
            least_ = force;
            calls_ = 0;
          }
        return ++calls_ > most_calls;
      }

    private:
      static constexpr unsigned int most_calls = 100;

      double       least_ = std::numeric_limits<double>::infinity();
      unsigned int calls_ = 0;
    };

    /** The sums over this rank's nodes. */
    StepSums add_steps(const Partition           &partition,
                       const std::vector<double> &masses,
                       const NodeField           &velocity,
                       const NodeField           &previous_forces,
                       const NodeField           &forces)
    {
      StepSums sums;
      for (const std::uint32_t i : partition.owned_nodes())
        {
          const Vector3 f = forces.value(i), v = velocity.value(i);
          sums.force_square() += f.squaredNorm();
          sums.work_of_change() -= v.dot(f - previous_forces.value(i));
          sums.kinetic() += masses[i] * v.squaredNorm();
        }
      return sums;
    }
  } // namespace

  Relaxation::Relaxation(const Model             &model,
                         const RelaxationOptions &options,
                         VfifeOperator           &vfife,
                         ContactSystem           &contact,
                         RigidWalls              &walls,
                         const Communicator      &communicator,
                         Log                     &log)
    : model_(model)
    , options_(options)
    , operator_(vfife)
    , contact_(contact)
    , walls_(walls)
    , communicator_(communicator)
    , log_(log)
    , torques_(model, vfife.partition())
    , loads_(model, vfife, communicator)
    , bearings_(model, vfife.partition(), communicator)
    , small_(model, vfife, communicator)
    , forces_(vfife.make_field())
    , no_velocity_(vfife.make_field())
  {
  }

  void Relaxation::add_applied(const State &state, const Loads &loads, NodeField &forces)
  {
    // Torques, forces of inertia of a standing pattern, loads of the model ...
    torques_.add_part(loads.torque, state.position, forces);
    if (loads.pattern != nullptr)
      loads.pattern->add_forces(operator_.masses(), forces);
    if (loads.part)
      loads_.add_part(*loads.part, state.position, forces);
    else
      loads_.add_forces(0., state.position, forces);
    // Bearings, of bodies that have not turned yet ...
    bearings_.add_forces_at_rest(state.position, forces);
    // ... and m omega^2 r in the frames that turn with the bodies, r in the deformed state.
    if (!loads.centrifugal)
      return;
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const Axis  &axis   = model_.bodies[b].axis;
        const double square = model_.bodies[b].rate * model_.bodies[b].rate;
        if (square > 0)
          for (const std::uint32_t i : state.partition->nodes(b))
            {
              const Vector3 r = state.node_position(i) - axis.point;
              forces.add(i,
                         operator_.masses()[i] * square *
                           (r - axis.direction.dot(r) * axis.direction));
            }
      }
  }

  double Relaxation::norm(const NodeField &forces, const Partition &partition) const
  {
    double sum = 0;
    for (const std::uint32_t i : partition.owned_nodes())
      sum += forces.value(i).squaredNorm();
    return std::sqrt(communicator_.sum(sum));
  }

  std::vector<double> Relaxation::compute_masses(const Loads &loads, const double dt)
  {
    if (options_.virtual_damping > 0)
      {
        // The true masses in units of the step, which contact and springs have voted on.
        std::vector<double> masses = operator_.masses();
        for (double &mass : masses)
          mass /= dt * dt;
        return masses;
      }
    // Fictitious ones: elements and springs alike have their largest frequency at the limit of a
    // pseudo step of 1.
    std::vector<double> masses = operator_.compute_relaxation_masses(stability_fraction);
    loads_.add_relaxation_masses(stability_fraction, masses);
    bearings_.add_relaxation_masses(stability_fraction, masses);
    if (loads.contact)
      {
        contact_.add_relaxation_masses(stability_fraction, masses);
        walls_.add_relaxation_masses(stability_fraction, masses);
      }
    return masses;
  }

  void Relaxation::add_contact(State &state, const bool search, NodeField &forces)
  {
    // The contact sees bodies at rest: no motion ahead for the search, no velocities for damping
    // and friction.
    const std::vector<RigidVelocity> at_rest(model_.bodies.size());
    // The preload of a gear pair is without friction; else points stick where the load step began.
    set_friction_mode(model_.transmissions.empty() ? FrictionMode::held : FrictionMode::none);
    if (search)
      contact_.search(state.body_motion, at_rest, state.position, 0.);
    contact_.add_forces(state.body_motion, state.position, no_velocity_, state.dt, forces);
    walls_.add_forces(state.position, forces);
  }

  void Relaxation::set_friction_mode(const FrictionMode mode)
  {
    contact_.set_friction_mode(mode);
    walls_.set_friction_mode(mode);
  }

  NodeField Relaxation::compute_all_forces(State &state, const Loads &loads)
  {
    NodeField forces = operator_.make_field();
    small_.read(state);
    small_.compute_internal_forces(state, forces);
    if (loads.contact)
      add_contact(state, true, forces);
    add_applied(state, loads, forces);
    set_friction_mode(FrictionMode::follows);
    return forces;
  }

  NodeField Relaxation::compute_forces(State &state, const Loads &loads)
  {
    NodeField forces = compute_all_forces(state, loads);
    ConstraintMotion(model_, *state.partition, communicator_)
      .project(state.position, forces, !loads.hold_rotation);
    return forces;
  }

  std::vector<Reaction> Relaxation::compute_reactions(State &state, const Loads &loads)
  {
    const ConstraintMotion constraints(model_, *state.partition, communicator_);
    const NodeField        forces    = compute_all_forces(state, loads);
    NodeField              projected = forces;
    constraints.project(state.position, projected, !loads.hold_rotation);

    std::vector<Reaction> reactions(list_supports(model_).size());
    constraints.add_static_reactions(state.position, forces, projected, reactions);
    loads_.add_spring_reactions(state.position, reactions);
    bearings_.add_reactions(state.position, first_bearing(model_), reactions);
    sum_over_ranks(reactions, communicator_);
    return reactions;
  }

  double
  Relaxation::compute_residual(const State &state, const Loads &loads, const NodeField &forces)
  {
    NodeField applied = operator_.make_field();
    add_applied(state, loads, applied);
    small_.add_strain_forces(applied);
    const double round_off = find_round_off(state, compute_masses(loads, state.dt), 1.);
    return norm(forces, *state.partition) /
           std::max(norm(applied, *state.partition), round_off / options_.tolerance);
  }

  void Relaxation::constrain(State &state) const
  {
    ConstraintMotion constraints(model_, *state.partition, communicator_);
    constraints.read(state, MotionFrame::rotating);
    place(state, constraints);
    constraints.turn_bodies(model_, state);
  }

  void Relaxation::place(State &state, ConstraintMotion &constraints) const
  {
    // A step without forces, from which the constrained nodes come back where they belong.
    const NodeField       zero     = operator_.make_field();
    NodeField             velocity = zero;
    std::vector<BodySums> ignored(model_.bodies.size());
    constraints.save(state.position, velocity);
    constraints.apply(0.,
                      1.,
                      MotionFrame::rotating,
                      std::vector<BodyDamping>(model_.bodies.size()),
                      zero,
                      state.position,
                      velocity,
                      ignored);
  }

  double Relaxation::find_round_off(const State               &state,
                                    const std::vector<double> &masses,
                                    const double               scale)
  {
    // 4 eps |M x|: the masses are about the stiffness at a node, pseudo step 1. Those of elements
    // see scaled displacements about the body's middle, those of springs and contacts do not.
    const std::vector<double> of_elements =
      options_.virtual_damping > 0 ? masses
                                   : operator_.compute_relaxation_masses(stability_fraction);
    NodeField forces = operator_.make_field();
    for (const std::uint32_t i : state.partition->nodes())
      forces.set(i,
                 of_elements[i] / scale * small_.local_place(i) +
                   (masses[i] - of_elements[i]) * state.node_position(i));
    return 4. * std::numeric_limits<double>::epsilon() * norm(forces, *state.partition);
  }

  RelaxationReport Relaxation::solve(State &state, const Loads &loads)
  {
    // 1. Masses, and constraints in the turning frames; held rotations are those of infinite mass.
    const std::vector<double> masses = compute_masses(loads, state.dt);

    ConstraintMotion constraints(model_, *state.partition, communicator_);
    if (loads.part)
      constraints.set_part(*loads.part);
    constraints.read(state, MotionFrame::rotating);
    constraints.set_masses(
      loads.hold_rotation ? std::vector<double>(masses.size(), std::numeric_limits<double>::max())
                          : masses);

    // 2. What is prescribed goes where it belongs before the first look at the forces, which would
    // find equilibrium in the old place.
    place(state, constraints);
    small_.read(state);

    // 3. What forces are measured by.
    NodeField applied = operator_.make_field();
    add_applied(state, loads, applied);
    small_.add_strain_forces(applied);
    const double applied_norm = norm(applied, *state.partition),
                 unscaled     = find_round_off(state, masses, 1.);
    double round_off = unscaled, scale = 1, reference = applied_norm;

    // 4. Pseudo time steps M a + c M v = F until the residual is small.
    NodeField        velocity = operator_.make_field(), previous = operator_.make_field();
    const bool       adaptive = !(options_.virtual_damping > 0);
    double           damping  = adaptive ? 1. : options_.virtual_damping * state.dt;
    RelaxationReport report;
    Stagnation       stagnation;
    std::string      history;
    for (;; ++report.steps)
      {
        // Forces; contact candidates and the bodies' mean turn now and then.
        const bool searches = report.steps % search_interval == 0;
        if (searches)
          constraints.turn_bodies(model_, state);
        small_.choose_scale(unscaled > options_.tolerance * reference);
        if (small_.scale() != scale)
          round_off = find_round_off(state, masses, small_.scale());
        scale = small_.scale();
        small_.compute_internal_forces(state, forces_);
        if (loads.contact)
          add_contact(state, searches, forces_);
        add_applied(state, loads, forces_);
        // Where nothing is applied but displacements, the present reactions are what forces are
        // measured by.
        if (!(applied_norm > 0))
          reference = norm(forces_, *state.partition);
        constraints.project(state.position, forces_, !loads.hold_rotation);

        // The residual decides: reached, diverged, or too slow.
        StepSums sums = add_steps(*state.partition, masses, velocity, previous, forces_);
        communicator_.sum(sums.values);
        const double unbalanced = std::sqrt(sums.force_square());
        report.residual         = unbalanced > 0 ? unbalanced / reference : 0.;
        report.at_round_off     = false;
        if (report.residual < loads.looseness * options_.tolerance)
          break;
        // Round-off is no imbalance: both may be small, as of a rigid turn or a slow spin.
        report.at_round_off =
          unbalanced < loads.looseness * round_off && stagnation.lasts(unbalanced);
        if (report.at_round_off)
          break;
        watch(report, damping, history);

        // Critical damping of the lowest mode that moves, from the stiffness which the last step
        // has met: omega^2 = -v . (f - f_old)/sum m v . v, c = min(1.9, 2 omega) (Underwood 1983).
        if (adaptive && sums.kinetic() > 0 && sums.work_of_change() > 0)
          damping = std::min(1.9, 2. * std::sqrt(sums.work_of_change() / sums.kinetic()));
        previous = forces_;
        move(state, masses, damping, constraints, velocity);
      }
    // Whoever evaluates this state next takes the anchors along with what has slid.
    set_friction_mode(FrictionMode::follows);
    return report;
  }

  void Relaxation::watch(const RelaxationReport &report, const double damping, std::string &history)
  {
    if (!std::isfinite(report.residual))
      throw NumericalError("the equilibrium diverged at relaxation step " +
                           std::to_string(report.steps));
    if (report.steps % report_interval == 0)
      {
        history += " " + std::to_string(report.residual);
        log_.detail("  relaxation step ",
                    report.steps,
                    ": residual ",
                    report.residual,
                    ", damping ",
                    damping);
      }
    if (report.steps >= options_.largest_steps)
      throw NumericalError("the equilibrium was not reached in " + std::to_string(report.steps) +
                           " relaxation steps (Dynamics/Relaxation); residual every " +
                           std::to_string(report_interval) + " steps:" + history);
  }

  void Relaxation::move(State                     &state,
                        const std::vector<double> &masses,
                        const double               damping,
                        ConstraintMotion          &constraints,
                        NodeField                 &velocity)
  {
    // v+ = ((1 - c/2) v- + f/m)/(1 + c/2), x += v+, then the constrained nodes.
    constraints.save(state.position, velocity);
    const double keep = (1. - 0.5 * damping) / (1. + 0.5 * damping),
                 gain = 1. / (1. + 0.5 * damping);
    for (const std::uint32_t i : state.partition->nodes())
      {
        const Vector3 v = keep * velocity.value(i) + gain * forces_.value(i) / masses[i];
        velocity.set(i, v);
        state.position.set(i, small_.place_after(i, v));
      }

    // Nodes that turn freely or are led in some directions are damped by the same factors.
    BodyDamping virtual_damping;
    virtual_damping.zeta = damping;
    std::vector<BodySums> ignored(model_.bodies.size());
    constraints.apply(0.,
                      1.,
                      MotionFrame::rotating,
                      std::vector<BodyDamping>(model_.bodies.size(), virtual_damping),
                      forces_,
                      state.position,
                      velocity,
                      ignored);
    for (const std::uint32_t i : state.partition->nodes())
      small_.follow(i, velocity.value(i), state);
  }

  std::string RelaxationReport::describe() const
  {
    std::ostringstream text;
    set_figure_digits(text, 4);
    text << steps << " relaxation steps, residual " << residual
         << (at_round_off ? " (round-off)" : "");
    return text.str();
  }
} // namespace vfife
