// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_contact_options_h
#define vfife_contact_law_contact_options_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/contact/law/friction_options.h>
#include <vfife/contact/law/penalty_options.h>

#include <algorithm>
#include <string>

namespace vfife
{
  /** Where the contact pressure is sampled. */
  enum class ContactDiscretization
  {
    surface_points, ///< Gauss points of the slave's facets against the master's facets
    two_pass,       ///< the mean of surface_points and of the same with slave and master swapped
    nodes           ///< the corners of the slave's facets (node to surface), for comparison
  };

  /** What the facets stand for. */
  enum class ContactSurfaceKind
  {
    automatic,  ///< true_flank; of general models smooth_patches, or flat_facets where there are
                ///< edges
    true_flank, ///< offsets to the true surface and its normals, carried along by the deformation
    smooth_patches, ///< offsets to quadratic patches with the nodal normals (smooth_patch.h)
    flat_facets     ///< the bilinear facets themselves with averaged facet normals
  };

  /** When in a step of explicit dynamics the pressure is taken. */
  enum class ContactTime
  {
    implicit, ///< the mean over the step, of the gaps at both ends (PressureSolver)
    explicit_ ///< of the gap before the step
  };

  const Choices<ContactDiscretization> &contact_discretizations();
  const Choices<ContactSurfaceKind>    &contact_surface_kinds();
  const Choices<ContactTime>           &contact_times();

  /** Options of the contact between two surfaces (section "Contact"). */
  struct ContactOptions
  {
    ContactDiscretization discretization = ContactDiscretization::surface_points;
    ContactSurfaceKind    surface        = ContactSurfaceKind::true_flank;
    /** Gauss points per direction, or "auto": the number, unless a case knows the contact's width
     * (points_across()). */
    NumberOrWord points_per_facet = {3, true};

    ContactTime    time = ContactTime::implicit;
    PenaltyOptions penalty;

    double damping_ratio = 0.; ///< of the critical gap-rate damping of a surface node [-]

    FrictionOptions friction;

    double edge_fading = 0.15; ///< part of a master border facet over which the pressure fades [-]
    double edge_relief_width = 0.; ///< of both flanks along free edges [mm]; 0: no relief
    double edge_relief_depth = 0.; ///< at the edge itself [mm]
    double search_skin       = 0.; ///< [mm]; 0: a fifth of the master's mean facet size
    double depth_limit       = 0.; ///< deepest penetration taken for contact [mm]; 0: half a facet
    double penetration_limit =
      0.2; ///< penetration over the depth limit at which a run is given up [-]; 1: never

    /** The gap-rate damping that acts, with and without friction. */
    double gap_damping_ratio() const
    {
      return friction.acts() ? std::max(damping_ratio, friction.damping_ratio) : damping_ratio;
    }

    /** Declares the entries in the subsection entered (the caller enters "Contact"). */
    void declare(dealii::ParameterHandler &prm);

    /** Throws InputError when the options contradict each other (entries named relative to @p
     * section). */
    void check(const std::string &section) const;
  };

  /** Points per direction of facets of width @p facet such that four lie across a contact of width
   * @p contact [mm], 3 to 12: pressure, force and its ripple then hardly depend on their number
   * (doc/theory/contact.md, Points). */
  unsigned int points_across(double facet, double contact);
} // namespace vfife

#endif
