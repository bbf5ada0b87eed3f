// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_body_waves_h
#define vfife_reduced_body_waves_h

#include <vfife/reduced/reduced_body.h>

#include <vector>

namespace vfife
{
  enum class WaveDirection
  {
    forward, ///< with the spin, as seen in the axes that turn with the body
    backward ///< against it
  };

  /** "forward", "backward". */
  const char *name_of(WaveDirection direction);

  /** Place of the harmonic with modes of @p diameters; throws InputError where there is none below
   * the cut-off. */
  std::size_t find_harmonic(const ReducedBody &body, unsigned int diameters);

  /** A travelling wave of a reduced body at one rate, without damping and contact: c = shape exp(i
   * omega t) in the harmonic with as many nodal diameters. */
  struct BodyWave
  {
    unsigned int     diameters     = 0;
    unsigned int     order         = 0; ///< from 1, among those of the diameters and direction
    WaveDirection    direction     = WaveDirection::backward;
    double           omega         = 0;  ///< signed: sectors follow with the phase h alpha [rad/s]
    double           kinetic_share = .5; ///< T/(T + U) in the turning axes
    Eigen::VectorXcd shape;              ///< of the harmonic's coordinates, of unit length

    double frequency() const; ///< > 0 [rad/s]
    /** By which exp(-... t) the amplitude decays under c'' + zeta c' [1/s]. */
    double decay_rate(double zeta) const;
    double damping_ratio(double zeta) const; ///< decay_rate over frequency [-]
  };

  /**
   * All waves of the harmonic in place @p harmonic, which is not half the number of sectors,
   * ascending within each direction: (K(rate) + 2 i rate omega G - omega^2) shape = 0. A vibration
   * without diameters has no direction and is called backward.
   * @p rate: about Body::axis [rad/s]; @p sense: of that axis about the axis of the sectors. At
   * rest the direction is that of the turn to come about Body::axis. Throws NumericalError where
   * the body is not stable at that rate.
   */
  std::vector<BodyWave>
  find_waves(const ReducedBody &body, std::size_t harmonic, double rate, double sense);

  /** A wave met by a force that stands in space with a multiple of the mesh frequency. */
  struct WaveMeeting
  {
    BodyWave     wave; ///< at the rate below
    unsigned int mesh_order = 1;
    double       rate       = 0; ///< about Body::axis, at which they meet [rad/s]
    /** d omega/d rate times rate over omega: of the wave's frequency. */
    double stiffening = 0;

    /** Of the force's frequency in the turning axes over the rate: k z + n against the spin, k z -
     * n with it. */
    unsigned int turns_order(unsigned int teeth) const;
    /** Of the force's motions exp(i (n + p z) phi), phi what the body has turned: the mesh order
     * for a wave against the spin, less than zero for one with it. */
    int mesh_harmonic() const;
  };

  /**
   * Where a mesh order meets the wave with the diameters, direction and order of @p wave: wave and
   * rate follow each other from @p rate (about Body::axis, its sign stays) until they agree, so
   * that the frequency is that of the rate where they meet. Throws InputError for diameters without
   * a mode below the cut-off, NumericalError as find_waves() and where they do not agree.
   */
  WaveMeeting find_wave_meeting(const ReducedBody &body,
                                const BodyWave    &wave,
                                unsigned int       mesh_order,
                                double             rate,
                                double             sense);
} // namespace vfife

#endif
