// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "two_levels.h"

#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/fem/distributed/distributed_modes.h>
#include <vfife/fem/solvers/eigen_solver.h>
#include <vfife/fem/system/rigid_motions.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <functional>

namespace vfife
{
  namespace
  {
    /** Applies an operator on deal.II's vectors to one column after the other. */
    class OnUnknowns : public ColumnOperator
    {
    public:
      using Act = std::function<void(DistributedVector &, const DistributedVector &)>;

      OnUnknowns(const DistributedVector &like, Act act)
        : act_(std::move(act))
        , x_(like)
        , y_(like)
      {
      }

      void apply(const Columns &x, Columns &y) const override
      {
        for (std::size_t k = 0; k < x.n(); ++k)
          {
            copy_owned(x[k].data(), x_);
            act_(y_, x_);
            std::copy_n(y_.begin(), x.n_rows(), y[k].data());
          }
      }

    private:
      Act                       act_;
      mutable DistributedVector x_, y_;
    };

    Columns apply_to(const ColumnOperator &A, const Columns &x)
    {
      Columns y(x.communicator(), x.n_rows(), x.n());
      A.apply(x, y);
      return y;
    }
  } // namespace

  struct DistributedModes::Parts
  {
    EigenPairs find_pairs(const ColumnOperator &mass, double shift);
    /** By mode, the part of its kinetic energy in rigid motions that nothing opposes. */
    std::vector<double> find_rigid_shares(const ColumnOperator          &mass,
                                          const Columns                 &x,
                                          std::vector<DistributedVector> rigid,
                                          ModesAtSpeed                  &result) const;
    /** (x^T M r)^2, a row a motion and a column a mode. */
    Eigen::MatrixXd find_effective_masses(const Columns                        &x,
                                          const std::vector<DistributedVector> &rigid) const;
    /** Displacements of the body's nodes, scaled to one as the shape that is kept. */
    std::vector<double> add_shape(const OwnedVector &q);

    const Model        &model;
    unsigned int        body;
    FemOptions          options;
    const Communicator &communicator;
    FemSpace            nodes{model, {body}, FemElement::full}; ///< the body's own elements
    ModeDescriber       describer{nodes, nodes.parts()[0]};
    DistributedSpace    space{model.bodies[body], options, communicator};
    DistributedSupports supports{model, body, space.level()};
    ElasticOperator     elastic{space, supports, options.mass};
    std::vector<DistributedVector> shapes       = {};
    unsigned int                   n_iterations = 0;
  };

  DistributedModes::DistributedModes(const Model        &model,
                                     const unsigned int  body,
                                     const FemOptions   &options,
                                     const Communicator &communicator)
  {
    check_refinements(model, read_local_refinements(options.local_refinement));
    parts_.reset(new Parts{model, body, options, communicator});
  }

  DistributedModes::~DistributedModes() = default;

  EigenPairs DistributedModes::Parts::find_pairs(const ColumnOperator &mass, const double shift)
  {
    const unsigned int n = options.n_modes + n_guard_modes;
    // Anasazi has three blocks of n + 4 vectors.
    const unsigned int n_unknowns =
      communicator.sum(static_cast<unsigned int>(space.level().owned().n_elements()) -
                       static_cast<unsigned int>(supports.dependent().size()));
    if (3 * (n + 4) > n_unknowns)
      throw InputError("Fem/modes",
                       "expected at most a third of the unknowns less 10 (of " +
                         std::to_string(n_unknowns) + "), got " + std::to_string(options.n_modes) +
                         ". Set fewer modes or a finer mesh.");
    elastic.set_shift(-shift);
    const TwoLevels inverse(elastic, space, model, body, supports.lines(), options.mass, -shift);
    const DistributedVector like = elastic.make_unknowns();
    const OnUnknowns        shifted(like, [this](auto &y, const auto &x) { elastic.vmult(y, x); });
    const OnUnknowns        cycle(like, [this, &inverse](auto &y, const auto &x) {
      inverse.vmult(y, x);
      supports.clear_dependent(y);
    });
    const unsigned int      first =
      space.level().owned().n_elements() > 0 ? *space.level().owned().begin() : 0;
    return solve_lobpcg({mass, owned_part(elastic.mass_diagonal()), first, communicator},
                        shifted,
                        cycle,
                        shift,
                        n,
                        options.eigen_tolerance);
  }

