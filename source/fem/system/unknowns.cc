// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/fem/system/point_constraints.h>
#include <vfife/fem/system/unknowns.h>
#include <vfife/model/body_frame.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace vfife
{
  namespace
  {
    constexpr unsigned int none = static_cast<unsigned int>(-1);

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
                       "nothing is free to move: all nodes of " + list_of(names, true) +
                         " are held in all directions; leave some of them free");
    }
  } // namespace

  /** Directions in which a point may move, and the unknowns that belong to them. */
  struct Unknowns::LocalAxes
  {
    Matrix3                     columns  = Matrix3::Identity();
    std::array<bool, 3>         active   = {{true, true, true}};
    unsigned int                hub      = none;  ///< index of the shared unknown of column 2
    bool                        is_image = false; ///< or hangs: it has no unknowns of its own
    std::array<unsigned int, 3> unknown  = {{none, none, none}};

    /** Leaves what @p constraints do not hold. */
    explicit LocalAxes(const NodeConstraints &constraints)
      : columns(constraints.axes())
    {
      for (unsigned int c = 0; c < constraints.n_held(); ++c)
        active[c] = false;
    }
    LocalAxes() = default;
  };

  Unknowns::Unknowns(const FemSpace &space, const Options &options, const unsigned int n_ranks)
  {
    const double       angle = space.sector_angle();
    const unsigned int n     = angle > 0 ? std::lround(2. * pi / angle) : 0;
    if (options.harmonic > n / 2)
      throw InputError("a body of " + std::to_string(n) + " sectors has harmonics 0 to " +
                       std::to_string(n / 2) + ", not " + std::to_string(options.harmonic));
    // One copy is enough for h = 0 and h = N/2, where exp(i h angle) is 1 or -1.
    n_copies_ = options.harmonic > 0 && 2 * options.harmonic < n ? 2 : 1;

    // Three passes: what is free at each point, who owns it and which
    // number it gets, then the rows of T.
    std::vector<LocalAxes> axes = make_axes(space, options);
    number(space, options.padded, n_ranks, axes);
    fill_terms(space, options, axes);
    if (std::find(padding_.begin(), padding_.end(), 0) == padding_.end())
      refuse_held_bodies(space);
  }

  void Unknowns::refuse_led_directions(const FemSpace &space, const Options &options)
  {
    for (const Constraint &constraint : space.model().constraints)
      if (constraint.kind == ConstraintKind::directions && !options.led_are_held &&
          space.find_part(constraint.body) != nullptr && !constraint.displacement.isZero(0.))
        throw InputError("constraint \"" + constraint.name +
                         "\": vibrations and contact by conventional finite elements "
                         "hold directions, they do not prescribe displacements");
  }

  std::vector<Unknowns::LocalAxes> Unknowns::make_axes(const FemSpace &space,
                                                       const Options  &options) const
  {
    const Model                 &model    = space.model();
    const unsigned int           n_points = space.n_points();
    std::vector<LocalAxes>       axes(n_points);
    std::set<const Constraint *> met; // that let points turn
    refuse_led_directions(space, options);
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
        axes[hanging.first]          = LocalAxes();
        axes[hanging.first].is_image = true;
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
        axes[image].is_image = true;

    std::vector<LocalAxes> all = axes;
    if (n_copies_ == 2)
      all.insert(all.end(), axes.begin(), axes.end());
    return all;
  }

  void Unknowns::number(const FemSpace         &space,
                        const bool              padded,
                        const unsigned int      n_ranks,
                        std::vector<LocalAxes> &axes)
  {
    // A point belongs to the rank of its first element; elements are dealt out in equal runs.
    const unsigned int        n_points   = space.n_points();
    const unsigned int        n_elements = space.n_elements();
    std::vector<unsigned int> rank(n_points, none);
    for (unsigned int e = 0; e < n_elements; ++e)
      for (unsigned int a = 0; a < space.points_per_element(); ++a)
        {
          unsigned int &r = rank[space.element_points(e)[a]];
          if (r == none)
            r = static_cast<unsigned long long>(e) * n_ranks / n_elements;
        }

    std::map<unsigned int, unsigned int> hubs; // constraint -> unknown
    for (unsigned int r = 0; r < n_ranks; ++r)
      {
        first_.push_back(padding_.size());
        for (std::size_t i = 0; i < axes.size(); ++i)
          {
            LocalAxes &local = axes[i];
            if (rank[i % n_points] != r || (local.is_image && !padded))
              continue;
            for (unsigned int k = 0; k < 3; ++k)
              {
                // A rigid hub's angle gets its number at the hub's first
                // point; later points refer to it.
                const bool shared = local.hub != none && hubs.count(local.hub) != 0;
                const bool acts   = local.active[k] && !local.is_image;
                if (acts && shared)
                  local.unknown[k] = hubs.at(local.hub);
                else if (acts)
                  {
                    local.unknown[k] = padding_.size();
                    if (local.hub != none)
                      hubs.emplace(local.hub, local.unknown[k]);
                  }
                // Padding: three numbers a point, whatever acts.
                if (padded || (acts && !shared))
                  padding_.push_back(!acts || shared);
              }
          }
      }
    first_.push_back(padding_.size());
  }

  void Unknowns::fill_terms(const FemSpace               &space,
                            const Options                &options,
                            const std::vector<LocalAxes> &axes)
  {
    const unsigned int n_points = space.n_points();
    // By copy: which point it is the image of.
    std::map<unsigned int, unsigned int> original;
    if (!options.open)
      original.insert(space.images().begin(), space.images().end());

    const Matrix3 turn  = original.empty() ? Matrix3::Identity() : sector_turn(space);
    const double  phase = options.harmonic * space.sector_angle();

    // By unknown, in the order met; a point that hangs may meet one several times.
    std::vector<Term> row;
    const auto        add = [&](const unsigned int unknown, const double coefficient) {
      for (Term &term : row)
        if (term.unknown == unknown)
          {
            term.coefficient += coefficient;
            return;
          }
      row.push_back({unknown, coefficient});
    };
    // Adds factor times the displacement of a point along c.
    const std::function<void(std::size_t, const Matrix3 &, unsigned int)> add_point =
      [&](const std::size_t i, const Matrix3 &factor, const unsigned int c) {
        const unsigned int p       = i % n_points;
        const bool         second  = i >= n_points; // imaginary part
        const auto         hanging = space.hanging().find(p);
        const auto         found   = original.find(p);
        if (hanging != space.hanging().end())
          for (const auto &[master, weight] : hanging->second)
            add_point(master + (second ? n_points : 0), weight * factor, c);
        else if (found != original.end())
          {
            // (a + i b) exp(i phase): the real part of the image takes a cos - b sin.
            add_point(found->second + (second ? n_points : 0),
                      std::cos(phase) * (factor * turn),
                      c);
            if (n_copies_ == 2)
              add_point(found->second + (second ? 0 : n_points),
                        (second ? 1. : -1.) * std::sin(phase) * (factor * turn),
                        c);
          }
        else
          for (unsigned int k = 0; k < 3; ++k)
            if (axes[i].unknown[k] != none)
              // u_c = sum_k columns(c, k) q_k; an image takes those of its original, turned.
              add(axes[i].unknown[k], factor.row(c).dot(axes[i].columns.col(k)));
      };
    start_.push_back(0);
    for (std::size_t i = 0; i < axes.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        {
          row.clear();
          add_point(i, Matrix3::Identity(), c);
          terms_.insert(terms_.end(), row.begin(), row.end());
          start_.push_back(terms_.size());
        }
    hangs_.assign(n_points, false);
    for (const auto &hanging : space.hanging())
      hangs_[hanging.first] = true;
  }

  std::vector<double> Unknowns::expand(const std::vector<double> &q) const
  {
    std::vector<double> u(n_rows(), 0.);
    for (std::size_t row = 0; row < u.size(); ++row)
      for (const Term *t = begin(row); t != end(row); ++t)
        u[row] += t->coefficient * q[t->unknown];
    return u;
  }

  std::vector<double> Unknowns::restrict_field(const std::vector<double> &u) const
  {
    std::vector<double> q(n(), 0.), weight(n(), 0.);
    // Points that hang follow from the others.
    for (std::size_t row = 0; row < u.size(); ++row)
      for (const Term *t = begin(row); t != end(row) && !hangs_[row / 3 % hangs_.size()]; ++t)
        {
          // q_i = (sum of T_ri u_r) / (sum of T_ri^2), T having orthogonal columns.
          q[t->unknown] += t->coefficient * u[row];
          weight[t->unknown] += t->coefficient * t->coefficient;
        }
    for (std::size_t i = 0; i < q.size(); ++i)
      if (weight[i] > 0)
        q[i] /= weight[i];
    return q;
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
      {
        Eigen::Map<Vector3> own(u.data() + 3 * std::size_t(point));
        own.setZero();
        for (const auto &[master, weight] : masters)
          own += weight * Eigen::Map<const Vector3>(u.data() + 3 * std::size_t(master));
      }
    return u;
  }
} // namespace vfife
