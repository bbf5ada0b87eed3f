// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_bearing_rolling_bearing_h
#define vfife_bearing_rolling_bearing_h

#include <vfife/bearing/bearing_law.h>

#include <vector>

namespace vfife
{
  enum class RollingElement
  {
    ball,
    roller ///< cylindrical with contact angle 0, tapered otherwise
  };

  /** A row of rolling elements of steel between raceways of steel. */
  struct RollingBearingData
  {
    RollingElement element          = RollingElement::ball;
    unsigned int   n                = 0;    ///< elements
    double         diameter         = 0;    ///< of an element [mm]
    double         length           = 0;    ///< of a roller's contact [mm]
    double         pitch_diameter   = 0;    ///< of the elements' centres [mm]
    double         contact_angle    = 0;    ///< without load [rad], not negative
    double         clearance        = 0;    ///< diametral; negative: interference [mm]
    double         inner_conformity = 0.52; ///< raceway's groove radius over ball diameter
    double         outer_conformity = 0.52;
    double         sense            = 1;     ///< +1: holds the shaft against ways along +z, or -1
    double         cage_angle       = 0;     ///< of the first element from x at time zero [rad]
    bool           cage_rolls       = false; ///< between the turning inner and the fixed outer ring
    double         preload          = 0;     ///< axial force of the undisplaced bearing [N]
    Vector3        working_load     = Vector3::Zero(); ///< at which it is linearized [N]
    double         youngs_modulus   = 208000;          ///< [MPa]
    double         poissons_ratio   = 0.3;
  };

  /**
   * Static equilibrium of a rolling bearing without friction, spin and forces of inertia of its
   * elements (Harris, Rolling Bearing Analysis; de Mul, Vree, Maas 1989): a ball lies on the line
   * between the centres of curvature of both grooves and is pressed by Hertz's law, inner and outer
   * contact in series; a roller by Palmgren's line contact, q in slices along its length. The load
   * is the gradient of an energy. Rings are round and rigid, displacements small against the
   * bearing.
   */
  class RollingBearing : public BearingLaw
  {
  public:
    /** Throws InputError, naming the entry, for sizes that contradict each other, an interference
     * that jams it, a preload that it cannot take, and a working load that it cannot carry. */
    RollingBearing(const RollingBearingData &data, const Matrix5 &damping);

    using BearingLaw::evaluate;
    /** Of the displacements from the preloaded state. */
    BearingResponse evaluate(const Vector5 &displacement, double turn) const override;
    /** About the state under the working load. */
    BearingResponse linearized() const override;
    Matrix5         stiffness_bound() const override;
    /** Elements are then pressed by some thousand MPa. */
    double curve_range() const override;

    /** Turn of the cage over that of the shaft: elements roll on the fixed outer ring, their middle
     * at half the speed of the inner one's race, (1 - D cos(contact angle)/pitch diameter)/2; 0 for
     * a cage that stands. */
    double cage_share() const;

    /** Forces between each element and the inner ring [N]; displacements as of evaluate(). */
    std::vector<double> element_forces(const Vector5 &displacement) const;

    /** Where the shaft's seat is under a force without tilting [N]; x, y, z [mm]. Throws InputError
     * where it finds no equilibrium. */
    Vector3 displacement_under(const Vector3 &force) const;

  private:
    /** With the first element at the angle @p first [rad] from x; the slope of the energy is that
     * with this angle. */
    BearingResponse
    of_balls(const Vector5 &displacement, double first, std::vector<double> *forces) const;
    BearingResponse
    of_rollers(const Vector5 &displacement, double first, std::vector<double> *forces) const;
    BearingResponse
         respond(const Vector5 &displacement, double first, std::vector<double> *forces) const;
    void check_interference() const;
    void find_preload();

    RollingBearingData data_;
    double             constant_ = 0; ///< force over depth^1.5 or depth^(10/9) of a whole roller
    double             offset_   = 0; ///< along z in the preloaded state [mm]
    BearingResponse    linearized_;
  };
} // namespace vfife

#endif
