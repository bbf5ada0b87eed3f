// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_cyclic_cyclic_body_h
#define vfife_fem_cyclic_cyclic_body_h

#include <vfife/base/process/communicator.h>
#include <vfife/fem/modes/rotating_body.h>

#include <utility>
#include <vector>

namespace vfife
{
  /** A part of a linear reading: weight . u at a point of sector 0, of the displacements that the
   * point's copy has @p sector sectors further on, turned back (weight: fixed frame). */
  struct SectorTerm
  {
    unsigned int point  = 0;
    unsigned int sector = 0;
    Vector3      weight = Vector3::Zero();
  };
  /** The sum of its terms. */
  using SectorRow = std::vector<SectorTerm>;

  /** What a row reads of displacements that are the same in all sectors (3 a point of sector 0). */
  double read_row(const SectorRow &row, const std::vector<double> &u);

  /** Whether one sector tells the modes of the body: equal ones that are held alike, without loads,
   * bearings and couplings. */
  bool has_equal_sectors(const Model &model, unsigned int body, const FemSpaceOptions &options);

  /**
   * A body of equal sectors that are all held alike, in bearings too, about its state of steady
   * spin: what its harmonics (CyclicHarmonic) have in common. A hub that turns freely, or a shaft
   * that nothing drives, leaves a rigid turn, from which everything else is parted: fields are
   * M-orthogonal to it. One sector is little work, and each rank does it by itself: ranks share
   * harmonics.
   */
  class CyclicBody
  {
  public:
    /**
     * Throws InputError where sectors are no turned copies of each other, are not held or driven
     * alike, or the body can move otherwise than by turning about its axis, for bearings at rest
     * that are not alike across the axis, for loads and for initial strains that differ between
     * sectors; NumericalError where the body is not
     * stable at @p rate [rad/s].
     */
    CyclicBody(const Model &model, unsigned int body, const FemOptions &options, double rate);

    const Body     &body() const;
    const FemSpace &sector() const
    {
      return rotating_.space();
    }
    const FemOptions &options() const
    {
      return options_;
    }
    /** This rank alone. */
    const Communicator &communicator() const
    {
      return alone_;
    }
    unsigned int n_sectors() const;
    double       rate() const
    {
      return rate_;
    }

    /** Whether it spins or has initial strains. */
    bool deforms() const
    {
      return rotating_.deforms_at(rate_);
    }
    /** Displacements of the sector's points in the state of spin and initial strains, as K is taken
     * about them [mm]. */
    const std::vector<double> &equilibrium() const
    {
      return equilibrium_;
    }
    /** The same at another rate [rad/s]. */
    std::vector<double> find_equilibrium(double rate) const;
    /** The tangent about that state. */
    FemMatrix stiffness(const SystemMatrices &matrices) const;
    /** The state of spin without its rigid turn [mm]. */
    const std::vector<double> &spin() const
    {
      return spin_;
    }

    /** Whether nothing holds the turn about the axis. */
    bool turns() const
    {
      return turns_;
    }
    /** Whether spin may soften motions of harmonic @p number in bearings below zero, which Coriolis
     * forces keep stable. */
    bool whirls(unsigned int number) const;
    /** What hubs do in harmonics of vibrations. */
    HubRotation rotation() const
    {
      return options_.hold_hubs ? HubRotation::held : HubRotation::free;
    }
    /** Displacements of the sector's points in a small rigid turn of the spun body about its axis,
     * of those that are held as well, per angle [mm]. */
    const std::vector<double> &rigid_turn() const
    {
      return rigid_turn_;
    }
    /** The same of a body that turns(); zero of others [mm]. */
    const std::vector<double> &turn() const
    {
      return turn_;
    }
    /** Of the whole body [t mm^2]. */
    double turn_inertia() const
    {
      return turn_inertia_;
    }

    /** Forces at the sector's points of a unit torque on the body, the traction of the model's
     * torque; zero where it has none [1/mm]. */
    const std::vector<double> &torque() const
    {
      return torque_;
    }

    /** All sectors with elements as those of sector(). */
    const FemSpace &all_sectors() const
    {
      return rotating_.shown();
    }
    /** Reads points of all_sectors(), of which the body's nodes are the first, along directions in
     * axes of the body's frame. */
    SectorRow make_row(const std::vector<std::pair<unsigned int, Vector3>> &weights) const;

  private:
    void find_turn();
    void find_torque();

    const Model        &model_;
    unsigned int        body_;
    FemOptions          options_;
    Communicator        alone_;
    RotatingBody        rotating_;
    double              rate_;
    std::vector<double> equilibrium_, spin_, rigid_turn_, turn_, torque_;
    bool                turns_        = false;
    double              turn_inertia_ = 0;
  };
} // namespace vfife

#endif
