// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_resonance_static_passage_h
#define vfife_reduced_resonance_static_passage_h

#include <vfife/reduced/reduced_pair.h>

#include <complex>
#include <vector>

namespace vfife
{
  struct Model;

  /**
   * One mesh cycle of a pair under its torque, so slowly that nothing vibrates: the static curves
   * of what the contact does to the modes of the driven body and of that body's turn, by harmonics
   * of the mesh cycle. Quantities X of the turning body with h nodal diameters are X(t) = sum over
   * p of X_p exp(i (h + p z) phi), phi what the body has turned about the axis of its sectors; h =
   * 0 for what belongs to the body as a whole.
   */
  class StaticPassage
  {
  public:
    /** At @p n_steps positions, in equilibrium at each of them. Leaves the @p pair, which has a
     * constant speed, there: set_speed() and start() lead back. Throws NumericalError. */
    StaticPassage(const Model &model, ReducedPair &pair, unsigned int n_steps);

    /** Of the modal forces of the harmonic in place @p harmonic. */
    Eigen::VectorXcd force(std::size_t harmonic, int p) const;
    /** Of the turn of the driven body's momentum in the drive direction [rad]. */
    std::complex<double> turn(int p) const;

    /** Moment of the contact on the driven body, + in the drive direction [N mm]. */
    double moment() const
    {
      return moment_;
    }
    /** Torque over rotation of the driven hub at the start [N mm/rad]. */
    double stiffness() const
    {
      return stiffness_;
    }

  private:
    /** exp(-i (h + p z) phi) at a step. */
    std::complex<double> phase(std::size_t step, unsigned int h, int p) const;

    unsigned int                               teeth_;
    double                                     sense_; ///< of the turn about the sectors' axis
    double                                     moment_ = 0, stiffness_ = 0;
    std::vector<unsigned int>                  numbers_; ///< of the harmonics
    std::vector<std::vector<Eigen::VectorXcd>> forces_;  ///< by step, harmonic
    std::vector<double>                        turns_;   ///< by step [rad]
  };
} // namespace vfife

#endif
