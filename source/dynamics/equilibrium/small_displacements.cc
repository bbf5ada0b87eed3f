// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/equilibrium/small_displacements.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/model/model.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  namespace
  {
    /** Of the gradient of s u. Its square is left out, of slender bodies times that of their length
     * over their height; round-off is some 1e-16 over it. A scale is kept while its gradient stays
     * above a half. */
    constexpr double largest_gradient = 5e-5;
    constexpr double largest_exponent = 100;
  } // namespace

  SmallDisplacements::SmallDisplacements(const Model        &model,
                                         VfifeOperator      &vfife,
                                         const Communicator &communicator)
    : model_(model)
    , operator_(vfife)
    , communicator_(communicator)
    , places_(vfife.make_field())
    , local_(vfife.make_field())
    , displacements_(vfife.make_field())
    , scaled_(vfife.make_field())
    , other_(vfife.make_field())
  {
    const Partition &partition = vfife.partition();
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        // Internal forces know no origin: near the body's own middle coordinates have most digits.
        const Body         &body = model.bodies[b];
        Eigen::AlignedBox3d box;
        for (const Vector3 &X : body.node_positions())
          box.extend(X);
        for (const std::uint32_t i : partition.nodes(b))
          {
            const Vector3 &X = body.node_positions()[partition.global_node[i] - body.first_node];
            places_.set(i, body.placement(X));
            local_.set(i, body.placement.rotation * (X - box.center()));
          }
      }
  }

  void SmallDisplacements::read(const State &state)
  {
    // What a relaxation before has found keeps its digits, and its scale.
    bool changed = false;
    for (const std::uint32_t i : state.partition->nodes())
      changed = !follow(i, Vector3::Zero(), state) || changed;
    if (communicator_.any(changed))
      scale_ = 1;
  }

  bool SmallDisplacements::follow(const std::uint32_t local, const Vector3 &way, const State &state)
  {
    constexpr double round_off = 8. * std::numeric_limits<double>::epsilon();
    const Vector3    X = places_.value(local), x = state.node_position(local),
                  u = displacements_.value(local) + way;
    // Written so that what is no number is taken as it is.
    const bool follows = (x - (X + u)).norm() <= round_off * (x.norm() + X.norm());
    displacements_.set(local, follows ? u : Vector3(x - X));
    return follows;
  }

  double SmallDisplacements::compute_gradient() const
  {
    const Partition &partition = operator_.partition();
    double           largest   = 0;
    std::size_t      b         = 0;
    for (const std::uint32_t e : partition.elements)
      {
        while (e >= model_.bodies[b].first_element + model_.bodies[b].n_elements())
          ++b;
        const Body &body  = model_.bodies[b];
        const auto &nodes = body.elements()[e - body.first_element];
        const auto  local = [&](const unsigned int i) {
          return partition.local_node[body.first_node + nodes[i]];
        };
        const Vector3 u = displacements_.value(local(0));
        for (unsigned int i = 1; i < 8; ++i)
          largest = std::max(
            largest,
            (displacements_.value(local(i)) - u).squaredNorm() /
              (body.node_positions()[nodes[i]] - body.node_positions()[nodes[0]]).squaredNorm());
      }
    return std::sqrt(communicator_.max(largest));
  }

  void SmallDisplacements::choose_scale(const bool wanted)
  {
    if (!wanted || model_.has_initial_strains())
      {
        scale_ = 1;
        return;
      }
    const double gradient = compute_gradient(), scaled = scale_ * gradient;
    if (scale_ > 1 && scaled <= largest_gradient && scaled >= .5 * largest_gradient)
      return;
    // A power of two changes no digit; undeformed bodies have no forces with a large one.
    scale_ = std::max(1.,
                      std::exp2(std::min(largest_exponent,
                                         std::floor(std::log2(largest_gradient / gradient)))));
  }

  void SmallDisplacements::add_strain_forces(NodeField &forces)
  {
    if (!model_.has_initial_strains())
      return;
    operator_.compute_internal_forces(local_, other_);
    for (const std::uint32_t i : operator_.partition().nodes())
      forces.add(i, other_.value(i));
  }

  void SmallDisplacements::compute_internal_forces(const State &state, NodeField &forces)
  {
    const auto compute = [&](const double part, NodeField &found) {
      for (const std::uint32_t i : state.partition->nodes())
        scaled_.set(i, local_.value(i) + part * displacements_.value(i));
      operator_.compute_internal_forces(scaled_, found);
    };
    compute(scale_, forces);
    if (!(scale_ > 1))
      return;
    compute(-scale_, other_);
    for (const std::uint32_t i : state.partition->nodes())
      {
        const Vector3 odd  = .5 * (forces.value(i) - other_.value(i)),
                      even = .5 * (forces.value(i) + other_.value(i));
        forces.set(i, odd / scale_ + even / (scale_ * scale_));
      }
  }
} // namespace vfife
