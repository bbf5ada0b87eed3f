// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_penalty_options_h
#define vfife_contact_law_penalty_options_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/contact/law/contact_law.h>

#include <string>

namespace vfife
{
  /** The penalty of contacts of general models is this times E* over h, E* the modulus of what
   * gives way and h the width of the facet that is pressed (doc/theory/contact.md, Penalty). */
  constexpr double facet_penalty_over_stiffness = 5.;

  /** eps [N/mm^3] of a facet of the @p width [mm] where E* is @p modulus [MPa]. */
  inline double compute_facet_penalty(const double modulus, const double width)
  {
    return facet_penalty_over_stiffness * modulus / width;
  }

  /** All laws that a user may choose, the default first: a new one is a row here. */
  const Choices<MakeContactLaw> &contact_laws();

  /**
   * The penalty eps [N/mm^3] of a contact between two bodies, or between a body and a rigid wall,
   * and the law that it scales: entries, and what it does to the largest stable step.
   *
   * Each contact point is a spring of stiffness eps A between n nodes that move: two, or one at a
   * wall. To the square of the highest circular frequency it adds at most n eps A/m (Gershgorin) of
   * the 4/dt^2 that central differences allow. Springs of points that stick in implicit contact
   * have at most f (m/A)/dt^2, m/A the least nodal mass per tributary area, which adds n f/dt^2.
   */
  struct PenaltyOptions
  {
    /** @p n_moving: bodies that give way, 2 or 1. */
    explicit PenaltyOptions(unsigned int n_moving = 2);

    static constexpr double stick_fraction = 0.5; ///< f [-]

    unsigned int n_moving;   ///< nodes at the ends of a spring that move
    double       value = 0.; ///< eps [N/mm^3]; 0: "auto", it follows from the facets or the case
    /** In words, how "auto" is derived (doc/theory/contact.md, Penalty). */
    std::string derivation =
      "5 E*/h, 1/E* the sum of (1 - nu^2)/E of the bodies, h the width of the facet";
    /** Entry "contact law" where there is more than one. */
    MakeContactLaw law = contact_laws().front().second;

    /** Declares the entries in the subsection entered. */
    void declare(dealii::ParameterHandler &prm);

    /** Throws InputError naming the entry relative to @p section where a value is out of its range.
     */
    void check(const std::string &section) const;

    /** Whether it is "auto". */
    bool is_open() const
    {
      return value == 0.;
    }

    /** Stiffness [N/mm^3] of points that stick which the step @p dt [s] bears, by the least nodal
     * mass per area [t/mm^2]. */
    static double stick_value(double mass_per_area, double dt);

    /** Penalty [N/mm^3] beyond which an impact leaves implicit contact rattling at the step
     * @p dt [s] (doc/theory/contact.md, In time). */
    static double rattling_value(double mass_per_area, double dt);

    /** The mass per area [t/mm^2] of which a penalty is the stick_value(). */
    static double mass_per_area_for(double penalty, double dt);

    /** Largest stable step [s] where everything else allows @p step, with the springs of the
     * penalty, or with points that stick. */
    double vote_on_step(double step, double mass_per_area) const;
    double vote_of_stick(double step) const;

    /** Mass that a node needs for a spring of @p stiffness in a relaxation with pseudo time step 1,
     * so that omega is at most twice @p fraction. */
    double relaxation_mass(double stiffness, double fraction) const;
  };
} // namespace vfife

#endif
