// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_bearing_bearing_law_h
#define vfife_bearing_bearing_law_h

#include <vfife/base/types.h>

namespace vfife
{
  using Vector5 = Eigen::Matrix<double, 5, 1>;
  using Matrix5 = Eigen::Matrix<double, 5, 5>;

  /** What a bearing does to the shaft in it. */
  struct BearingResponse
  {
    /** On the shaft: forces along x, y, z [N] and moments about x, y [N mm]. */
    Vector5 load = Vector5::Zero();
    /** -d load / d displacement, symmetric [N/mm, N, N mm]. */
    Matrix5 stiffness = Matrix5::Zero();
    /** Of which the load is minus the gradient [mJ]. */
    double energy = 0;
    /** d energy / d turn: what drives a cage that rolls [N mm]. */
    double turn_slope = 0;
  };

  /**
   * The law of a bearing: what it exerts on the shaft when the shaft's seat has moved by x, y, z
   * [mm] and is tilted about x, y [rad], in axes at rest of which z lies along the shaft. It does
   * not hold the turn about z, on which only a cage that rolls depends.
   */
  class BearingLaw
  {
  public:
    virtual ~BearingLaw() = default;

    /** @p turn: of the shaft about z since time zero [rad]. */
    virtual BearingResponse evaluate(const Vector5 &displacement, double turn) const = 0;

    BearingResponse evaluate(const Vector5 &displacement) const
    {
      return evaluate(displacement, 0.);
    }

    /** The linear law that solvers for small displacements take: what it exerts without
     * displacement, and its stiffness. */
    virtual BearingResponse linearized() const
    {
      return evaluate(Vector5::Zero());
    }

    /** At least as stiff as the bearing is under loads that it can carry. */
    virtual Matrix5 stiffness_bound() const
    {
      return linearized().stiffness;
    }

    /** Ways up to which a curve of loads over displacements is worth a look [mm]; 0: it is a
     * straight line. */
    virtual double curve_range() const
    {
      return 0.;
    }

    /** -d load / d rate of the displacements, symmetric [N s/mm, N s, N mm s]. */
    const Matrix5 &damping() const
    {
      return damping_;
    }

  protected:
    explicit BearingLaw(const Matrix5 &damping)
      : damping_(damping)
    {
    }

  private:
    Matrix5 damping_;
  };

  /** load = preload - stiffness displacement. */
  class LinearBearing : public BearingLaw
  {
  public:
    LinearBearing(const Matrix5 &stiffness, const Matrix5 &damping, const Vector5 &preload);

    using BearingLaw::evaluate;
    BearingResponse evaluate(const Vector5 &displacement, double turn) const override;

  private:
    Matrix5 stiffness_;
    Vector5 preload_;
  };
} // namespace vfife

#endif
