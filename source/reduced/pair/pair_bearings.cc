// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/model.h>
#include <vfife/reduced/pair/pair_bearings.h>

namespace vfife
{
  using Eigen::MatrixXd;
  using Eigen::VectorXd;

  namespace
  {
    BearingSprings make_springs(const Model &model, const std::vector<ReducedBody> &bodies)
    {
      const Eigen::Index   n = 6 * model.bearings.size();
      std::vector<Vector3> centres(model.bearings.size());
      MatrixXd             linear = MatrixXd::Zero(n, n);
      for (unsigned int b = 0; b < bodies.size(); ++b)
        {
          // Along the axes of the body's frame, as rows of 3 x 3 blocks.
          const ReducedBody::Rings &rings  = bodies[b].rings;
          const auto               &placed = model.bodies[b].placement;
          std::vector<std::size_t>  places; // in Model::bearings
          for (std::size_t i = 0; i < model.bearings.size(); ++i)
            if (model.bearings[i].body == b)
              places.push_back(i);
          for (std::size_t i = 0; i < 2 * places.size(); ++i)
            {
              if (i % 2 == 0)
                centres[places[i / 2]] = placed(rings.centres[i / 2]);
              for (std::size_t k = 0; k < 2 * places.size(); ++k)
                linear.block<3, 3>(6 * places[i / 2] + 3 * (i % 2),
                                   6 * places[k / 2] + 3 * (k % 2)) =
                  placed.rotation * rings.stiffness.block<3, 3>(3 * i, 3 * k) *
                  placed.rotation.transpose();
            }
        }
      return {model, centres, linear, model.only_transmission()->arm};
    }
  } // namespace

  PairBearings::PairBearings(const Model                    &model,
                             const std::vector<ReducedBody> &bodies,
                             const PressedPair              &pair)
    : springs_(make_springs(model, bodies))
    , pair_(pair)
    , driver_(model.only_transmission()->driver)
  {
  }

  BearingSprings::Response PairBearings::evaluate(const VectorXd &u) const
  {
    return springs_.evaluate(u.tail(n_rows()), pair_.rotations(), pair_.kinematic_turns());
  }

  void PairBearings::begin_step(const double step)
  {
    before_ = present_;
    springs_.set_dampers(before_, step);
  }

  void PairBearings::end_step(const VectorXd &u)
  {
    if (springs_.has_dampers())
      damped_ = evaluate(u);
  }

  void PairBearings::set(const VectorXd &u)
  {
    springs_.set_dampers({}, 0.);
    present_ = evaluate(u);
  }

  std::vector<SeatState> PairBearings::measure(const bool has_stepped) const
  {
    std::vector<SeatState> states = present_.states;
    // Dampers have their mean force of the last step.
    if (springs_.has_dampers() && has_stepped)
      for (std::size_t i = 0; i < states.size(); ++i)
        states[i].load += .5 * (damped_.states[i].load - present_.states[i].load);
    return states;
  }

  void
  PairBearings::add_damping(const double driver_rate, const double step, EnergyLedger &energy) const
  {
    if (!springs_.has_dampers())
      return;
    for (std::size_t i = 0; i < damped_.states.size(); ++i)
      {
        const Vector5 force = .5 * (damped_.states[i].load - present_.states[i].load);
        energy.damping_loss -=
          force.dot(present_.states[i].displacement - before_.states[i].displacement);
      }
    energy.drive_work -=
      .5 * (damped_.torques[driver_] - present_.torques[driver_]) * driver_rate * step;
  }
} // namespace vfife
