// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_equilibrium_small_displacements_h
#define vfife_dynamics_equilibrium_small_displacements_h

#include <vfife/model/state.h>

namespace vfife
{
  class Communicator;
  class VfifeOperator;
  struct Model;

  /**
   * Displacements u = x - X that coordinates x have too few digits for, and the internal forces
   * under them. With s u, s a power of two that makes them large enough, f is known to the third
   * order of u (doc/theory/equilibrium.md, Relaxation):
   *   f(X + u) = (f(X + s u) - f(X - s u))/(2 s) + (f(X + s u) + f(X - s u))/(2 s^2) + O(s^2 u^3).
   */
  class SmallDisplacements
  {
  public:
    SmallDisplacements(const Model &model, VfifeOperator &vfife, const Communicator &communicator);

    /** Takes u from the positions of @p state, unless they are those of the present u to
     * round-off. Collective. */
    void read(const State &state);

    /** X + u + @p way of a node. */
    Vector3 place_after(const std::uint32_t local, const Vector3 &way) const
    {
      return places_.value(local) + (displacements_.value(local) + way);
    }

    /** u += @p way of a node, which has come to its present position by it, to round-off; else u is
     * taken from that. Whether it is the former. */
    bool follow(std::uint32_t local, const Vector3 &way, const State &state);

    /** Chooses s for the present u: 1 where @p wanted is false, u is large or a body has initial
     * strains, whose forces are not of the first order in u. Collective. */
    void   choose_scale(bool wanted);
    double scale() const
    {
      return scale_;
    }

    /** X of a node about the middle of its body [mm]. */
    Vector3 local_place(const std::uint32_t local) const
    {
      return local_.value(local);
    }

    /** Sets @p forces to the internal ones at @p state. Collective. */
    void compute_internal_forces(const State &state, NodeField &forces);

    /** Adds the internal forces of the undeformed bodies, which initial strains have. Collective.
     */
    void add_strain_forces(NodeField &forces);

  private:
    /** Largest change of u along an edge of an element over its length. Collective. */
    double compute_gradient() const;

    const Model        &model_;
    VfifeOperator      &operator_;
    const Communicator &communicator_;
    NodeField           places_, local_; ///< X, and about the middle of each body
    NodeField           displacements_, scaled_, other_;
    double              scale_ = 1;
  };
} // namespace vfife

#endif
