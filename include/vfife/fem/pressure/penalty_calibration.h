// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pressure_penalty_calibration_h
#define vfife_fem_pressure_penalty_calibration_h

#include <vfife/fem/pressure/grid_contact.h>

#include <vector>

namespace vfife
{
  struct ContactPair;

  /** Penalties of the points of a contact. */
  struct PointPenalties
  {
    double              largest = 0, least = 0, mean = 0; ///< mean: by forces [N/mm^3]
    std::vector<double> stiffness;                        ///< over the largest, ContactPair's
    double              left = 0; ///< part of the loads of all tooth pairs that is not met [-]
  };

  /**
   * Penalties of contact points with which tooth pairs approach each other as on the contact's own
   * grid (doc/theory/contact.md, Penalty). The elements near the flanks are too stiff, since they
   * do not resolve the contact; the springs of the penalty supply the missing compliance. It
   * depends on where the contact lies between the nodes of both flanks, so each point has its own
   * value.
   */
  class PenaltyCalibration
  {
  public:
    /** @p pair: of one pass, with the penalty with which the states of add() are found. */
    explicit PenaltyCalibration(const ContactPair &pair);

    /** @p contacts under a @p load, and what the grids of these have found. */
    void add(const std::vector<ElasticContact> &contacts,
             const ContactLoad                 &load,
             const std::vector<GridPressure>   &grids);

    /** Penalties with which the driven body lags by @p lag [rad] more than on the grids: what the
     * elements of the bodies lack of compliance. To be called once. Throws NumericalError where
     * no contact was added. */
    PointPenalties find(double lag = 0.);

  private:
    /** Two teeth in contact. */
    struct Touch
    {
      std::vector<unsigned int> points;      ///< among those of a group
      Eigen::VectorXd           areas;       ///< [mm^2]
      Eigen::VectorXd           arms;        ///< ContactLoad::arm
      Eigen::VectorXd           gaps;        ///< without the forces of these points [mm]
      Eigen::MatrixXd           flexibility; ///< of the elements between the points [mm/N]
      double                    moment = 0;  ///< on the grid
      double                    width  = 0;  ///< of the contact [mm]
      std::vector<Eigen::Index> active;      ///< that pressed last, from which press() starts

      /** Forces of springs with @p penalties. */
      Eigen::VectorXd press(const Eigen::VectorXd &penalties);
      /** The factor of @p penalties with which the springs have the moment of the grid. */
      double find_factor(const Eigen::VectorXd &penalties);
    };

    /** At each point of a group: logarithms of the touches' penalties @p levels, weighted by the
     * forces near it. */
    std::vector<double> spread(const std::vector<double>          &levels,
                               const std::vector<Eigen::VectorXd> &forces) const;

    const ContactPair                &pair_;
    double                            penalty_;
    std::vector<FacetQuadraturePoint> rule_;
    std::vector<Vector3>              places_; ///< of the points of group 0, undeformed [mm]
    std::vector<Touch>                touches_;
  };
} // namespace vfife

#endif
