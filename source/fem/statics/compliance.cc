// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/fem/solvers/sparse_matrix.h>
#include <vfife/fem/statics/compliance.h>
#include <vfife/fem/system/fem_constraints.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/fem/system/rigid_motions.h>
#include <vfife/fem/system/spin_state.h>
#include <vfife/fem/system/turn_pins.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** Right sides solved for at once. */
    constexpr unsigned int block = 32;
  } // namespace

  Compliance::Compliance(const Model        &model,
                         const FemOptions   &options,
                         const bool          centrifugal,
                         const Communicator &communicator,
                         const Factorized    factorized)
    : model_(model)
    , communicator_(communicator)
    , space_(model, all_bodies(model), options)
    // What a housing joins is a part of the law that who asks adds.
    , rings_(space_, HousingLaw::own_seats)
    , averages_(space_)
    , facet_parts_(space_)
  {
    // One rate gives the bearings' stiffness and the centrifugal forces of a state.
    if (model_.has_initial_strains() && !model.bearings.empty() && model.any_body_turns() &&
        !centrifugal)
      throw InputError("expected centrifugal = yes for rotating bodies in bearings that have a "
                       "temperature, got no. Set centrifugal = yes or temperature = 0.");
    check_motions();
    spun_.assign(3 * static_cast<std::size_t>(space_.n_points()), 0.);
    if (factorized == Factorized::bodies || !factorize_sectors(options, centrifugal))
      factorize_bodies(options, centrifugal);

    // The traction of the torque bends the bodies at every position alike; contact is
    // added by who asks.
    std::vector<double> forces(spun_.size(), 0.);
    for (const Torque &torque : model.torques)
      if (const auto *part = space_.find_part(torque.body))
        add_torque_forces(torque, space_, *part, torque.value, forces);
    twisted_ = solve(forces);
  }

  bool Compliance::factorize_sectors(const FemOptions &options, const bool centrifugal)
  {
    FemOptions turning = options;
    turning.hold_hubs  = false;
    try
      {
        for (const FemSpace::Part &part : space_.parts())
          {
            const double rate = centrifugal ? model_.bodies[part.body].rate : 0.;
            sectors_.push_back({std::make_unique<CyclicStatics>(
                                  space_, part, turning, rate, make_supports(part), communicator_),
                                3 * std::size_t(part.first_point),
                                3 * std::size_t(part.n_points),
                                {}});
            if (rate == 0. || !hangs_in_bearings(model_, part.body))
              continue;
            const CyclicStatics &statics = *sectors_.back().statics;
            if (auto standing = find_standing_motion(
                  space_,
                  part,
                  [&](const auto &u) { return statics.apply_stiffness(u); },
                  [&](const auto &u) { return statics.apply_mass(u); }))
              standing_.push_back(std::move(*standing));
          }
      }
    catch (const InputError &)
      {
        // A body without equal sectors, or something that is not alike in all of them: no error
        // here. What is one is met again by the whole bodies.
        sectors_.clear();
        standing_.clear();
        return false;
      }
    for (const SectorBody &body : sectors_)
      {
        n_unknowns_ += body.statics->n_unknowns();
        const std::vector<double> spun = body.statics->spun();
        std::copy(spun.begin(), spun.end(), spun_.begin() + body.first);
      }
    return true;
  }

  BodySupports Compliance::make_supports(const FemSpace::Part &part) const
  {
    const auto rate         = [this](const unsigned int body) { return model_.bodies[body].rate; };
    const Eigen::MatrixXd K = rings_.stiffness(rate) + make_turn_pins(space_, rings_, pinned_);
    // Rings have their own seats, and those of other bodies do not meet them.
    BodySupports              supports;
    std::vector<Eigen::Index> rows;
    for (std::size_t i = 0; i < rings_.list().size(); ++i)
      if (rings_.list()[i].body == part.body)
        {
          supports.motions.push_back(rings_.list()[i]);
          for (unsigned int &point : supports.motions.back().points)
            point -= part.first_point;
          for (unsigned int c = 0; c < 6; ++c)
            rows.push_back(6 * i + c);
        }
    supports.stiffness.resize(rows.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows.size(); ++j)
        supports.stiffness(i, j) = K(rows[i], rows[j]);
    return supports;
  }

  void Compliance::factorize_bodies(const FemOptions &options, const bool centrifugal)
  {
    FemConstraints::Options constraints;
    // A hub that turns freely would leave K singular; its turn is an unknown of who asks, and the
    // pin carries nothing in equilibrium.
    constraints.rotation = HubRotation::pinned;
    system_              = std::make_unique<FemSystem>(
      space_, constraints, communicator_, FemSystem::Links(), HousingLaw::own_seats);
    n_unknowns_ = system_->constraints().n();
    const SystemMatrices matrices(*system_, options.mass, options.strain);
    const auto rate = [this](const unsigned int body) { return model_.bodies[body].rate; };
    if (!centrifugal && !model_.has_initial_strains())
      {
        factorize(matrices.stiffness(rate), 0);
        return;
      }
    const auto rate_of_state = [&](const unsigned int body) {
      return centrifugal ? rate(body) : 0.;
    };
    // The factors that are left are those of the state of spin.
    spun_ =
      find_spin_state(matrices, rate_of_state, true, 0., "the bodies", [&](const FemMatrix &K) {
        find_standing_motions(matrices, K, rate_of_state);
        // Shifts and tilts may be faster than their bearings allow.
        factorize(K, 4 * standing_.size());
        return [this](OwnedVector &q) { solver_->solve(q.data(), 1); };
      }).displacements;
  }

  void Compliance::check_motions()
  {
    for (const FemSpace::Part &part : space_.parts())
      {
        const bool hub     = has_turning_hub(model_, part.body);
        bool       bearing = false;
        // In bearings alone only the driven body of a pair may turn: its turn is asked for.
        for (const Transmission &t : model_.transmissions)
          for (const Bearing &of_body : model_.bearings)
            bearing = bearing || (part.body == t.driven && part.body == of_body.body);
        const auto motions = find_free_motions(space_, part);
        if (motions.empty())
          continue;
        if (motions.size() > 1 || !(hub || bearing) || !is_turn(space_, part, motions.front()))
          throw InputError(
            "body \"" + model_.bodies[part.body].name() +
            "\" has rigid motions other than the rotation on its hub or, driven, in its bearings, "
            "so that it has no static equilibrium. Hold more of its nodes, or couple the driver");
        turning_.push_back(part.body);
        if (!hub)
          pinned_.push_back(part.body);
      }
  }

  bool Compliance::turns_freely(const unsigned int body) const
  {
    return std::find(turning_.begin(), turning_.end(), body) != turning_.end();
  }

  void Compliance::factorize(FemMatrix K, const unsigned int n_whirls)
  {
    K = add_turn_pins(*system_, pinned_, std::move(K));
    solver_.reset(); // its memory first
    solver_ = std::make_unique<DirectSolver>(K);
    if (solver_->n_negative() > n_whirls || solver_->n_zero() > 0)
      throw NumericalError("the bodies have no stable equilibrium: the speed is too high");
  }

  double Compliance::memory() const
  {
    if (!by_sectors())
      return solver_->memory();
    double sum = 0;
    for (const SectorBody &body : sectors_)
      sum += body.statics->memory();
    return communicator_.sum(sum);
  }

  std::vector<double> Compliance::solve(const std::vector<double> &forces) const
  {
    if (by_sectors())
      {
        std::vector<double> all(forces.size());
        for (const SectorBody &body : sectors_)
          {
            const auto begin = forces.begin() + body.first;
            if (std::all_of(begin, begin + body.n, [](const double f) { return f == 0.; }))
              continue;
            const std::vector<double> u = body.statics->solve({begin, begin + body.n});
            std::copy(u.begin(), u.end(), all.begin() + body.first);
          }
        return all;
      }
    OwnedVector q = system_->restrict_forces(forces);
    solver_->solve(q.data(), 1);
    return system_->expand(q);
  }

  void Compliance::watch(std::vector<unsigned int> points, std::vector<PointMotion> motions)
  {
    if (points == watched_ && motions.empty() && motions_.empty() && !columns_.empty())
      return;
    watched_ = std::move(points);
    motions_ = std::move(motions);
    weights_.clear();
    for (const unsigned int point : watched_)
      weights_.push_back(averages_.of(point));
    surface_points_ = facet_parts_.points_within(watched_);
    for (const unsigned int point : surface_points_)
      weights_.push_back(facet_parts_.mean_of(point));
    std::size_t n_rows = first_motion_row();
    for (const PointMotion &motion : motions_)
      n_rows += motion.motion.rows();
    columns_.assign(n_rows, Eigen::VectorXd());
    for (SectorBody &body : sectors_)
      {
        body.watched.clear();
        std::vector<CyclicStatics::Watched> of_body;
        for (unsigned int k = 0; k < weights_.size(); ++k)
          {
            const bool         on_part = k >= watched_.size();
            const unsigned int point = on_part ? surface_points_[k - watched_.size()] : watched_[k],
                               first = body.first / 3;
            if (point < first || point >= first + body.n / 3)
              continue;
            body.watched.push_back(k);
            of_body.push_back({point - first, weights_[k], on_part});
            for (auto &weight : of_body.back().weights)
              weight.first -= first;
          }
        body.statics->watch(std::move(of_body));
      }
  }

  Eigen::VectorXd Compliance::at_rows(const std::vector<double> &u) const
  {
    Eigen::VectorXd values(columns_.size());
    for (std::size_t k = 0; k < weights_.size(); ++k)
      values.segment<3>(3 * k) = compute_mean(weights_[k], u);
    std::size_t row = first_motion_row();
    for (const PointMotion &motion : motions_)
      {
        values.segment(row, motion.motion.rows()) = motion.displacement(u);
        row += motion.motion.rows();
      }
    return values;
  }

  std::vector<double> Compliance::spread(const Eigen::VectorXd &force) const
  {
    std::vector<double> all(spun_.size(), 0.);
    for (std::size_t k = 0; k < weights_.size(); ++k)
      for (const auto &[point, weight] : weights_[k])
        Eigen::Map<Vector3>(all.data() + 3 * std::size_t(point)) +=
          weight * force.segment<3>(3 * k);
    std::size_t row = first_motion_row();
    for (const PointMotion &motion : motions_)
      {
        motion.add_forces(force.segment(row, motion.motion.rows()), all);
        row += motion.motion.rows();
      }
    return all;
  }

  Eigen::MatrixXd Compliance::flexibility(const std::vector<unsigned int> &rows)
  {
    prepare(rows);
    Eigen::MatrixXd flexibility(rows.size(), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k)
      for (std::size_t i = 0; i < rows.size(); ++i)
        flexibility(i, k) = columns_[rows[k]][rows[i]];
    return flexibility;
  }

  void Compliance::prepare(const std::vector<unsigned int> &rows)
  {
    // Row 3 k + c is the component c at the watched or surface point k, then of motions. A column
    // of A = K^-1 is solved for when a force first acts there, and kept.
    std::vector<unsigned int> missing;
    for (const unsigned int row : rows)
      if (columns_[row].size() == 0)
        missing.push_back(row);
    std::sort(missing.begin(), missing.end());
    missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
    n_prepared_ += missing.size();

    if (by_sectors())
      prepare_sectors(missing);
    else
      add_columns(missing);
  }

  void Compliance::prepare_sectors(const std::vector<unsigned int> &rows)
  {
    // Motions are few and none of them is a copy of another. How points move them follows from
    // how they move points.
    const std::size_t first = first_motion_row(), n = columns_.size();
    for (std::size_t row = first; row < n && !rows.empty(); ++row)
      if (columns_[row].size() == 0)
        columns_[row] = at_rows(solve(spread(Eigen::VectorXd::Unit(n, row))));
    for (const unsigned int row : rows)
      if (row < first)
        {
          add_column(row);
          for (std::size_t motion = first; motion < n; ++motion)
            columns_[row][motion] = columns_[motion][row];
        }
  }

  void Compliance::add_column(const unsigned int row)
  {
    // The other bodies do not move under a force on this one.
    columns_[row] = Eigen::VectorXd::Zero(columns_.size());
    for (const SectorBody &body : sectors_)
      {
        const auto found = std::find(body.watched.begin(), body.watched.end(), row / 3);
        if (found == body.watched.end())
          continue;
        const Eigen::VectorXd u = body.statics->column(found - body.watched.begin(), row % 3);
        for (std::size_t i = 0; i < body.watched.size(); ++i)
          columns_[row].segment<3>(3 * body.watched[i]) = u.segment<3>(3 * i);
      }
  }

  void Compliance::add_columns(const std::vector<unsigned int> &rows)
  {
    // In blocks: MUMPS reads its factors once for each, and right sides stay few in memory.
    for (std::size_t first = 0; first < rows.size(); first += block)
      {
        const std::size_t   n = std::min<std::size_t>(block, rows.size() - first);
        std::vector<double> all;
        for (std::size_t i = first; i < first + n; ++i)
          {
            const OwnedVector q =
              system_->restrict_forces(spread(Eigen::VectorXd::Unit(columns_.size(), rows[i])));
            all.insert(all.end(), q.begin(), q.end());
          }
        solver_->solve(all.data(), n);
        const std::size_t n_own = all.size() / n;
        for (std::size_t i = 0; i < n; ++i)
          {
            const OwnedVector q(all.begin() + i * n_own, all.begin() + (i + 1) * n_own);
            columns_[rows[first + i]] = at_rows(system_->expand(q));
          }
      }
  }

  void Compliance::find_standing_motions(const SystemMatrices       &matrices,
                                         const FemMatrix            &stiffness,
                                         const SystemMatrices::Rate &rate)
  {
    standing_.clear();
    const SparseMatrix    K(stiffness);
    const Eigen::MatrixXd bearings = rings_.stiffness(rate);
    for (const FemSpace::Part &part : space_.parts())
      {
        if (rate(part.body) == 0. || !hangs_in_bearings(model_, part.body))
          continue;
        const std::size_t first = 3 * std::size_t(part.first_point),
                          n     = 3 * std::size_t(part.n_points);
        std::vector<double> all(spun_.size(), 0.);
        const auto          apply = [&](const std::vector<double> &u, const auto &system) {
          std::copy(u.begin(), u.end(), all.begin() + first);
          const std::vector<double> forces = system(all);
          return std::vector<double>(forces.begin() + first, forces.begin() + first + n);
        };
        // A body without constraints has its displacements for unknowns.
        auto standing = find_standing_motion(
          space_,
          part,
          [&](const std::vector<double> &u) {
            return apply(u, [&](const std::vector<double> &field) {
              std::vector<double> forces = system_->expand(K.apply(system_->restrict_field(field)));
              rings_.add_forces(-bearings * rings_.displacement(field), forces);
              return forces;
            });
          },
          [&](const std::vector<double> &u) {
            return apply(u, [&](const std::vector<double> &field) {
              return system_->expand(matrices.apply_mass(field));
            });
          });
        if (standing)
          standing_.push_back(std::move(*standing));
      }
  }
} // namespace vfife
