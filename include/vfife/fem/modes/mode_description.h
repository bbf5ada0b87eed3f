// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_modes_mode_description_h
#define vfife_fem_modes_mode_description_h

#include <vfife/fem/modes/cyclic_copies.h>
#include <vfife/fem/system/fem_space.h>

#include <complex>
#include <vector>

namespace vfife
{
  /** What a mode of a body made of equal sectors looks like, whatever file or shape it came of. */
  struct ModeDescription
  {
    /** Waves around the axis (harmonic with the largest kinetic energy), at most half the number of
     * sectors; -1 for bodies that are not made of sectors. */
    int    nodal_diameter = -1;
    double share          = 0; ///< of that harmonic in the kinetic energy
    /** Sign changes along the radius of the largest component; -1 as above. */
    int nodal_circles = -1;
    /** Shares of axial, radial and tangential motion in the kinetic energy (row sums of mass). */
    double axial = 0, radial = 0, tangential = 0;
    /** Part of the harmonic's energy that travels in the + sense about the axis, for a complex
     * shape u exp(i omega t); 1/2 for standing waves. */
    double forward = .5;
    /** Whether the waves come in pairs, which travel to either side: with no diameter, and with as
     * many as half the sectors, a mode is alone and stands. */
    bool is_pair = false;
  };

  /** Describes modes of one body that is as a whole part of a space. */
  class ModeDescriber
  {
  public:
    ModeDescriber(const FemSpace &space, const FemSpace::Part &part);

    ModeDescription describe(const std::vector<double> &shape) const;

    /** The same for the complex shape @p real + i @p imaginary. */
    ModeDescription describe(const std::vector<double> &real,
                             const std::vector<double> &imaginary) const;

  private:
    using Amplitudes = std::vector<std::complex<double>>;

    Vector3    components(unsigned int node, const std::vector<double> &shape) const;
    double     first_mass(std::size_t i) const; ///< of node i of the first sector
    Amplitudes harmonic(const Amplitudes &values, int h) const;
    int        count_circles(const Amplitudes &amplitudes, unsigned int component) const;

    const FemSpace      &space_;
    unsigned int         first_point_;
    const Body          &body_;
    CyclicCopies         copies_;
    std::vector<Matrix3> axes_;  ///< r, theta, z of each node (columns)
    std::vector<double>  radii_; ///< of the nodes of the first sector [mm]
  };
} // namespace vfife

#endif
