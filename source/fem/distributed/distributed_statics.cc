// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "distributed_loads.h"
#include "two_levels.h"

#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/fem/distributed/distributed_statics.h>
#include <vfife/fem/system/rigid_motions.h>
#include <vfife/model/constraints/supports.h>

#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  struct DistributedStatics::Parts
  {
    double factor_of(const ParameterHistory &history, const StaticLoads &loads) const
    {
      return loads.time ? history.value(*loads.time) : loads.part_of_loads;
    }
    DistributedVector     make_forces(const StaticLoads &loads) const;
    DistributedVector     solve(const DistributedVector &forces, unsigned int &n_iterations) const;
    void                  add_nodes(NodalSolution &solution) const;
    std::vector<Reaction> find_reactions(const DistributedVector &forces) const;

    const Model        &model;
    unsigned int        body;
    FemOptions          options;
    const Communicator &communicator;
    DistributedSpace    space{model.bodies[body], options, communicator};
    DistributedSupports supports{model, body, space.level()};
    ElasticOperator     stiffness{space, supports, MassKind::consistent};
    TwoLevels inverse{stiffness, space, model, body, supports.lines(), MassKind::consistent, 0.};
    DistributedVector displacements = {};
  };

  DistributedStatics::DistributedStatics(const Model        &model,
                                         const unsigned int  body,
                                         const FemOptions   &options,
                                         const Communicator &communicator)
  {
    // The body's own nodes tell which rigid motions are free.
    const FemSpace nodes(model, {body}, FemElement::full);
    refuse_free_motions(model.bodies[body], find_free_motions(nodes, nodes.parts()[0]).size());
    check_refinements(model, read_local_refinements(options.local_refinement));
    parts_.reset(new Parts{model, body, options, communicator});
  }

  DistributedStatics::~DistributedStatics() = default;

  DistributedVector DistributedStatics::Parts::make_forces(const StaticLoads &loads) const
  {
    DistributedLoads acting(model, space);
    for (const Torque &torque : model.torques)
      if (torque.body == body)
        acting.add_torque(torque, loads.part_of_torques * torque.value);
    for (const Load &load : model.loads)
      if (load.body == body)
        acting.add_load(load, factor_of(load.history, loads));
    return acting.finish();
  }

  DistributedVector DistributedStatics::Parts::solve(const DistributedVector &forces,
                                                     unsigned int            &n_iterations) const
  {
    DistributedVector b = stiffness.make_unknowns(), q(b), rest(b);
    b.copy_locally_owned_data_from(forces);
    const double size = b.l2_norm();
    if (!std::isfinite(size))
      throw NumericalError("the loads of the static solution are not finite");
    if (size == 0)
      return q;
    const double          tolerance = options.linear_tolerance;
    dealii::SolverControl control(1000, tolerance * size, false, false);
    try
      {
        dealii::SolverCG<DistributedVector>(control).solve(stiffness, q, b, inverse);
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        // The residual decides.
      }
    n_iterations = control.last_step();
    stiffness.vmult(rest, q);
    rest -= b;
    check_conjugate_gradients(rest.l2_norm() / size, n_iterations, tolerance);
    return q;
  }

  NodalSolution DistributedStatics::solve(const StaticLoads &loads)
  {
    const Parts            &p      = *parts_;
    const DistributedVector forces = p.make_forces(loads);
    const DistributedVector led    = p.supports.compute_prescribed(
      [&](const Constraint &constraint) { return p.factor_of(constraint.history, loads); });
    // K T q = T^T (f - K g), u = T q + g
    DistributedVector rest = p.stiffness.stiffness_forces(led);
    rest.sadd(-1., 1., forces);
    p.supports.condense(rest);
    NodalSolution      solution;
    DistributedVector &u = parts_->displacements;
    u                    = p.space.level().make_vector();
    u.copy_locally_owned_data_from(p.solve(rest, solution.n_iterations));
    p.supports.lines().distribute(u);
    u.zero_out_ghost_values();
    u += led;
    u.update_ghost_values();

    rest                   = p.stiffness.stiffness_forces(u);
    solution.strain_energy = .5 * (u * rest);
    rest -= forces;
    solution.reactions       = p.find_reactions(rest);
    solution.n_displacements = p.space.level().dofs().n_dofs();
    for_points([&](const Vector3 &, const Vector3 &displacement) {
      solution.largest_displacement = std::max(solution.largest_displacement, displacement.norm());
    });
    solution.largest_displacement = p.communicator.max(solution.largest_displacement);
    p.add_nodes(solution);
    return solution;
  }

  std::vector<Reaction>
  DistributedStatics::Parts::find_reactions(const DistributedVector &forces) const
  {
    std::vector<Reaction> reactions(list_supports(model).size());
    for (const DistributedSupports::Point &point : supports.points())
      for (const auto &[constraint, part] :
           point.constraints.share(value_at(point.dofs, forces), point.place))
        reactions[constraint - model.constraints.data()].add(point.place, part);
    sum_over_ranks(reactions, communicator);
    return reactions;
  }

  void DistributedStatics::Parts::add_nodes(NodalSolution &solution) const
  {
    const Body               &of_model = model.bodies[body];
    const std::vector<double> u        = space.values_at_nodes(displacements);
    const unsigned int        n        = model.n_nodes();
    const DofLevel           &level    = space.level();
    const Eigen::MatrixXd    &corners  = corner_extrapolation(level.degree());
    std::vector<double>       sums(7 * std::size_t(n), 0.); // stresses, number of elements
    solution.displacements.assign(3 * std::size_t(n), 0.);
    std::copy(u.begin(), u.end(), solution.displacements.begin() + 3 * of_model.first_node);
    level.for_elements([&](const DofLevel::Element &element) {
      std::array<std::vector<unsigned int>, 8> nodes;
      bool                                     any = false;
      for (unsigned int v = 0; v < 8; ++v)
        {
          nodes[v] =
            space.mesh().nodes_around(element.place, dealii::GeometryInfo<3>::unit_cell_vertex(v));
          any = any || nodes[v].size() == 1;
        }
      if (!any)
        return;
      const ElementNodes                of_points = gather(element, displacements);
      const Eigen::Matrix<double, 6, 8> values =
        compute_point_stresses(level.element_nodes(element),
                               of_model.material(element.place.element),
                               space.element(),
                               Eigen::Map<const Eigen::VectorXd>(of_points.data(),
                                                                 of_points.size())) *
        corners;
      for (unsigned int v = 0; v < 8; ++v)
        if (nodes[v].size() == 1)
          {
            double *const sum = sums.data() + 7 * std::size_t(of_model.first_node + nodes[v][0]);
            for (unsigned int i = 0; i < 6; ++i)
              sum[i] += values(i, v);
            sum[6] += 1.;
          }
    });
    communicator.sum(sums);
    solution.stresses.assign(n, Stress::Zero());
    for (unsigned int i = 0; i < n; ++i)
      if (const double *const sum = sums.data() + 7 * std::size_t(i); sum[6] > 0)
        solution.stresses[i] = Eigen::Map<const Stress>(sum) / sum[6];
  }

  void DistributedStatics::for_points(
    const std::function<void(const Vector3 &, const Vector3 &)> &act) const
  {
    const DofLevel &level = parts_->space.level();
    level.for_elements([&](const DofLevel::Element &element) {
      for (const PointDofs &dofs : element.points)
        act(value_at(dofs, level.places()), value_at(dofs, parts_->displacements));
    });
  }

  MeshFields DistributedStatics::fields() const
  {
    return {parts_->space.level().dofs(),
            parts_->space.mapping(),
            {{"displacement", &parts_->displacements}}};
  }
} // namespace vfife
