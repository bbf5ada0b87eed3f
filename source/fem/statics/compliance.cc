// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/fem/statics/compliance.h>
#include <vfife/fem/system/spin_state.h>
#include <vfife/fem/system/torque_forces.h>

#include <algorithm>
#include <numeric>

namespace vfife
{
  namespace
  {
    std::vector<unsigned int> all_bodies(const Model &model)
    {
      std::vector<unsigned int> bodies(model.bodies.size());
      std::iota(bodies.begin(), bodies.end(), 0u);
      return bodies;
    }

    /** Right sides solved for at once. */
    constexpr unsigned int block = 32;
  } // namespace

  Compliance::Compliance(const Model        &model,
                         const FemOptions   &options,
                         const bool          centrifugal,
                         const Communicator &communicator)
    : model_(model)
    , communicator_(communicator)
    , discretization_(model, all_bodies(model), options.element)
  {
    check_motions();
    Unknowns::Options unknowns;
    // A hub that turns freely would leave K singular; its turn is an unknown of who asks, and the
    // pin carries nothing in equilibrium.
    unknowns.rotation = HubRotation::pinned;
    assembly_         = std::make_unique<Assembly>(discretization_, unknowns, communicator);
    const SystemMatrices matrices(*assembly_, options.mass, options.strain);
    spun_.assign(3 * static_cast<std::size_t>(discretization_.n_points()), 0.);
    if (!centrifugal)
      factorize(matrices.stiffness());
    else
      // The factors that are left are those of the state of spin.
      spun_ = find_spin_state(
                matrices,
                [&model](const unsigned int body) { return model.bodies[body].rate; },
                true,
                0.,
                "the bodies have",
                [this](const SparseValues &K) {
                  factorize(K);
                  return [this](OwnedVector &q) { solver_->solve(q.data(), 1); };
                })
                .displacements;

    // The traction of the torque bends the bodies at every position alike; contact is
    // added by who asks.
    std::vector<double> forces(spun_.size(), 0.);
    for (const Torque &torque : model.torques)
      if (const auto *part = discretization_.find_part(torque.body))
        add_torque_forces(torque, discretization_, *part, torque.value, forces);
    twisted_ = solve(forces);
  }

  void Compliance::check_motions() const
  {
    for (const Discretization::Part &part : discretization_.parts())
      {
        unsigned int allowed = 0;
        for (const Constraint &constraint : model_.constraints)
          if (constraint.body == part.body && (constraint.kind == ConstraintKind::free_rotation ||
                                               constraint.kind == ConstraintKind::rigid_hub))
            allowed = 1;
        if (find_free_motions(discretization_, part).size() > allowed)
          throw InputError("body \"" + model_.bodies[part.body].name() +
                           "\" can move rigidly otherwise than by turning on its hub, so it has no "
                           "static equilibrium; hold more of its nodes");
      }
  }

  void Compliance::factorize(const SparseValues &K)
  {
    solver_.reset(); // its memory first
    solver_ = std::make_unique<DirectSolver>(assembly_->pattern(), K, communicator_);
    if (solver_->n_negative() > 0 || solver_->n_zero() > 0)
      throw NumericalError("the bodies have no stable state of spin: the speed is too high");
  }

  std::vector<double> Compliance::solve(const std::vector<double> &forces) const
  {
    OwnedVector q = assembly_->restrict_forces(forces);
    solver_->solve(q.data(), 1);
    return assembly_->expand(q);
  }

  void Compliance::watch(std::vector<unsigned int> points)
  {
    watched_ = std::move(points);
    columns_.assign(3 * watched_.size(), Eigen::VectorXd());
  }

  void Compliance::prepare(const std::vector<unsigned int> &rows)
  {
    // Row 3 k + c is the component c at the watched point k. A column of A = K^-1 is solved for
    // when a force first acts there, and kept.
    std::vector<unsigned int> missing;
    for (const unsigned int row : rows)
      if (columns_[row].size() == 0)
        missing.push_back(row);
    std::sort(missing.begin(), missing.end());
    missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
    n_prepared_ += missing.size();

    // In blocks: MUMPS reads its factors once for each, and right sides stay few in memory.
    std::vector<double> force(spun_.size(), 0.);
    for (std::size_t first = 0; first < missing.size(); first += block)
      {
        const std::size_t   n = std::min<std::size_t>(block, missing.size() - first);
        std::vector<double> all;
        for (std::size_t i = first; i < first + n; ++i)
          {
            double &entry       = force[3 * std::size_t(watched_[missing[i] / 3]) + missing[i] % 3];
            entry               = 1.;
            const OwnedVector q = assembly_->restrict_forces(force);
            all.insert(all.end(), q.begin(), q.end());
            entry = 0.;
          }
        solver_->solve(all.data(), n);
        const std::size_t n_own = all.size() / n;
        for (std::size_t i = 0; i < n; ++i)
          {
            const OwnedVector         q(all.begin() + i * n_own, all.begin() + (i + 1) * n_own);
            const std::vector<double> u      = assembly_->expand(q);
            Eigen::VectorXd          &column = columns_[missing[first + i]];
            column.resize(3 * watched_.size());
            for (std::size_t k = 0; k < watched_.size(); ++k)
              column.segment<3>(3 * k) = Eigen::Map<const Vector3>(u.data() + 3 * watched_[k]);
          }
      }
  }
} // namespace vfife
