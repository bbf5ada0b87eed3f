// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_constraints_rigid_freedom_h
#define vfife_model_constraints_rigid_freedom_h

#include <vfife/model/constraints/held_direction.h>

#include <vector>

namespace vfife
{
  /** A rigid motion: velocity of a point, then angular velocity. */
  using Vector6 = Eigen::Matrix<double, 6, 1>;

  /** A rigid motion that a support opposes, whether by holding it or by stiffness. */
  struct OpposedMotion
  {
    /** What is opposed of the velocity at the place: along this direction, of constraints r or
     * theta of the present place. Without a constraint its length may be any. */
    HeldDirection held;
    Vector3       place = Vector3::Zero(); ///< undeformed, fixed frame [mm]
    bool          stays = false;           ///< all directions of that place are held
    /** What is opposed of the tilts of the axis: b . (z x (omega x a')), a' the moved axis z. */
    Vector3 tilt = Vector3::Zero();
    /** Whose driver the turn about the moved axis follows. */
    const Coupling *coupling = nullptr;
  };

  /** The rigid motion that a constraint prescribes: per rate of its factor [1/s], of a rotation at
   * its body's speed per factor of that speed. */
  struct PrescribedMotion
  {
    const Constraint *constraint = nullptr;
    Vector6           motion     = Vector6::Zero(); ///< velocity of RigidFreedom::centre()
  };

  /**
   * Which rigid motions of a body its constraints, springs to the ground, bearings and couplings
   * oppose and which they leave free (doc/theory/dynamics.md, The motion that is not damped). Walls
   * and contacts, which let go, oppose none.
   */
  class RigidFreedom
  {
  public:
    /** Body @p body of the model, which must outlive this. Throws InputError where constraints of
     * one node contradict each other. */
    RigidFreedom(const Model &model, unsigned int body);

    /** Independent motions, at most six. */
    const std::vector<OpposedMotion> &opposed() const
    {
      return opposed_;
    }

    /** Motions that constraints prescribe; of constraints that hold only there is none. */
    const std::vector<PrescribedMotion> &prescribed() const
    {
      return prescribed_;
    }

    /** Whether nothing opposes the turn about the body's axis. */
    bool turn_is_free() const
    {
      return turn_is_free_;
    }

    /** Whether every rigid motion but the turn about the axis is opposed. */
    bool is_held_across() const
    {
      return opposed_.size() == 6 || (opposed_.size() == 5 && turn_is_free_);
    }

    /** Centre of mass of the undeformed body, fixed frame [mm]. */
    const Vector3 &centre() const
    {
      return centre_;
    }

    /** Inertia about that centre [t mm^2]. */
    const Matrix3 &inertia() const
    {
      return inertia_;
    }

    /** w of w . (velocity of @p point, omega), which @p motion opposes, where the body has moved
     * from its undeformed place by @p moved. */
    Vector6
    coefficients(const OpposedMotion &motion, const RigidMotion &moved, const Vector3 &point) const;

  private:
    std::vector<OpposedMotion> list_constraints() const;
    void                       add_springs(std::vector<OpposedMotion> &all) const;
    void                       add_seats(std::vector<OpposedMotion> &all) const;
    void                       find_independent(const std::vector<OpposedMotion> &all);
    void                       find_prescribed(const std::vector<OpposedMotion> &of_constraints);

    const Model *model_;
    unsigned int b_;
    Vector3      centre_  = Vector3::Zero();
    Matrix3      inertia_ = Matrix3::Zero();
    double       length_  = 1; ///< radius of gyration: moments and forces are compared by it [mm]
    bool         turn_is_free_ = true;
    std::vector<OpposedMotion>    opposed_;
    std::vector<PrescribedMotion> prescribed_;
  };
} // namespace vfife

#endif
