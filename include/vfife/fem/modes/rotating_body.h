// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_modes_rotating_body_h
#define vfife_fem_modes_rotating_body_h

#include <vfife/base/types.h>
#include <vfife/fem/fem_options.h>
#include <vfife/fem/modes/modal_solver.h>
#include <vfife/fem/modes/mode_description.h>
#include <vfife/fem/modes/sector_copies.h>

#include <memory>
#include <vector>

namespace vfife
{
  /** A natural vibration of a body that turns, as seen by an observer that turns with it. */
  struct RotatingMode
  {
    double frequency = 0; ///< [Hz]
    double residual  = 0;
    /** T/(T + U) of the energies in the turning axes: 1/2 without Coriolis forces, negative for a
     * wave that the spin has overtaken [-]. */
    double kinetic_share = 0.5;
    /** What rigid motions change of the damping, which are damped relative to the ground where
     * bearings oppose them, and not where nothing does; part of that of the whole shape [-]. */
    double          rigid_damping = 0;
    ModeDescription description;
    /** As in Mode; not a number with Coriolis forces. */
    std::array<double, 6> effective_mass = {
      {not_known, not_known, not_known, not_known, not_known, not_known}};
    /** Displacements of the points of RotatingBody::shown(), 3 a point, fixed frame, largest 1 mm.
     * Nodes of the body come first. */
    std::vector<double> shape;

    /** Whether the body turns faster than the wave, which started in the sense of the spin: its
     * energy in turning axes is negative. */
    bool is_overtaken() const
    {
      return kinetic_share < 0;
    }

    /** Of the damping of runs (doc/theory/dynamics.md, Damping ratio), to the first order of zeta
     * [1/s]; not a number for a rigid motion [-]. */
    double damping_ratio(double zeta) const;
  };

  /** All modes of one body at one speed. */
  struct ModesAtSpeed
  {
    double rate = 0; ///< [rad/s]
    /** Of the body's axis, about which effective inertias are (fixed frame) [mm]. */
    Vector3                   axis_point = Vector3::Zero();
    std::vector<RotatingMode> modes; ///< ascending
    unsigned int              n_rigid = 0, n_unknowns = 0;
    bool                      counted = false;
    double                    growth  = 0; ///< largest displacement under spin [mm]
    double                    memory  = 0; ///< of the factors [MB]
  };

  /**
   * Vibrations of one body of a model about its state of steady spin: geometric stiffness of the
   * centrifugal stresses, spin softening and, when asked for, Coriolis forces (doc/theory/fem.md).
   * Either the whole body, or one of its sectors harmonic by harmonic, which gives the same numbers
   * for a fraction of the work. Collective.
   */
  class RotatingBody
  {
  public:
    RotatingBody(const Model        &model,
                 unsigned int        body,
                 const FemOptions   &options,
                 const Communicator &communicator);
    ~RotatingBody();

    /** Throws NumericalError where the body is not stable at that rate [rad/s]. */
    ModesAtSpeed find_modes(double rate) const;

    /** Displacements of all points in steady spin (of the sector, where one is computed). */
    std::vector<double> find_equilibrium(double rate) const;
    /** Whether these are not zero: the body spins or has initial strains. */
    bool deforms_at(double rate) const;

    const FemSpace &space() const
    {
      return space_;
    }
    /** All sectors, where one is computed too: points of shapes, between the nodes as well where
     * elements have some there. */
    const FemSpace &shown() const
    {
      return shown_ ? *shown_ : space_.degree() > 1 ? space_ : whole_;
    }
    /** Points of shown() as copies of those of space(); nullptr where points are nodes, and for
     * whole bodies. */
    const SectorCopies *copies() const
    {
      return copies_.get();
    }
    /** All sectors, where one is computed too. */
    const FemSpace &whole() const
    {
      return whole_;
    }

  private:
    /** One sector: the lowest modes of the whole body, of as many diameters as have them. */
    void
    find_lowest(double rate, const std::vector<double> &equilibrium, ModesAtSpeed &result) const;
    /** Rigid motions that nothing holds, but for the turn about the axis of a hub or in bearings.
     */
    unsigned int count_free_motions() const;
    /** Whether that turn is all that bearings leave free. */
    bool turns_in_bearings(const std::vector<std::vector<double>> &motions) const;
    void solve_harmonic(double                     rate,
                        const std::vector<double> &equilibrium,
                        unsigned int               harmonic,
                        unsigned int               n_modes,
                        ModesAtSpeed              &result) const;
    void add_modes(const SystemMatrices &matrices,
                   unsigned int          harmonic,
                   const ModalResult    &found,
                   ModesAtSpeed         &result) const;
    /** Of the whole body, by a mode of one sector; @p loads: M r of six unit motions, none in
     * harmonics that these are not in. */
    std::array<double, 6> compute_effective_mass(const std::vector<std::vector<double>> &loads,
                                                 unsigned int                            harmonic,
                                                 const std::vector<double> &shape) const;
    unsigned int          largest_diameter() const
    {
      return model_.bodies[body_].structure().n_sectors() / 2;
    }
    /** Tells whether no lower wave can be missing. */
    bool add_waves(const SystemMatrices &matrices,
                   unsigned int          harmonic,
                   double                rate,
                   const FemMatrix      &stiffness,
                   const FemMatrix      &mass,
                   const ModalResult    &found,
                   unsigned int          n_asked,
                   ModesAtSpeed         &result) const;
    /** Rigid motions that nothing opposes, as displacements of all points (each copy). */
    std::vector<std::vector<double>> rigid_motions(const FemSystem &system,
                                                   unsigned int     harmonic) const;
    std::vector<double> whole_shape(const std::vector<double> &shape, unsigned int harmonic) const;

    const Model        &model_;
    unsigned int        body_;
    FemOptions          options_;
    const Communicator &communicator_;
    FemSpace            space_;
    FemSpace            whole_; ///< of eight-node elements, for describing modes
    /** For shapes of a sector with points between the nodes; none otherwise. */
    std::unique_ptr<const FemSpace>     shown_;
    std::unique_ptr<const SectorCopies> copies_;
    ModeDescriber                       describer_;
  };
} // namespace vfife

#endif
