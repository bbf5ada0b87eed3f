// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_resonance_contact_meetings_h
#define vfife_reduced_resonance_contact_meetings_h

#include <vfife/base/text/table.h>
#include <vfife/reduced/body_waves.h>

#include <complex>
#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  class LinearResponse;

  /**
   * A rate at which a mesh order meets a free vibration of the driven body in contact: a pole of
   * its linear response over the rate, with all damping there is, that of the turn included. Other
   * than WaveMeeting, which knows the free body alone, it may be of several waves and of the swing
   * on the contact at a time.
   */
  struct ContactMeeting
  {
    unsigned int         mesh_order = 1;
    std::complex<double> rate       = 0; ///< the pole, about Body::axis [rad/s]

    /** The wave that has the largest part of the kinetic energy (0 diameters: the modes that move
     * all sectors alike), the mode with most of it among those of the diameters from 1 on, by
     * frequency; that part and the rigid turn's [-]. */
    unsigned int  diameters  = 0;
    std::size_t   harmonic   = 0; ///< its place among those of the body
    WaveDirection direction  = WaveDirection::backward;
    unsigned int  order      = 1;
    double        share      = 0;
    double        turn_share = 0;

    /** Residue of the mesh order's moment of the contact [N mm rad/s]: the response is this over
     * (rate - pole), and what is smooth. */
    std::complex<double> moment = 0;
    /** The same of the rigid turn. */
    std::complex<double> turn = 0;
    /** Of the coordinates of each harmonic of the body, waves against the spin and with it. */
    std::vector<Eigen::VectorXcd> backward, forward;

    /** Kinetic energy of the residues, of all waves and the turn. */
    double energy = 0;

    const std::vector<Eigen::VectorXcd> &residues(WaveDirection direction) const;
    /** Kinetic energy of coordinates with the @p squared length, which are of @p n diameters. */
    double energy_of(double squared, int n, int teeth, WaveDirection direction) const;
    /** Part of the kinetic energy in the waves of the harmonic in place @p harmonic. */
    double harmonic_share(std::size_t harmonic, const ReducedBody &body) const;
    /** Part of the kinetic energy in the wave of the free body, a driven one of the same order. */
    double share_of(const WaveMeeting &free, const ReducedBody &body) const;

    double width() const; ///< full, at half power, over the rate [-]
  };

  /** Meetings of the mesh orders 1 ... @p mesh_orders between the rates @p lowest (0: from rest on)
   * and @p highest (magnitudes) of a body that turns about Body::axis in the sense of @p turning;
   * ascending by rate. */
  std::vector<ContactMeeting> find_contact_meetings(const LinearResponse &linear,
                                                    unsigned int          mesh_orders,
                                                    double                lowest,
                                                    double                highest,
                                                    double                turning);

  /** Frequency of the vibration that is met, in axes that stand in space, at other @p rates
   * (magnitudes, ascending) [rad/s]; no number where it cannot be followed. */
  std::vector<double> follow_vibration(const LinearResponse      &linear,
                                       const ContactMeeting      &meeting,
                                       const std::vector<double> &rates);

  /** "n = 3 forward"; "torsional mode" where most of it is the rigid turn. */
  std::string describe_wave(const ContactMeeting &meeting);

  /** waves_in_contact.csv: a row a meeting. @p gains: of the rim's axial wave with that many
   * diameters [um] of unit coordinates; empty where the rim is not looked at. @p ratio: of the
   * driver's speed over the rate of the body, > 0; @p teeth: of the body. */
  Table make_contact_meeting_table(
    const std::vector<ContactMeeting>                                &meetings,
    const std::function<Eigen::RowVectorXcd(unsigned int diameters)> &gains,
    double                                                            ratio,
    unsigned int                                                      teeth);
} // namespace vfife

#endif
