// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_cyclic_cyclic_statics_h
#define vfife_fem_cyclic_cyclic_statics_h

#include <vfife/fem/cyclic/border_harmonics.h>
#include <vfife/fem/cyclic/cyclic_body.h>
#include <vfife/fem/modes/sector_copies.h>
#include <vfife/fem/solvers/condensation.h>

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace vfife
{
  /**
   * What a body of equal sectors does under any forces about its state of spin, in axes that turn
   * with it: one sector is condensed onto its borders, and the borders of all are solved for
   * harmonic by harmonic (doc/theory/fem.md, Static by sectors). The answers are those of the whole
   * body's stiffness matrix, a hub that turns freely being pinned as HubRotation::pinned says.
   * Ranks share the harmonics; all functions but column() are collective, and results are equal on
   * all ranks.
   */
  class CyclicStatics
  {
  public:
    /** Throws as CyclicBody, and InputError for bodies with more than one hub that turns or with
     * one that something else holds; NumericalError where the body is not stable at @p rate. */
    CyclicStatics(const FemSpace       &whole,
                  const FemSpace::Part &part,
                  const FemOptions     &options,
                  double                rate,
                  const Communicator   &communicator);

    /** Displacements of all points of the body in the state of spin (3 a point, fixed frame)
     * [mm]. */
    std::vector<double> spun() const;

    /** Displacements of all points under forces at all of them (3 a point, fixed frame) [mm]. */
    std::vector<double> solve(const std::vector<double> &forces) const;

    /** A point of the body, numbered from its first one, and the points and weights by which it
     * moves and takes forces. Points that are copies of each other have weights that are, among
     * those of the same kind. */
    struct Watched
    {
      unsigned int point;
      PointWeights weights;
      unsigned int kind;
    };
    /** The points between which column() computes displacements. Throws InputError where one has
     * weights in another sector than its own. */
    void watch(std::vector<Watched> points);

    /** Displacements of the watched points (3 each) under a unit force along the axis @p component
     * of the fixed frame at the point number @p watched of them [mm/N]. */
    Eigen::VectorXd column(std::size_t watched, unsigned int component) const;

    /** Of the whole body. */
    unsigned int n_unknowns() const;

    /** Of the factors, on this rank [MB]. */
    double memory() const;

  private:
    void find_hub(const Model &model, unsigned int body);
    /** Puts the displacements of the sector's points @p u into those of sector @p k. */
    void add_sector(unsigned int k, const std::vector<double> &u, std::vector<double> &all) const;
    void factorize();
    Matrix3 turned(unsigned int sector) const;
    /** Part of border 0 in the turn of the body. */
    Eigen::VectorXd turn_of_border() const;
    void            find_pin();
    /** The two columns of pin_fields_ by which a point moves, a row per direction. */
    Eigen::MatrixXd pin_field_of(const Watched &watched) const;
    /** Loads on the unknowns of all sectors, a column each. */
    Eigen::MatrixXd     restrict_forces(const std::vector<double> &forces) const;
    std::vector<double> expand(const Eigen::MatrixXd &x) const;
    Eigen::MatrixXd     solve_sectors(Eigen::MatrixXd x) const;

    CyclicBody                       body_;
    SectorCopies                     copies_;
    const Communicator              &communicator_;
    HubRotation                      hub_ = HubRotation::pinned; ///< of the sector's unknowns
    std::unique_ptr<FemSystem>       sector_; ///< open: its images are points of their own
    std::vector<unsigned int>        border_; ///< its unknowns on border 0, then on border 1
    std::unique_ptr<Condensation>    condensed_;
    std::unique_ptr<BorderHarmonics> borders_;

    // Of a hub whose points turn by themselves:
    bool            pinned_ = false;
    unsigned int    pin_    = 0; ///< point
    TurnOfBorders   turn_;
    Eigen::MatrixXd pin_fields_;                               ///< of all points, two columns
    Eigen::Matrix2d pin_compliance_ = Eigen::Matrix2d::Zero(); ///< that the pin takes away

    /** Of a watched point in sector 0, and the point's kind. */
    using Copy = std::pair<unsigned int, unsigned int>;
    Copy copy_of(const Watched &watched) const;

    std::vector<Watched>                    watched_;
    std::vector<Copy>                       locals_;      ///< those of them in sector 0
    std::map<unsigned int, Eigen::MatrixXd> flexibility_; ///< by the sectors from force to answer
  };
} // namespace vfife

#endif
