// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_friction_law_h
#define vfife_contact_law_friction_law_h

#include <memory>

namespace vfife
{
  /** Numbers of the friction laws, each of which uses some of them. */
  struct FrictionNumbers
  {
    double coefficient        = 0.; ///< mu, or mu_k of points that slide fast [-]
    double static_coefficient = 0.; ///< mu_s of points at rest [-]; 0: that of points that slide
    double decay_speed        = 0.; ///< v_c of the slip [mm/s]
  };

  /**
   * The largest tangential traction between two surfaces, or a body and a rigid wall. Below it
   * points stick elastically, at it they slide (slide()).
   */
  class FrictionLaw
  {
  public:
    virtual ~FrictionLaw() = default;

    /** Limit of the tangential traction [MPa] at the pressure [MPa] and the slip speed [mm/s]. */
    virtual double limit(double pressure, double speed) const = 0;

    /** Whether any pressure holds surfaces, at rest or at some speed. */
    bool acts() const
    {
      return limit(1., 0.) > 0. || (depends_on_speed() && limit(1., 1.) > 0.);
    }

    /** Whether limit() needs the speed; callers pass 0 otherwise. */
    virtual bool depends_on_speed() const = 0;
  };

  using MakeFrictionLaw = std::unique_ptr<const FrictionLaw> (*)(const FrictionNumbers &numbers);

  template <typename Law>
  std::unique_ptr<const FrictionLaw> make_friction_law(const FrictionNumbers &numbers)
  {
    return std::make_unique<const Law>(numbers);
  }

  /** What friction does with the places at which points stick. */
  enum class FrictionMode
  {
    follows, ///< a point that slides takes its anchor along: each evaluation is a step in time
    held,    ///< anchors stay where a load step began: evaluations look for its end
    none     ///< no friction
  };

  /** A point that friction acts on. */
  struct FrictionPoint
  {
    double pressure;       ///< normal to the surface [MPa]
    double speed;          ///< slip [mm/s]; 0 at rest or where the law does not depend on it
    double stiffness;      ///< with which it sticks [N/mm^3]
    double elastic_before; ///< displacement that the spring had before [mm]
    double area = 1.;      ///< [mm^2]; 1: energies are per area
  };

  /** What a spring behind a slider makes of a displacement from its anchor. */
  struct SliderResponse
  {
    double elastic_part = 1.; ///< of the displacement, that the spring keeps
    double elastic      = 0.; ///< size of that part [mm]
    double slid         = 0.; ///< what the slider takes [mm]
    double energy       = 0.; ///< of the spring, k elastic^2/2
    double loss         = 0.; ///< of the slider
  };

  /**
   * Elastic predictor and slider as return mapping: the spring of a point is displaced by
   * @p displacement [mm] from its anchor; beyond the limit of the @p law the slider gives way until
   * the spring carries just that. The loss takes the mean of the forces before and after, which
   * with the energies is the work of the trapezoidal rule that central differences have.
   */
  inline SliderResponse
  slide(const FrictionLaw &law, const FrictionPoint &point, const double displacement)
  {
    const double   k     = point.stiffness * point.area;
    const double   limit = law.limit(point.pressure, point.speed) * point.area;
    SliderResponse response;
    response.elastic = displacement;
    if (k * displacement > limit)
      {
        response.elastic      = limit / k;
        response.elastic_part = response.elastic / displacement;
        response.slid         = displacement - response.elastic;
        response.loss         = 0.5 * k * (point.elastic_before + response.elastic) * response.slid;
      }
    response.energy = 0.5 * k * response.elastic * response.elastic;
    return response;
  }
} // namespace vfife

#endif
