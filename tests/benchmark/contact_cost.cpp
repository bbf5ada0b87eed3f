// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact_cost.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/timers.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/sample_measures.h>
#include <vfife/contact/pass/contact_pass.h>
#include <vfife/dynamics/loop/explicit_solver.h>

#include <array>

namespace vfife
{
  namespace
  {
    constexpr double       closing = 0.012; ///< of the flanks at the mean contact [mm]
    constexpr unsigned int n_steps = 200;   ///< of one measurement

    /** Times of a step [s], in the order of the table. */
    using StepTimes = std::array<double, 9>;

    /** The bodies of a pair, turning rigidly, and their arrays. */
    class TurningPair
    {
    public:
      TurningPair(const Model &model, ExplicitSolver &solver)
        : model_(model)
        , solver_(solver)
      {
        solver.start(state_);
        positions_  = state_.position;
        velocities_ = state_.velocity;
        forces_     = solver.vfife_operator().make_field();
        for (const Body &body : model.bodies)
          {
            RigidVelocity rate;
            rate.omega    = body.rate * body.axis.direction;
            rate.velocity = -rate.omega.cross(body.axis.point);
            rates_.push_back(rate);
          }
        const Transmission &t = *model.only_transmission();
        // Turned back against the drive by closing/arm: at the mean contact the flanks then lie
        // `closing` in each other.
        closed_ =
          rotation_about(model.bodies[t.driven].axis.direction, -t.driven_sense * closing / t.arm);
      }

      /** Places the bodies at a time [s] of their turning. */
      void place(const double time)
      {
        for (unsigned int b = 0; b < model_.bodies.size(); ++b)
          {
            const Body   &body = model_.bodies[b];
            const Matrix3 turn =
              rotation_about(body.axis.direction, body.rate * time) *
              (b == model_.only_transmission()->driven ? closed_ : Matrix3::Identity());
            RigidMotion &motion = state_.body_motion[b];
            motion.rotation     = turn * body.placement.rotation;
            motion.translation =
              body.axis.point + turn * (body.placement.translation - body.axis.point);
            for (const std::uint32_t i : state_.partition->nodes(b))
              state_.position.set(
                i,
                motion(body.node_positions()[state_.partition->global_node[i] - body.first_node]));
          }
      }

      /** One step, its times added to @p times. */
      void add_step(const unsigned int step, const double dt, StepTimes &times)
      {
        place(step * dt);
        // Times go where StepTimes has them: 0 internal forces, 1 update, 2 contact.
        double     last     = processor_time();
        const auto add_time = [&](const unsigned int part) {
          const double now = processor_time();
          times[part] += now - last;
          last = now;
        };
        solver_.vfife_operator().compute_internal_forces(state_.position, forces_);
        add_time(0);
        ContactSystem &contact = solver_.contact();
        if (step % ExplicitSolver::search_interval == 0)
          contact.search(state_.body_motion,
                         rates_,
                         state_.position,
                         ExplicitSolver::search_interval * dt);
        contact.add_forces(state_.body_motion, state_.position, state_.velocity, dt, forces_);
        add_time(2);
        // The update works on copies: the forces are not followed.
        for (unsigned int b = 0; b < model_.bodies.size(); ++b)
          update_nodes(state_.partition->first_local_node[b],
                       state_.partition->first_local_node[b + 1],
                       dt,
                       BodyDamping(),
                       UpdateAxis::of(model_.bodies[b]),
                       {state_.partition->owned.data(),
                        forces_.data(),
                        positions_.data(),
                        velocities_.data(),
                        positions_.data(),
                        velocities_.data()});
        add_time(1);
      }

    private:
      const Model               &model_;
      ExplicitSolver            &solver_;
      State                      state_;
      std::vector<RigidVelocity> rates_;
      NodeField                  positions_, velocities_, forces_;
      Matrix3                    closed_;
    };

    StepTimes measure(TurningPair &pair, ContactSystem &contact, const double dt)
    {
      StepTimes    times = {};
      ContactTimes parts;
      pair.add_step(0, dt, times); // fills caches and lists
      times = {};
      contact.measure_times(&parts);
      for (unsigned int step = 1; step <= n_steps; ++step)
        pair.add_step(step, dt, times);
      contact.measure_times(nullptr);
      // Places 3 to 7 are the parts of the contact that it measures itself, 8 is what they leave:
      // nodes copied to and fro.
      const std::array<double, 5> known = {
        {parts.broad_search, parts.wide_search, parts.motion, parts.projection, parts.forces}};
      times[8] = times[2];
      for (unsigned int i = 0; i < known.size(); ++i)
        {
          times[3 + i] = known[i];
          times[8] -= known[i];
        }
      for (double &t : times)
        t /= n_steps;
      return times;
    }
  } // namespace

  Table measure_contact_cost(const Model        &model,
                             const unsigned int  repeats,
                             const Communicator &communicator,
                             Log                &log)
  {
    // The pair turns rigidly at its speeds: what touches changes as in a run, but not by its
    // forces, so that every round measures the same.
    Timers         timers;
    ExplicitSolver solver(model, DynamicsOptions(), communicator, log, timers);
    const double   dt = solver.stable_step();
    solver.set_step(dt);
    TurningPair pair(model, solver);

    std::array<std::vector<double>, std::tuple_size<StepTimes>::value> samples;
    for (unsigned int round = 0; round < repeats; ++round)
      {
        const StepTimes times = measure(pair, solver.contact(), dt);
        for (unsigned int i = 0; i < times.size(); ++i)
          samples[i].push_back(1e6 * times[i]);
      }

    // What the last step has pressed says how much contact the times are of.
    double area = 0, force = 0;
    for (const ToothContact &tooth : solver.contact().collect_results())
      {
        area += tooth.area;
        force += tooth.normal_force;
      }
    log.line("contact of the pair closed by ",
             1e3 * closing,
             " um: ",
             area,
             " mm^2 in contact, ",
             1e-3 * force,
             " kN, ",
             solver.contact().n_listed_points(),
             " points listed");

    const std::array<const char *, std::tuple_size<StepTimes>::value> names = {
      {"internal forces",
       "nodal update",
       "contact",
       "contact: broad search",
       "contact: wide search",
       "contact: motion of the groups",
       "contact: projection",
       "contact: forces",
       "contact: nodes to and fro"}};
    std::array<double, std::tuple_size<StepTimes>::value> medians;
    for (unsigned int i = 0; i < medians.size(); ++i)
      medians[i] = median_of(samples[i]);
    Table table{{"part"}, {"time", "us"}, {"share", "%"}};
    // Shares are of a step: forces, update and contact; the rest are parts of the contact.
    const double step = medians[0] + medians[1] + medians[2];
    for (unsigned int i = 0; i < medians.size(); ++i)
      table.add_row({names[i], medians[i], 100. * medians[i] / step});
    return table;
  }
} // namespace vfife