  std::vector<double>
  DistributedModes::Parts::find_rigid_shares(const ColumnOperator          &mass,
                                             const Columns                 &x,
                                             std::vector<DistributedVector> rigid,
                                             ModesAtSpeed                  &result) const
  {
    const Eigen::MatrixXd free =
      find_free_coefficients(nodes, nodes.parts()[0], model.bodies[body].axis.point);
    result.n_rigid = free.cols();
    std::vector<double> shares(x.n(), 0.);
    if (free.cols() == 0)
      return shares;
    // Of x = R c + rest, the square of R c over that of x, in the product of M.
    const Columns         R(communicator, supports.unknowns_of(std::move(rigid)));
    const Columns         MR     = apply_to(mass, R);
    const Eigen::MatrixXd square = free.transpose() * R.products(MR) * free;
    const Eigen::MatrixXd along  = free.transpose() * MR.products(x);
    const Eigen::MatrixXd c      = square.ldlt().solve(along);
    const auto            whole  = x.dot(apply_to(mass, x));
    for (std::size_t k = 0; k < x.n(); ++k)
      shares[k] = along.col(k).dot(c.col(k)) / whole[k];
    return shares;
  }

  Eigen::MatrixXd
  DistributedModes::Parts::find_effective_masses(const Columns                        &x,
                                                 const std::vector<DistributedVector> &rigid) const
  {
    std::vector<OwnedVector> loads;
    for (const DistributedVector &motion : rigid)
      {
        DistributedVector load = elastic.mass_forces(motion);
        supports.condense(load);
        loads.push_back(owned_part(load));
      }
    return Columns(communicator, loads).products(x).array().square();
  }

  std::vector<double> DistributedModes::Parts::add_shape(const OwnedVector &q)
  {
    DistributedVector shape = space.level().make_vector();
    copy_owned(q.data(), shape);
    supports.lines().distribute(shape);
    std::vector<double> of_nodes = space.values_at_nodes(shape);
    double              largest  = 0;
    for (std::size_t i = 0; i < of_nodes.size(); i += 3)
      largest = std::max(largest, Eigen::Map<const Vector3>(of_nodes.data() + i).norm());
    for (double &value : of_nodes)
      value /= largest;
    shape /= largest;
    shape.update_ghost_values();
    shapes.push_back(std::move(shape));
    return of_nodes;
  }

  ModesAtSpeed DistributedModes::find_modes()
  {
    Parts           &p = *parts_;
    const OnUnknowns stiffness(p.elastic.make_unknowns(),
                               [&p](auto &y, const auto &x) { p.elastic.apply_stiffness(y, x); });
    const OnUnknowns mass(p.elastic.make_unknowns(),
                          [&p](auto &y, const auto &x) { p.elastic.apply_mass(y, x); });
    const double     shift = choose_shift(owned_part(p.elastic.stiffness_diagonal()),
                                      owned_part(p.elastic.mass_diagonal()),
                                      p.communicator);
    // The stiffness of a held body is positive definite.
    const bool is_free = !find_free_motions(p.nodes, p.nodes.parts()[0]).empty();
    EigenPairs pairs   = p.find_pairs(mass, is_free ? shift : 0.);
    pairs.values.resize(p.options.n_modes);
    pairs.vectors.resize(p.options.n_modes);
    p.n_iterations = pairs.n_iterations;
    const std::vector<double> residuals =
      compute_residuals(stiffness, mass, p.communicator, pairs, shift);
    check_orthogonality(compute_orthogonality_defect(mass, p.communicator, pairs.vectors));

    ModesAtSpeed result;
    result.axis_point = p.model.bodies[p.body].axis.point;
    result.n_unknowns = p.space.level().dofs().n_dofs();
    const Columns         x(p.communicator, pairs.vectors);
    const auto            rigid     = p.space.level().make_rigid_motions(result.axis_point);
    const auto            shares    = p.find_rigid_shares(mass, x, rigid, result);
    const Eigen::MatrixXd effective = p.find_effective_masses(x, rigid);
    p.shapes.clear();
    for (unsigned int k = 0; k < p.options.n_modes; ++k)
      {
        Mode mode;
        mode.eigenvalue = pairs.values[k];
        check_residual(residuals[k], mode.frequency());
        RotatingMode entry;
        entry.frequency = shares[k] > .5 ? 0. : mode.frequency();
        entry.residual  = residuals[k];
        for (unsigned int r = 0; r < 6; ++r)
          entry.effective_mass[r] = effective(r, k);
        entry.shape       = p.add_shape(pairs.vectors[k]);
        entry.description = p.describer.describe(entry.shape);
        result.modes.push_back(std::move(entry));
      }
    return result;
  }

  unsigned int DistributedModes::n_iterations() const
  {
    return parts_->n_iterations;
  }

  MeshFields DistributedModes::fields() const
  {
    MeshFields fields{parts_->space.level().dofs(), parts_->space.mapping(), {}};
    for (std::size_t k = 0; k < parts_->shapes.size(); ++k)
      fields.fields.emplace_back("mode_" + std::to_string(k + 1), &parts_->shapes[k]);
    return fields;
  }
} // namespace vfife
