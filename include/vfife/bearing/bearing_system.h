// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_bearing_bearing_system_h
#define vfife_bearing_bearing_system_h

#include <vfife/bearing/bearing_law.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace vfife
{
  /**
   * All bearings of a model: each by its law against the ground, or all in one housing that gives
   * way (doc/theory/bearing.md, Housing). The housing has no mass: it is where the energy of
   * bearings and housing together is least, so that loads are the slopes of that energy.
   */
  class BearingSystem
  {
  public:
    struct Seat
    {
      Matrix3                           axes = Matrix3::Identity(); ///< of the bearing, at rest
      std::shared_ptr<const BearingLaw> law;
    };

    explicit BearingSystem(std::vector<Seat> seats = {});

    /**
     * @p stiffness: 6 n x 6 n over the displacements [mm] and turns [rad] of the n seats along x,
     * y, z of the fixed frame, in N, N mm. Throws InputError where size, symmetry or a mode without
     * stiffness say that it is none.
     */
    void set_housing(const Eigen::MatrixXd &stiffness);

    /** What the shafts feel; in the order of the seats, along each bearing's axes. */
    struct Response
    {
      std::vector<Vector5> loads;
      Eigen::MatrixXd      stiffness; ///< -d loads/d displacements, 5 n x 5 n, symmetric
      double               energy = 0;
      std::vector<double>  turn_slopes; ///< d energy/d turn of each shaft's seat [N mm]
      Eigen::VectorXd      housing;     ///< 6 n, empty without one
    };

    /** @p displacements: of the shafts' seats, as laws have them; @p turns of the seats about their
     * z since time zero [rad]. Throws NumericalError where no equilibrium of the housing is found.
     */
    Response evaluate(const std::vector<Vector5> &displacements,
                      const std::vector<double>  &turns) const;

    /** Before anything has turned. */
    Response evaluate(const std::vector<Vector5> &displacements) const
    {
      return evaluate(displacements, std::vector<double>(size(), 0.));
    }

    /** What undisplaced shafts feel and how it falls with small displacements and turns of all
     * seats, six a seat along the fixed frame's axes. */
    struct Linear
    {
      Eigen::VectorXd load;      ///< forces and moments on the shafts [N, N mm]
      Eigen::MatrixXd stiffness; ///< -d load/d displacement, symmetric [N/mm, N, N mm]
    };

    /** Linear(ized) laws, in the housing: it couples all seats. */
    Linear linearized() const;

    bool has_housing() const
    {
      return housing_.size() > 0;
    }

    std::size_t size() const
    {
      return seats_.size();
    }

  private:
    std::vector<Vector5> beside_housing(const std::vector<Vector5> &displacements,
                                        const Eigen::VectorXd      &housing) const;
    Response             sum_laws(const std::vector<Vector5> &displacements,
                                  const std::vector<double>  &turns) const;

    std::vector<Seat> seats_;
    Eigen::MatrixXd   housing_;
    Eigen::MatrixXd   reading_; ///< of the displacements along the bearings' axes, 5 n x 6 n
  };
} // namespace vfife

#endif
