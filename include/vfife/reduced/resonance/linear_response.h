// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_resonance_linear_response_h
#define vfife_reduced_resonance_linear_response_h

#include <vfife/base/types.h>
#include <vfife/reduced/modal_motion.h>
#include <vfife/reduced/reduced_body.h>

#include <functional>
#include <vector>

namespace vfife
{
  class StaticPassage;

  /**
   * Steady vibration of the driven body by linear theory (doc/theory/waves.md): static curves of a
   * slow mesh cycle at constant torque, and what the contact, a linear spring between the flanks,
   * makes of it since turn and modes do not follow at the mesh frequency as they do at rest.
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

    /** The harmonic @p p (not 0) of the mesh of the contact's moment at @p rate about Body::axis
     * [rad/s, N mm]. Complex rates, here as below, continue what is analytic in real ones. */
    std::complex<double> moment(int p, const std::complex<double> &rate) const;

    /** The harmonic @p p of the mesh in the coordinates of the harmonic in place @p harmonic under
     * the static curve's forces and the @p moment of the contact with it. */
    Eigen::VectorXcd coordinates(std::size_t                 harmonic,
                                 int                         p,
                                 const std::complex<double> &rate,
                                 const std::complex<double> &moment) const;

    /** The rigid turn of the driven body under a @p moment of the mesh harmonic @p p [rad]. */
    std::complex<double>
    turn(int p, const std::complex<double> &rate, const std::complex<double> &moment) const;

    /** What the flanks give way by under a unit moment exp(i frequency t): contact, turn and modes
     * [1/(N mm)]. @p frequency: in axes that stand in space, in the sense of the sectors [rad/s].
     * It is zero where that is the frequency of a free vibration in contact. */
    std::complex<double> loop_compliance(const std::complex<double> &frequency,
                                         const std::complex<double> &rate) const;
    /** Frequency of the mesh harmonic @p p, in axes that stand in space [rad/s]. */
    std::complex<double> mesh_frequency(int p, const std::complex<double> &rate) const;

    /** All rates at which the mesh harmonic @p p > 0 has the frequency of a free vibration in
     * contact, in both senses of rotation [rad/s]: zeros of loop_compliance() at mesh_frequency().
     * Vibrations that the contact does not feel are among them. */
    std::vector<std::complex<double>> resonance_rates(int p) const;

    const ReducedBody &body() const
    {
      return body_;
    }
    /** Of Body::axis about the axis of the sectors: 1 or -1. */
    double sense() const
    {
      return sense_;
    }

    /** Rotation of the driven flank under the contact's own spring: turn per moment of the driven
     * body at rest less what its modes give way [1/(N mm)]. */
    double contact_compliance() const
    {
      return compliance_;
    }

  private:
    /** (K - omega^2 + i omega (2 rate G + zeta))^-1 times @p force, omega that of the harmonic in
     * its turning axes at the @p frequency. */
    Eigen::VectorXcd answer(std::size_t             harmonic,
                            const Complex          &frequency,
                            const Complex          &rate,
                            const Eigen::VectorXcd &force) const;
    /** What modes turn the driven flank at the @p frequency under modal forces of all harmonics;
     * those of the second argument -1 go with the negative frequency. */
    using ForceOf = std::function<Eigen::VectorXcd(std::size_t harmonic, int sign)>;
    Complex flank_turn(const Complex &frequency, const Complex &rate, const ForceOf &force) const;
    /** The rigid turn under a unit moment. */
    Complex turn_compliance(const Complex &frequency) const;

    const ReducedBody            &body_;
    const StaticPassage          &passage_;
    ModalDamping                  damping_;
    double                        sense_;
    double                        compliance_ = 0;
    std::vector<Eigen::VectorXcd> per_moment_; ///< modal forces per moment, by harmonic
  };
} // namespace vfife

#endif
