// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_coulomb_slider_h
#define vfife_contact_law_coulomb_slider_h

namespace vfife
{
  /** What friction does with the places at which points stick. */
  enum class FrictionMode
  {
    follows, ///< a point that slides takes its anchor along: each evaluation is a step in time
    held,    ///< anchors stay where a load step began: evaluations look for its end
    none     ///< no friction
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
   * Elastic predictor and Coulomb's slider as return mapping: the spring of stiffness @p k is
   * displaced by @p displacement [mm] from its anchor; beyond the force @p limit (mu times the
   * normal one) the slider gives way until the spring carries just that. The loss takes the mean of
   * the forces before (@p elastic_before) and after, which with the energies is the work of the
   * trapezoidal rule that central differences have. Forces may be tractions: energies are per area
   * then.
   */
  inline SliderResponse
  slide(const double displacement, const double limit, const double k, const double elastic_before)
  {
    SliderResponse response;
    response.elastic = displacement;
    if (k * displacement > limit)
      {
        response.elastic      = limit / k;
        response.elastic_part = response.elastic / displacement;
        response.slid         = displacement - response.elastic;
        response.loss         = 0.5 * k * (elastic_before + response.elastic) * response.slid;
      }
    response.energy = 0.5 * k * response.elastic * response.elastic;
    return response;
  }
} // namespace vfife

#endif
