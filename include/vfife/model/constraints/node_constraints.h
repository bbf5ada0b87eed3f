// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_constraints_node_constraints_h
#define vfife_model_constraints_node_constraints_h

#include <vfife/model/constraints/held_direction.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace vfife
{
  /**
   * What all constraints of a model do together to one node: equations n_k . u = g_k for its small
   * displacement u. Directions are taken in the order of the constraints and made orthonormal
   * (modified Gram-Schmidt); one that depends on those before it, to parallel_angle, adds nothing
   * and must agree with them (doc/theory/model.md, Constraints).
   */
  class NodeConstraints
  {
  public:
    /** Factor of a constraint's values: its history at some time, or a part of all loads. */
    using Factor = std::function<double(const Constraint &)>;

    /** The node of @p body at the undeformed @p place (fixed frame). Both must outlive this. */
    NodeConstraints(const Body &body, const Vector3 &place);

    void add(const Constraint &constraint);

    /**
     * To be called after the last add(). Throws InputError, naming both constraints, where one
     * turns the node with its body and another does not let it, or where something else than radius
     * and axial position is prescribed on a node of a rigid hub.
     */
    void check() const;

    /** All that have been added. */
    const std::vector<const Constraint *> &constraints() const
    {
      return constraints_;
    }
    /** The equations of all of them. */
    const std::vector<HeldDirection> &held() const
    {
      return held_;
    }
    /** Those that depend on no earlier one. */
    std::vector<HeldDirection> independent() const;

    /** Number of directions that are held. */
    unsigned int n_held() const
    {
      return n_held_;
    }
    /** Orthonormal columns: the held directions first, then the free ones. */
    Matrix3 axes() const;

    /** The constraint that lets the node turn about the axis of its body, alone or with a hub, if
     * nothing else holds it. */
    const Constraint *turning() const;

    /**
     * The displacement in the space of the held directions that meets all equations [mm]. Throws
     * InputError, naming the constraints and their values, where they contradict each other.
     */
    Vector3 compute_displacement(const Factor &factor) const;

    /**
     * Parts of a @p force that the constraints exert on the node when it is at @p place, along the
     * directions that they hold there. What none of them holds is what nodes that turn together
     * exert on each other, or a shaft that is held on a hub.
     */
    std::vector<std::pair<const Constraint *, Vector3>> share(const Vector3 &force,
                                                              const Vector3 &place) const;

    /**
     * The constraint whose kind says how the node moves. Those that leave it no freedom come first,
     * and a rigid hub, with which nothing else but the same goes together. What holds radius and
     * axial position beside other directions is one more of these.
     */
    const Constraint &leading() const;

    /** Whether values of dependent directions could contradict each other at some time. */
    bool has_values_to_compare() const;

  private:
    Vector3 solve(const std::vector<double> &values, const char *unit) const;
    [[noreturn]] void
    refuse(std::size_t k, const std::vector<double> &values, const char *unit) const;

    const Body                     *body_;
    Vector3                         place_;
    std::vector<const Constraint *> constraints_;
    std::vector<HeldDirection>      held_;
    /** By equation: its direction in the axes that came before it and its own, n = Q row; the
     * length of what is left of it beside those before, and its own axis if it has one. */
    std::vector<Vector3> rows_;
    std::vector<double>  rest_;
    std::vector<int>     own_axis_;
    Matrix3              axes_   = Matrix3::Zero();
    unsigned int         n_held_ = 0;
  };

  /** Directions that differ by less are the same [rad]: places of mesh files have six or seven
   * digits, and held directions that are nearly parallel would multiply what their values differ
   * by. */
  constexpr double parallel_angle = 1e-4;

  /** The checked constraints of all nodes of @p body that have any, by node of the body. */
  std::map<unsigned int, NodeConstraints> combine_constraints(const Model &model,
                                                              unsigned int body);

  /** The projector on the directions in which a node of the body gives way to a force: all of them
   * where @p constraints hold nothing, and for a node that turns with others. */
  Matrix3 free_directions(const std::map<unsigned int, NodeConstraints> &constraints,
                          unsigned int                                   node);

  /**
   * The multipliers lambda_k of a force f that is carried by @p directions n_k (columns): sum n_k
   * lambda_k = f, of all those the smallest, so that equal directions share alike. What of f no
   * direction carries is left out.
   */
  Eigen::VectorXd share_force(const Eigen::Matrix3Xd &directions, const Vector3 &force);
} // namespace vfife

#endif
