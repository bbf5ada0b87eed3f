// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/fem/system/fem_constraints.h>
#include <vfife/model/body_frame.h>

#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace vfife
{
  namespace
  {
    constexpr unsigned int no_unknown = static_cast<unsigned int>(-1);

    /** From one sector to the next, fixed frame. */
    Matrix3 sector_turn(const FemSpace &space)
    {
      const Body &body = space.model().bodies[space.parts()[0].body];
      return rotation_about(compute_sector_axis(body).direction, space.sector_angle());
    }
    [[noreturn]] void refuse_held_bodies(const FemSpace &space)
    {
      std::vector<std::string> names;
      for (const FemSpace::Part &part : space.parts())
        names.push_back(space.model().bodies[part.body].name());
      throw InputError("Model/constraints",
                       "no node can move: all nodes of " + list_of(names, true) +
                         " are held in all directions. Leave some of them free");
    }
    void refuse_led_directions(const FemSpace &space)
    {
      for (const Constraint &constraint : space.model().constraints)
        if (constraint.kind == ConstraintKind::directions &&
            space.find_part(constraint.body) != nullptr && !constraint.displacement.isZero(0.))
          throw InputError("constraint \"" + constraint.name +
                           "\": vibrations and contact by conventional finite elements support "
                           "fixed directions, not prescribed displacements");
    }
  } // namespace

  /** Directions in which a point may move, and the unknowns that belong to them. */
  struct FemConstraints::LocalAxes
  {
    Matrix3                     columns = Matrix3::Identity();
    std::array<bool, 3>         active  = {{true, true, true}};
    unsigned int                hub     = no_unknown; ///< index of the shared unknown of column 2
    bool                        follows = false;      ///< others, as it hangs or is their image
    std::array<unsigned int, 3> unknown = {{no_unknown, no_unknown, no_unknown}};

    /** Leaves what @p constraints do not hold. */
    explicit LocalAxes(const NodeConstraints &constraints)
      : columns(constraints.axes())
    {
      for (unsigned int c = 0; c < constraints.n_held(); ++c)
        active[c] = false;
    }
    LocalAxes() = default;
  };

  FemConstraints::FemConstraints(const FemSpace    &space,
                                 const Options     &options,
                                 const unsigned int n_ranks)
    : lines_(std::make_unique<dealii::AffineConstraints<double>>())
  {
    const double       angle = space.sector_angle();
    const unsigned int n     = angle > 0 ? std::lround(2. * pi / angle) : 0;
    if (options.harmonic > n / 2)
      throw InputError("a body of " + std::to_string(n) + " sectors has harmonics 0 to " +
                       std::to_string(n / 2) + ", not " + std::to_string(options.harmonic));
    // One copy is enough for h = 0 and h = N/2, where exp(i h angle) is 1 or -1.
    n_copies_ = options.harmonic > 0 && 2 * options.harmonic < n ? 2 : 1;
    if (!options.led_are_held)
      refuse_led_directions(space);

    // Three passes: the free directions of each point, their owners and numbers, the lines.
    std::vector<LocalAxes> axes = make_axes(space, options);
    number(space, options.padded, n_ranks, axes);
    if (std::find(padding_.begin(), padding_.end(), false) == padding_.end())
      refuse_held_bodies(space);
    add_lines(space, options, axes);
  }

  FemConstraints::~FemConstraints() = default;

  std::vector<FemConstraints::LocalAxes> FemConstraints::make_axes(const FemSpace &space,
                                                                   const Options  &options) const
  {
    const Model                 &model    = space.model();
    const unsigned int           n_points = space.n_points();
    std::vector<LocalAxes>       axes(n_points);
    std::set<const Constraint *> met; // that let points turn
    for (const auto &[p, constraints] : find_point_constraints(space))
      {
        LocalAxes &local                = axes[p];
        local                           = LocalAxes(constraints);
        const Constraint *const turning = constraints.turning();
        if (turning == nullptr)
          continue;
        // The third direction is the tangent, which turns freely unless hubs are held. Pinned: the
        // first point of a hub whose points turn freely, or the one angle of a rigid hub. That
        // angle is the same in all sectors, so waves (h > 0) have none.
        const Axis   &axis    = model.bodies[turning->body].axis;
        const Vector3 tangent = axis.direction.cross(space.points()[p] - axis.point);
        const bool    hub     = turning->kind == ConstraintKind::rigid_hub;
        const bool    first   = met.insert(turning).second;
        const bool    turns   = options.rotation == HubRotation::free ||
                           (options.rotation == HubRotation::pinned && !hub && !first);
        local.active[2]      = turns && !(hub && options.harmonic > 0);
        local.columns.col(2) = tangent.normalized();
        if (hub)
          {
            local.hub = turning - model.constraints.data();
            // u_t = r phi
            local.columns.col(2) = tangent;
          }
      }
    // A point that hangs moves as its masters do, whatever holds it.
    for (const auto &hanging : space.hanging())
      {
        axes[hanging.first]         = LocalAxes();
        axes[hanging.first].follows = true;
      }
    for (const auto &[image, original] : space.images())
      if (space.hanging().count(image) != 0)
        continue;
      else if (options.open)
        {
          axes[image]         = axes[original];
          axes[image].columns = sector_turn(space) * axes[original].columns;
        }
      else
        axes[image].follows = true;

    std::vector<LocalAxes> all = axes;
    if (n_copies_ == 2)
      all.insert(all.end(), axes.begin(), axes.end());
    return all;
  }

  void FemConstraints::number(const FemSpace         &space,
                              const bool              padded,
                              const unsigned int      n_ranks,
                              std::vector<LocalAxes> &axes)
  {
    // A point belongs to the rank of its first element; elements are dealt out in equal runs.
    const unsigned int        n_points   = space.n_points();
    const unsigned int        n_elements = space.n_elements();
    std::vector<unsigned int> rank(n_points, no_unknown);
    for (unsigned int e = 0; e < n_elements; ++e)
      for (unsigned int a = 0; a < space.points_per_element(); ++a)
        {
          unsigned int &r = rank[space.element_points(e)[a]];
          if (r == no_unknown)
            r = static_cast<unsigned long long>(e) * n_ranks / n_elements;
        }

    std::map<unsigned int, unsigned int> hubs; // constraint -> unknown
    for (unsigned int r = 0; r < n_ranks; ++r)
      {
        first_.push_back(padding_.size());
        for (std::size_t i = 0; i < axes.size(); ++i)
          {
            LocalAxes &local = axes[i];
            if (rank[i % n_points] != r || (local.follows && !padded))
              continue;
            for (unsigned int k = 0; k < 3; ++k)
              {
                // A rigid hub's angle gets its number at the hub's first
                // point; later points refer to it.
                const bool shared = local.hub != no_unknown && hubs.count(local.hub) != 0;
                const bool acts   = local.active[k] && !local.follows;
                if (acts && shared)
                  local.unknown[k] = hubs.at(local.hub);
                else if (acts)
                  {
                    local.unknown[k] = padding_.size();
                    if (local.hub != no_unknown)
                      {
                        hubs.emplace(local.hub, local.unknown[k]);
                        hub_angles_.push_back(local.unknown[k]);
                      }
                  }
                // Padding: three numbers a point, whatever acts.
                if (padded || (acts && !shared))
                  padding_.push_back(!acts || shared);
              }
          }
      }
    first_.push_back(padding_.size());
  }

  void FemConstraints::add_lines(const FemSpace               &space,
                                 const Options                &options,
                                 const std::vector<LocalAxes> &axes)
  {
    const unsigned int n_points = space.n_points();
    const auto         row_of   = [this](const std::size_t point, const unsigned int component) {
      return n() + 3 * point + component;
    };
    for (std::size_t i = 0; i < axes.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        {
          lines_->add_line(row_of(i, c));
          for (unsigned int k = 0; k < 3; ++k)
            if (axes[i].unknown[k] != no_unknown)
              lines_->add_entry(row_of(i, c), axes[i].unknown[k], axes[i].columns(c, k));
        }
    hangs_.assign(n_points, false);
    for (const auto &[point, masters] : space.hanging())
      {
        hangs_[point] = true;
        for (unsigned int copy = 0; copy < n_copies_; ++copy)
          for (const auto &[master, weight] : masters)
            for (unsigned int c = 0; c < 3; ++c)
              lines_->add_entry(row_of(copy * n_points + point, c),
                                row_of(copy * n_points + master, c),
                                weight);
      }
    if (!options.open && !space.images().empty())
      {
        const Matrix3 turn  = sector_turn(space);
        const double  phase = options.harmonic * space.sector_angle();
        // (a + i b) exp(i phase): the real part of the image takes a cos - b sin.
        const auto follow =
          [&](const std::size_t image, const std::size_t original, const double factor) {
            for (unsigned int c = 0; c < 3; ++c)
              for (unsigned int d = 0; d < 3; ++d)
                lines_->add_entry(row_of(image, c), row_of(original, d), factor * turn(c, d));
          };
        for (const auto &[image, original] : space.images())
          if (!hangs_[image])
            for (unsigned int copy = 0; copy < n_copies_; ++copy)
              {
                const std::size_t own = copy * std::size_t(n_points), other = n_points - own;
                follow(own + image, own + original, std::cos(phase));
                if (n_copies_ == 2)
                  follow(own + image, other + original, (copy == 0 ? -1. : 1.) * std::sin(phase));
              }
      }
    lines_->close(); // follows points that follow others
  }

  const FemConstraints::Line &FemConstraints::line(const std::size_t row) const
  {
    return *lines_->get_constraint_entries(n() + row);
  }

  std::vector<double> FemConstraints::expand(const std::vector<double> &q) const
  {
    std::vector<double> u(3 * n_copies_ * hangs_.size(), 0.);
    for (std::size_t row = 0; row < u.size(); ++row)
      for (const auto &[unknown, coefficient] : line(row))
        u[row] += coefficient * q[unknown];
    return u;
  }

  std::vector<double> FemConstraints::restrict_field(const std::vector<double> &u) const
  {
    std::vector<double> q(n(), 0.), weight(n(), 0.);
    for (std::size_t row = 0; row < u.size(); ++row)
      if (!hangs_[row / 3 % hangs_.size()]) // those follow from the others
        for (const auto &[unknown, coefficient] : line(row))
          {
            // q_i = (sum of T_ri u_r) / (sum of T_ri^2), T having orthogonal columns.
            q[unknown] += coefficient * u[row];
            weight[unknown] += coefficient * coefficient;
          }
    for (std::size_t i = 0; i < q.size(); ++i)
      if (weight[i] > 0)
        q[i] /= weight[i];
    return q;
  }

  std::map<unsigned int, NodeConstraints> find_point_constraints(const FemSpace &space)
  {
    std::map<unsigned int, NodeConstraints> points;
    const Model                            &model = space.model();
    for (const Constraint &constraint : model.constraints)
      if (const FemSpace::Part *part = space.find_part(constraint.body))
        for (const unsigned int p : space.points_of(*part, constraint.nodes))
          points.try_emplace(p, model.bodies[constraint.body], space.points()[p])
            .first->second.add(constraint);
    for (const auto &[p, constraints] : points)
      constraints.check();
    return points;
  }

  std::vector<double>
  compute_prescribed_displacements(const FemSpace                                  &space,
                                   const std::function<double(const Constraint &)> &factor)
  {
    std::vector<double> u(3 * static_cast<std::size_t>(space.n_points()), 0.);
    for (const auto &[p, constraints] : find_point_constraints(space))
      Eigen::Map<Vector3>(u.data() + 3 * std::size_t(p)) = constraints.compute_displacement(factor);
    // What hangs moves as its masters do, also where it is not among the constrained points.
    for (const auto &[point, masters] : space.hanging())
      Eigen::Map<Vector3>(u.data() + 3 * std::size_t(point)) = compute_mean(masters, u);
    return u;
  }
} // namespace vfife
