// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/base/types.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/measures/pair_mounting.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/pressure/calibrated_penalty.h>
#include <vfife/study/run/pair_start.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** A round leaves some thousandths of what the one before has left, as the moved bodies are
     * not quite the ones that were factorized. */
    constexpr unsigned int largest_rounds = 20;
    /** Of two rounds: large rotations of slender parts leave membrane forces, which the next round
     * takes away. */
    constexpr double least_gain = 0.5;

    /** Mean static transmission error of the pair by quadratic or cubic elements [rad]; nothing
     * where they are not asked for or cannot be had, with the reason in the @p log. Collective. */
    std::optional<double> find_reference_error(const PairCase     &the_case,
                                               const Compliance   &own,
                                               const Communicator &communicator,
                                               Log                &log)
    {
      const auto warn = [&log](const std::exception &error) {
        log.warning("Contact/penalty elements: no elements of higher degree (", error.what(), ")");
      };
      try
        {
          const std::optional<Model> model = the_case.make_reference_model();
          if (!model)
            return std::nullopt;
          if (!own.by_sectors())
            {
              log.line("penalty elements: as the run, because the pair has bearings, couplings or "
                       "unequal sectors");
              return std::nullopt;
            }
          const auto start = WallClock::now();
          FemOptions fem;
          const bool is_cubic = the_case.reference_degree() == 3;
          fem.element         = is_cubic ? FemElement::cubic : FemElement::quadratic;
          fem.geometry        = FemGeometry::curved;
          fem.mass            = MassKind::lumped;
          Compliance   compliance(*model, fem, model->any_body_turns(), communicator);
          const double error = find_mean_error(the_case, compliance, *model);
          log.line("mean transmission error at rest by ",
                   is_cubic ? "cubic" : "quadratic",
                   " elements: ",
                   error / arcsecond,
                   " arcsec; the penalty is calibrated to it; found in ",
                   seconds_since(start),
                   " s");
          return error;
        }
      catch (const InputError &error)
        {
          // The pair's own mesh may be possible where the coarse one is not.
          warn(error);
        }
      catch (const NumericalError &error)
        {
          warn(error);
        }
      return std::nullopt;
    }

    /** The same with bodies of quadratic or cubic elements @p fem, whose facets are divided by the
     * points between nodes: nearer to the contact than facets that move as their nodes. */
    double find_divided_error(const PairCase     &the_case,
                              FemOptions          fem,
                              const Model        &model,
                              const Communicator &communicator,
                              Log                &log)
    {
      const auto start   = WallClock::now();
      fem.divides_facets = true;
      Compliance   compliance(model, fem, model.any_body_turns(), communicator);
      const double error = find_mean_error(the_case, compliance, model);
      log.line("mean transmission error at rest with divided facets: ",
               error / arcsecond,
               " arcsec; the penalty is calibrated to it; found in ",
               seconds_since(start),
               " s");
      return error;
    }
  } // namespace

  SettledPenalties settle_penalties(const PairCase     &the_case,
                                    const FemOptions   &fem,
                                    const Communicator &communicator,
                                    Log                &log,
                                    Model              &model)
  {
    SettledPenalties settled;
    if (!needs_calibration(the_case, model))
      return settled;
    settled.compliance =
      std::make_shared<Compliance>(model, fem, model.any_body_turns(), communicator);
    std::optional<double> reference;
    if (degree_of(fem.element) > 1)
      reference = find_divided_error(the_case, fem, model, communicator, log);
    else if ((reference = find_reference_error(the_case, *settled.compliance, communicator, log)))
      settled.figures.push_back({the_case.reference_degree() == 3
                                   ? "mean transmission error at rest, cubic elements"
                                   : figure_name::reference_error,
                                 {*reference / arcsecond, "arcsec"}});
    const std::vector<double> errors =
      calibrate_penalty(the_case, *settled.compliance, log, model, reference);
    if (!errors.empty())
      model.contacts.front().spring_errors = find_spring_errors(*settled.compliance, model, errors);
    return settled;
  }

  PairStart::PairStart(const Model                &model,
                       const DynamicsOptions      &options,
                       Relaxation                 &relaxation,
                       std::shared_ptr<Compliance> compliance,
                       const Communicator         &communicator,
                       Log                        &log)
    : model_(model)
    , relaxation_(relaxation)
    , communicator_(communicator)
    , compliance_(std::move(compliance))
  {
    // The nearer to the operator's elements, the faster the rounds.
    const auto start = WallClock::now();
    if (!compliance_)
      compliance_ = std::make_shared<Compliance>(model,
                                                 make_fem_options(options.stiffness),
                                                 model.any_body_turns(),
                                                 communicator);
    if (options.start == Start::steady_swing && !PairMounting::changes(model))
      static_errors_ = find_static_errors(*compliance_, model);
    // One position, the driver as it stands at time zero: nodes that may touch there are watched.
    pair_ = std::make_unique<PairEquilibrium>(model, *compliance_, std::vector<double>(1, 0.));
    log.line("  stiffness of ",
             compliance_->n_unknowns(),
             " unknowns factorized",
             compliance_->by_sectors() ? " by one sector of each body in " : " in ",
             seconds_since(start),
             " s, factors of ",
             compliance_->memory(),
             " MB");
  }

  std::size_t PairStart::point_of(const State          &state,
                                  const FemSpace::Part &part,
                                  const std::uint32_t   local) const
  {
    // Points of a body are in the order of its nodes, whatever rank and place the operator gives
    // them.
    return part.first_point + state.partition->global_node[local] -
           model_.bodies[part.body].first_node;
  }

  Matrix3 PairStart::rotation(const unsigned int body) const
  {
    return rotation_about(model_.bodies[body].axis.direction,
                          body == model_.only_transmission()->driven ? turn_ : 0.);
  }

  std::vector<double> PairStart::gather(const State &state, const NodeVector &vector) const
  {
    // Each rank fills in the nodes that it owns and leaves zeros elsewhere: after the sum all ranks
    // have all points. Collective.
    std::vector<double> all(3 * std::size_t(compliance_->space().n_points()), 0.);
    for (const FemSpace::Part &part : compliance_->space().parts())
      for (const std::uint32_t i : state.partition->owned_nodes(part.body))
        Eigen::Map<Vector3>(all.data() + 3 * point_of(state, part, i)) = vector(part.body, i);
    communicator_.sum(all);
    return all;
  }

  std::vector<double> PairStart::displacements(const State &state) const
  {
    // u = R^T (x - c) - (X - c), R the turn of the body since time zero
    std::vector<double> u = gather(state, [&](const unsigned int body, const std::uint32_t i) {
      const Vector3 &c = model_.bodies[body].axis.point;
      return Vector3(c + rotation(body).transpose() * (state.node_position(i) - c));
    });
    const std::vector<Vector3> &points = compliance_->space().points();
    for (std::size_t p = 0; p < points.size(); ++p)
      Eigen::Map<Vector3>(u.data() + 3 * p) -= points[p];
    return u;
  }

  std::vector<double> PairStart::turned_back(const State &state, const NodeField &forces) const
  {
    return gather(state, [&](const unsigned int body, const std::uint32_t i) {
      return Vector3(rotation(body).transpose() * forces.value(i));
    });
  }

  double PairStart::moment(const State &state, const NodeField &forces) const
  {
    // a . sum (x - c) x f over the driven body [N mm]. Collective.
    const unsigned int driven = model_.only_transmission()->driven;
    const Axis        &axis   = model_.bodies[driven].axis;
    double             sum    = 0;
    for (const std::uint32_t i : state.partition->owned_nodes(driven))
      sum += axis.direction.dot((state.node_position(i) - axis.point).cross(forces.value(i)));
    return communicator_.sum(sum);
  }

  void PairStart::place(const std::vector<double> &u, State &state) const
  {
    const std::vector<Vector3> &points = compliance_->space().points();
    for (const FemSpace::Part &part : compliance_->space().parts())
      {
        const Vector3 &c = model_.bodies[part.body].axis.point;
        const Matrix3  R = rotation(part.body);
        // x = c + R (X + u - c), on nodes that others own as well: all ranks know all of u.
        for (const std::uint32_t i : state.partition->nodes(part.body))
          {
            const std::size_t p = point_of(state, part, i);
            state.position.set(i,
                               c +
                                 R * (points[p] + Eigen::Map<const Vector3>(u.data() + 3 * p) - c));
          }
      }
    // The factors hold what is prescribed to first order only.
    relaxation_.constrain(state);
  }

  std::string PairStart::solve(State &state, const Relaxation::Loads &loads)
  {
    // u' = u + K^-1 r: the forces out of balance r are the operator's own, K is the conventional
    // stiffness in the turning axes, close enough to make r fall from round to round. Contact is
    // left out of r: the flanks are then pressed together by the torque that remains at the hub.
    // The pin of the factors holds the rotation, and carries nothing.
    Relaxation::Loads whole           = loads;
    whole.hold_rotation               = false;
    Relaxation::Loads without_contact = whole;
    without_contact.contact           = false;
    std::vector<double> residuals;
    std::ostringstream  text;
    for (unsigned int round = 0;; ++round)
      {
        // 1. What is out of balance, without contact (what is solved for) and with it (is it
        // enough?).
        const NodeField forces   = relaxation_.compute_forces(state, without_contact);
        const NodeField all      = relaxation_.compute_forces(state, whole);
        const double    residual = relaxation_.compute_residual(state, whole, all);
        if (residual < loads.looseness * relaxation_.options().tolerance)
          {
            set_figure_digits(text, 4);
            text << round << " contact iterations, relative residual " << residual;
            return text.str();
          }
        residuals.push_back(residual);
        // Gives up where numbers are lost, where rounds are used up, or where two of them have
        // gained too little: a single round may gain nothing.
        if (round == largest_rounds || !std::isfinite(residual) ||
            (round >= 3 && residual > least_gain * residuals[round - 2]))
          break;

        // 2. What both bodies do under it, in their turning axes, added to where they are.
        const std::vector<double> moved  = compliance_->solve(turned_back(state, forces));
        const std::vector<double> before = displacements(state);
        std::vector<double>       u      = before;
        for (std::size_t i = 0; i < u.size(); ++i)
          u[i] += moved[i];
        // 3. The flanks are pressed together; the driven member turns as that asks.
        if (loads.contact)
          {
            // The driver stands as at time zero; the torque is all that still turns the driven
            // body.
            const PairEquilibriumResult pressed =
              pair_->press(0., before, u, moment(state, forces));
            u     = pressed.displacements;
            turn_ = pressed.turn;
          }
        place(u, state);
      }
    // Relaxation needs no stiffness: it goes on from where the rounds have ended.
    return relaxation_.solve(state, loads).describe() + " after the rounds";
  }
} // namespace vfife
