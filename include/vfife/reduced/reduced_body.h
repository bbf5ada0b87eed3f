// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_reduced_body_h
#define vfife_reduced_reduced_body_h

#include <vfife/base/types.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  class ByteStream;

  /** What acts about the axis of rotation of a body, on all sectors alike. */
  struct AxialLoad
  {
    double torque       = 0; ///< of the model's traction [N mm]
    double acceleration = 0; ///< angular, of what the body turns with: Euler forces [rad/s^2]
  };

  /** A linear reading of a body's displacements, of sector 0; sector k reads the same of itself,
   * turned. */
  struct SectorReading
  {
    std::string name;
    /** Nodes of the body, in its whole numbering and of any sector (of sector 1 or the last one
     * where the elements of a border take part), then points between them as FemSpace numbers
     * them, with what multiplies their displacements: in axes of the body frame. */
    std::vector<std::pair<unsigned int, Vector3>> weights;
  };

  /**
   * A body of N equal sectors as few numbers: its modes below a cut-off, by harmonics h, and the
   * static flexibility that is left without them, between the nodes of one sector that forces act
   * on and its rows (doc/theory/reduced.md). Small motions in axes that turn with the body, on top
   * of its state of steady spin.
   *
   * Sector k has the displacements u_k = Re(R^k z c exp(i h k alpha)) of a mode, R the turn by one
   * sector about compute_sector_axis(), z the shape and c the complex coordinate of the mode (real
   * for h = 0 and N/2). Coordinates are such that the kinetic energy is |c'|^2/2. Forces f_k on
   * sector k, turned back by k sectors, give the modal force g = sum_k exp(-i h k alpha) z^H f_k,
   * and c'' + 2 Omega G c' + lambda c = g. Beside that sector k + d has the displacements
   * residual[d + reach] f_k, in its own axes, turned back by k + d sectors.
   */
  struct ReducedBody
  {
    /** The modes with h nodal diameters. */
    struct Harmonic
    {
      unsigned int     number = 0;  ///< h = 0 ... N/2
      Eigen::VectorXd  eigenvalues; ///< lambda, of K(u_s) - Omega^2 S + hub curvature [1/s^2]
      Eigen::MatrixXcd coriolis;    ///< of a unit rate, skew-Hermitian [-]
      /** d(Phi^H K Phi)/d(Omega^2) of the same matrix, Hermitian [-]: the secant between the rate
       * and (sqrt(2) - 1) times that. */
      Eigen::MatrixXcd spin_stiffness;
      Eigen::MatrixXcd shapes; ///< the rows of sector 0, a column a mode [t^-1/2]
      Eigen::VectorXcd torque; ///< modal forces of a unit torque about the axis; empty for h > 0
      /** Modal forces of the Euler force of a unit angular acceleration about the axis; empty for h
       * > 0, zero where the body turns freely. */
      Eigen::VectorXcd euler;
      /** Of h < 2: motions of the rings are Re(rings c), six rows each as in Rings; modal forces of
       * loads w on them rings^H w. Empty without rings. */
      Eigen::MatrixXcd rings;

      unsigned int n_modes() const
      {
        return eigenvalues.size();
      }
      /** Modal forces; zero for h > 0. */
      Eigen::VectorXcd forces_of(const AxialLoad &load) const;
    };

    /**
     * Mean motions of rings of a body that hangs in bearings, in axes of the body frame: six rows
     * each, displacement and turn. They are of the harmonics 0 (along the axis and about it) and 1
     * (across it) alone. K of the body has the linear springs `stiffness` for its bearings.
     */
    struct Rings
    {
      std::vector<std::string> names;          ///< list_rings()
      std::vector<Vector3>     centres;        ///< undeformed [mm]
      unsigned int             n_bearings = 0; ///< the first rings are seats of bearings
      /** Of the bearings, six rows each [N/mm, N, N mm]. */
      Eigen::MatrixXd stiffness;
      /** Of the whole body about its centre of mass [t, t mm^2]. */
      Eigen::Matrix<double, 6, 6> inertia = Eigen::Matrix<double, 6, 6>::Zero();
      /** Loads w on the rings displace the rows of sector k by Re(answers[h] w exp(i h k alpha)),
       * h = 0, 1, less what the modes do statically; and forces at touch nodes the rings by the
       * transposed. */
      std::array<Eigen::MatrixXcd, 2> answers;
      /** The rings under loads on them, less the modes' part. */
      Eigen::MatrixXd residual;
      /** In the state of spin; under a unit torque about the axis and under the Euler force of a
       * unit angular acceleration, less the modes' part. */
      Eigen::VectorXd spin, torque, euler;

      std::size_t size() const
      {
        return names.size();
      }
      /** Place of a ring; throws std::logic_error where there is none. */
      unsigned int find(const std::string &name) const;
    };

    unsigned int n_sectors        = 0;
    unsigned int nodes_per_sector = 0;
    double       sector_angle     = 0; ///< alpha = 2 pi/N, + about compute_sector_axis() [rad]
    double       rate   = 0; ///< at which the state of spin was taken, about Body::axis [rad/s]
    double       cutoff = 0; ///< modes below are kept [rad/s]

    /** Nodes of sector 0 that forces act on; rows 3 i + c: displacement of node i along axis c of
     * the body frame. */
    std::vector<unsigned int>  touch_nodes;
    std::vector<SectorReading> readings; ///< rows 3 n_touch + i

    std::vector<Harmonic> harmonics; ///< those with a mode, ascending

    /** Residuals are kept for the sectors from -reach to +reach of the loaded one. */
    unsigned int reach = 0;
    /** [d + reach]: the rows of sector d under unit forces along the body frame's axes at the touch
     * nodes of sector 0, less what the modes do statically [mm/N]. Where both ends are the same
     * sector (2 reach = N), the first one is zero. */
    std::vector<Eigen::MatrixXd> residual;
    /** Sum over all sectors of what a reading is under unit forces at the touch nodes of sector 0,
     * less what the modes do statically; a row a reading. */
    Eigen::MatrixXd summed_residual;
    /** Largest entry at touch rows of sectors that are not kept over the largest of those kept,
     * among at most 32 touch nodes. */
    double          residual_left = 0;
    Eigen::VectorXd torque_residual; ///< rows under a unit torque, less the modes' part [1/N]
    /** The same under the Euler force of a unit angular acceleration [mm s^2]. */
    Eigen::VectorXd euler_residual;
    /** Rows in the state of spin: what the weights read of it (a hub that turns freely: without its
     * turn). */
    Eigen::VectorXd spin;

    /** The hub turns freely: the rigid turn of the spun body by a small angle theta [rad] about
     * Body::axis is a coordinate of its own, from which all displacements above are free: theta' is
     * the angular momentum about the axis over turn_inertia, but for what Coriolis forces add:
     * turn_inertia theta'' + 2 Omega Re(turn_coriolis . c') = moment about the axis, and the modes
     * of h = 0 get g + 2 Omega turn_coriolis theta'. */
    bool            turns        = false;
    double          turn_inertia = 0; ///< about the axis, of the spun body [t mm^2]
    Eigen::VectorXd turn_coriolis;    ///< of the modes of h = 0 and a unit rate [t^1/2 mm]

    unsigned int n_unknowns = 0;     ///< of the largest system solved
    bool         counted    = false; ///< factorizations count as many modes below the cut-off
    double       memory     = 0;     ///< of the largest factors [MB]

    Rings rings; ///< of a body in bearings

    /** Sector of a node in the body's whole numbering. */
    unsigned int sector_of(const unsigned int node) const
    {
      return node / nodes_per_sector;
    }
    /** The same place in sector 0. */
    unsigned int first_copy(const unsigned int node) const
    {
      return node % nodes_per_sector;
    }

    unsigned int n_rows() const
    {
      return 3 * touch_nodes.size() + readings.size();
    }
    /** A row under @p load, less the modes' part. */
    double read_axial(const Eigen::Index row, const AxialLoad &load) const
    {
      return load.torque * torque_residual[row] + load.acceleration * euler_residual[row];
    }
    /** Place of a reading among the readings; throws std::logic_error where there is none. */
    unsigned int find_reading(const std::string &name) const;
    /** The residual that is @p distance sectors away; nullptr beyond the reach. */
    const Eigen::MatrixXd *find_residual(int distance) const;
    unsigned int           n_modes() const; ///< complex ones count once
  };

  /** Passes the modes of a harmonic. */
  void serialize(ReducedBody::Harmonic &harmonic, ByteStream &stream);
  /** Passes the body. Throws InputError where what is read cannot be one. */
  void serialize(ReducedBody &body, ByteStream &stream);
} // namespace vfife

#endif
