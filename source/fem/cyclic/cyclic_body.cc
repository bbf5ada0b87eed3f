// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/cyclic/cyclic_body.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/fem/system/rigid_motions.h>
#include <vfife/fem/system/turn_pins.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/constraints/held_direction.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    FemOptions of_sectors(FemOptions options)
    {
      options.cyclic_symmetry = true;
      // What is static in a turning body needs no Coriolis forces.
      options.coriolis     = true;
      options.eigen_solver = EigenSolverKind::shift_invert;
      return options;
    }

    /** Throws InputError for what no sector can have by itself. */
    const Model &require_own_supports(const Model &model, const unsigned int b)
    {
      for (const Load &load : model.loads)
        if (load.body == b)
          throw InputError("body \"" + model.bodies[b].name() + "\": load \"" + load.name +
                           "\" acts on it, but harmonics of one sector support only supports that "
                           "are equal in all sectors");
      return model;
    }

    /** Throws InputError where a constraint holds sectors differently. */
    void require_alike(const Constraint &constraint, const Body &body)
    {
      const std::string what = "constraint \"" + constraint.name + "\"";
      require_all_copies(body, constraint.nodes, what);
      const Matrix3 turn =
        rotation_about(compute_sector_axis(body).direction, body.structure().pitch());
      for (const unsigned int node : constraint.nodes)
        {
          const auto held = [&](const unsigned int i) {
            return compute_held_projector(constraint,
                                          body,
                                          body.placement(body.node_positions()[i]));
          };
          if ((held(body.structure().copy(node, 1)) - turn * held(node) * turn.transpose()).norm() >
              1e-6)
            throw InputError("body \"" + body.name() + "\": " + what +
                             " does not hold all sectors equally: its directions do not rotate "
                             "from sector to sector");
        }
    }

    /** Throws InputError where the body's constraints hold sectors differently. */
    void require_held_alike(const Model &model, const unsigned int b)
    {
      for (const Constraint &constraint : model.constraints)
        if (constraint.body == b)
          require_alike(constraint, model.bodies[b]);
    }

    /** Whether nothing holds the body's turn about its axis. Throws InputError where it can move
     * otherwise. */
    bool turns_freely(const FemSpace &whole)
    {
      const Model       &model   = whole.model();
      const unsigned int b       = whole.parts()[0].body;
      const auto         motions = find_free_motions(whole, whole.parts()[0]);
      if (motions.empty())
        return false;
      if (motions.size() > 1 || !(has_turning_hub(model, b) || model.bodies[b].floats) ||
          !is_turn(whole, whole.parts()[0], motions.front()))
        throw InputError("body \"" + model.bodies[b].name() +
                         "\" has rigid motions other than the rotation on its hub or in its "
                         "bearings, so that it has no static equilibrium. Hold more of its nodes");
      return true;
    }
  } // namespace

  double read_row(const SectorRow &row, const std::vector<double> &u)
  {
    double value = 0;
    for (const SectorTerm &term : row)
      value += term.weight.dot(Eigen::Map<const Vector3>(u.data() + 3 * std::size_t(term.point)));
    return value;
  }

  bool has_equal_sectors(const Model &model, const unsigned int b, const FemSpaceOptions &options)
  {
    const auto acts = [b](const auto &one) { return one.body == b; };
    if (std::any_of(model.bearings.begin(), model.bearings.end(), acts) ||
        std::any_of(model.couplings.begin(), model.couplings.end(), acts))
      return false;
    try
      {
        require_own_supports(model, b);
        require_held_alike(model, b);
        FemSpace::sector_of(model, b, options);
      }
    catch (const InputError &)
      {
        return false; // The whole body meets again what is an error for it too.
      }
    return true;
  }

  CyclicBody::CyclicBody(const Model       &model,
                         const unsigned int body,
                         const FemOptions  &options,
                         const double       rate)
    : model_(model)
    , body_(body)
    , options_(of_sectors(options))
    , alone_(MPI_COMM_SELF)
    , rotating_(require_own_supports(model, body), body, options_, alone_)
    , rate_(rate)
  {
    require_held_alike(model, body);
    turns_       = !options_.hold_hubs && turns_freely(rotating_.whole());
    equilibrium_ = find_equilibrium(rate);
    find_turn();
    find_torque();
  }

  const Body &CyclicBody::body() const
  {
    return model_.bodies[body_];
  }

  unsigned int CyclicBody::n_sectors() const
  {
    return body().structure().n_sectors();
  }

  bool CyclicBody::whirls(const unsigned int number) const
  {
    return number == 1 && rate_ != 0 && body().floats;
  }

  std::vector<double> CyclicBody::find_equilibrium(const double rate) const
  {
    return rotating_.deforms_at(rate)
             ? rotating_.find_equilibrium(rate)
             : std::vector<double>(3 * std::size_t(sector().n_points()), 0.);
  }

  FemMatrix CyclicBody::stiffness(const SystemMatrices &matrices) const
  {
    return deforms() ? matrices.spinning_stiffness(equilibrium_, constant_rate(rate_))
                     : matrices.stiffness(constant_rate(0.));
  }

  void CyclicBody::find_turn()
  {
    spin_ = equilibrium_;
    turn_.assign(spin_.size(), 0.);
    // The turn of the spun body: it costs nothing, K r = 0, where the turn of the undeformed one
    // would have a stiffness of Omega^2 m times the strain of the spin.
    const Axis &axis = body().axis;
    rigid_turn_.resize(spin_.size());
    for (std::size_t p = 0; p < sector().n_points(); ++p)
      Eigen::Map<Vector3>(rigid_turn_.data() + 3 * p) = axis.direction.cross(
        sector().points()[p] + Eigen::Map<const Vector3>(spin_.data() + 3 * p) - axis.point);
    if (!turns_)
      return;
    FemConstraints::Options constraints;
    constraints.rotation = HubRotation::free;
    const FemSystem      system(sector(), constraints, alone_);
    const SystemMatrices matrices(system, options_.mass, options_.strain);
    const OwnedVector    q     = system.restrict_field(rigid_turn_);
    turn_                      = system.expand(q);
    const OwnedVector momentum = matrices.apply_mass(turn_);
    const double      inertia  = system.dot(momentum, q);
    turn_inertia_              = n_sectors() * inertia;
    // The pinned hub has left a turn in the state of spin where sectors have no mirror plane.
    const double angle = system.dot(momentum, system.restrict_field(spin_)) / inertia;
    spin_              = add_scaled(std::move(spin_), -angle, turn_);
  }

  void CyclicBody::find_torque()
  {
    torque_.assign(spin_.size(), 0.);
    bool has_one = false;
    for (const Torque &torque : model_.torques)
      if (torque.body == body_)
        {
          if (has_one)
            throw InputError("body \"" + body().name() + "\": torque \"" + torque.name +
                             "\" is its second torque, but harmonics of one sector support one");
          has_one = true;
          require_all_copies(body(), torque.nodes, "torque \"" + torque.name + "\"");
          add_torque_forces(torque, sector(), sector().parts()[0], 1., torque_);
        }
  }

  SectorRow CyclicBody::make_row(const std::vector<std::pair<unsigned int, Vector3>> &weights) const
  {
    // Sector s moves by R^s u exp(i h s alpha): what w reads of it, R^-s w reads of u.
    const BodyStructure &structure = body().structure();
    const Vector3        axis      = compute_sector_axis(body()).direction;
    SectorRow            row;
    const SectorCopies  *copies = rotating_.copies();
    for (const auto &[point, weight] : weights)
      {
        const unsigned int s = copies ? copies->sector_of(point) : structure.sector_of(point);
        row.push_back({copies ? copies->original_of(point) : structure.first_copy(point),
                       s,
                       rotation_about(axis, -(s * sector().sector_angle())) *
                         (body().placement.rotation * weight)});
      }
    return row;
  }
} // namespace vfife
