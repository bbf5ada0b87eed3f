// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_pair_readings_h
#define vfife_reduced_pair_readings_h

#include <vfife/reduced/reduced_body.h>

#include <complex>
#include <string>
#include <vector>

namespace vfife
{
  struct FemOptions;
  struct Model;

  /** Names of the readings of gear bodies. */
  namespace reading
  {
    extern const char *const bore_turn; ///< share of a sector of the bore's mean rotation [rad]
    extern const char *const rim_turn;  ///< the same of the rim
    /** Component of a probe by its name: displacements x, y, z [mm], then stresses as Stress has
     * them [MPa].
     */
    std::string of_probe(const std::string &probe, unsigned int component);
    /** Share of a sector of the rim's wave with n diameters along r, theta, z (c): the real part of
     * sum over nodes of share u exp(i n alpha), or the imaginary one [mm]. */
    std::string of_rim(unsigned int component, unsigned int diameters, bool imaginary);
  } // namespace reading

  /** Nodes of sector 0 whose copies lie on the surfaces of any contact pair of a body. */
  std::vector<unsigned int> list_touch_nodes(const Model &model, unsigned int body);

  /**
   * What a gear body of a pair shows: mean rotations of bore and rim about its axis, its probes
   * (each as its copy in sector 0), and of the driven body the waves of its rim with up to
   * @p largest_diameters. Stresses are those of the elements @p fem, linear in the
   * displacements, less what initial strains make of the undeformed body.
   */
  std::vector<SectorReading> list_readings(const Model      &model,
                                           unsigned int      body,
                                           const FemOptions &fem,
                                           unsigned int      largest_diameters);

  /** The wave w with @p diameters, of a rim's motion Re(w exp(i n alpha)) in turning axes along a
   * @p component (r, theta, z), of the @p coefficients that PairReader::read_rim() has [um]. */
  std::complex<double> find_rim_wave(const std::vector<double> &coefficients,
                                     unsigned int               component,
                                     unsigned int               diameters);
} // namespace vfife

#endif
