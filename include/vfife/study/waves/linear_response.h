// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_linear_response_h
#define vfife_study_waves_linear_response_h

#include <vfife/reduced/modal_motion.h>
#include <vfife/reduced/reduced_body.h>

#include <complex>

namespace vfife
{
  class StaticPassage;

  /**
   * Steady vibration of the driven body by linear theory (doc/waves.md): static curves of a slow
   * tooth mesh at constant torque, and what the contact, a linear spring between the flanks, makes
   * of it since turn and modes do not follow at the mesh frequency as they do at rest.
   */
  class LinearResponse
  {
  public:
    /** Both must outlive the object. @p sense: of Body::axis about the axis of the sectors;
     * @p driven_sense: of the drive direction about Body::axis. */
    LinearResponse(const ReducedBody   &body,
                   const StaticPassage &passage,
                   const ModalDamping  &damping,
                   double               sense,
                   double               driven_sense);

    /** The harmonic @p p of the mesh in the coordinates of the harmonic in place @p harmonic at
     * @p rate about Body::axis [rad/s]. */
    Eigen::VectorXcd coordinates(std::size_t harmonic, int p, double rate) const;

    /** Rotation of the driven flank under the contact's own spring: turn per moment of the driven
     * body at rest less what its modes give way [1/(N mm)]. */
    double contact_compliance() const
    {
      return compliance_;
    }

  private:
    /** (K - omega^2 + i omega (2 rate G + zeta))^-1 times @p force, omega = (h + p z) phi'. */
    Eigen::VectorXcd
    answer(std::size_t harmonic, int p, double rate, const Eigen::VectorXcd &force) const;
    /** What modes turn the driven flank at the harmonic p > 0 under modal forces of all harmonics,
     * those of the static curve or, @p by_moment, of a unit moment. */
    std::complex<double> flank_turn(int p, double rate, bool by_moment) const;
    std::complex<double> find_moment(int p, double rate) const;
    /** Modal forces per moment of the contact. */
    Eigen::VectorXcd per_moment(std::size_t harmonic) const;

    const ReducedBody   &body_;
    const StaticPassage &passage_;
    ModalDamping         damping_;
    double               sense_;
    double               compliance_ = 0;
  };
} // namespace vfife

#endif
