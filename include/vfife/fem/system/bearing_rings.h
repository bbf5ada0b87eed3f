// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_bearing_rings_h
#define vfife_fem_system_bearing_rings_h

#include <vfife/bearing/shaft_seat.h>
#include <vfife/fem/system/fem_space.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace vfife
{
  /** Motions B u of some points of a space, and forces B^T f on them. Of one sector with
   * two copies of its points (FemConstraints) points count through both. */
  struct PointMotion
  {
    std::vector<unsigned int> points;
    Eigen::MatrixXd           motion; ///< B, 3 columns a point

    /** B u of a field of all points. */
    Eigen::VectorXd displacement(const std::vector<double> &u) const;
    /** Adds B^T @p load to forces at all points. */
    void add_forces(const Eigen::VectorXd &load, std::vector<double> &forces) const;
  };

  /**
   * The seat of a bearing or coupling for small displacements: B u are the displacement and the
   * turn of the ring's centre along the fixed frame's axes (6 rows), -B^T f what it exerts on the
   * points of an undisplaced ring.
   */
  struct BearingRing : public PointMotion
  {
    std::size_t  support = 0;               ///< place in list_supports()
    unsigned int body    = 0;               ///< of the model
    Vector3      centre  = Vector3::Zero(); ///< undeformed, fixed frame [mm]
  };

  /** What a housing is in the linear laws of bearings. */
  enum class HousingLaw
  {
    joins_seats, ///< each seat feels all others; those of bodies that are not there are held
    own_seats    ///< what each seat has by itself, the others held
  };

  /**
   * Rings of all bearings and couplings of the bodies of a space, with their linear(ized)
   * laws: loads preload - K B u, six rows a ring.
   *
   * On one sector of a body a ring has a part in the harmonics 0 (along the axis, about it) and 1
   * (across it): B is then scaled so that B^T K B is that of the sector, (B u) . K B u the energy
   * of the whole ring over what an energy of the sector stands for (doc/theory/bearing.md, One
   * sector).
   */
  class BearingRings
  {
  public:
    using Rate = std::function<double(unsigned int body)>; ///< of a body about its axis [rad/s]

    /**
     * @p harmonic: of a sector. Throws InputError where a ring is not alike in all sectors.
     */
    BearingRings(const FemSpace &space,
                 HousingLaw      housing  = HousingLaw::joins_seats,
                 unsigned int    harmonic = 0);

    const std::vector<BearingRing> &list() const
    {
      return rings_;
    }

    /** In the mean over all turns of bodies that turn. Throws InputError on one sector for bearings
     * that are not alike in all directions across the axis. */
    Eigen::MatrixXd stiffness(const Rate &rate) const;
    /** Of undisplaced shafts [N, N mm]. */
    const Eigen::VectorXd &preload() const
    {
      return preload_;
    }

    /** B u. */
    Eigen::VectorXd displacement(const std::vector<double> &u) const;
    /** Adds B^T @p load to forces at all points. */
    void add_forces(const Eigen::VectorXd &load, std::vector<double> &forces) const;

    /** Whether the housing may join two rings, which then meet in matrices. */
    bool joins(const std::size_t i, const std::size_t j) const
    {
      return i == j || std::max(i, j) < n_joined_;
    }

    /** @p K over the motions of all rings as bodies that turn feel it, each about its axis and all
     * rings of a body as one: the mean over all turns. */
    Eigen::MatrixXd mean_over_turns(const Eigen::MatrixXd &K, const Rate &rate) const;

  private:
    BearingRing make_ring(unsigned int                     body,
                          const std::vector<unsigned int> &nodes,
                          const SelectedFaces             &faces,
                          const std::string               &owner) const;
    void        take_sector(const Body                      &body,
                            const std::vector<unsigned int> &nodes,
                            const SelectedFaces             &faces,
                            const std::string               &owner,
                            BearingRing                     &ring) const;
    void        add_bearings(HousingLaw housing);
    void        add_couplings();
    void        require_isotropic(const Eigen::MatrixXd &K) const;

    const FemSpace          &space_;
    unsigned int             harmonic_;
    std::vector<BearingRing> rings_;
    std::size_t              n_joined_ = 0; ///< of the first rings, by the housing
    Eigen::MatrixXd          stiffness_;    ///< in axes that stand still [N/mm, N, N mm]
    Eigen::VectorXd          preload_;
  };
} // namespace vfife

#endif
