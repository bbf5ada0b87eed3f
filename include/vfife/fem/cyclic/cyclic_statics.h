// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_cyclic_cyclic_statics_h
#define vfife_fem_cyclic_cyclic_statics_h

#include <vfife/fem/cyclic/border_harmonics.h>
#include <vfife/fem/cyclic/cyclic_body.h>
#include <vfife/fem/modes/sector_copies.h>
#include <vfife/fem/solvers/condensation.h>
#include <vfife/fem/solvers/sparse_matrix.h>

#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace vfife
{
  /** Springs that hold a body beside its constraints: bearings, couplings, pins. */
  struct BodySupports
  {
    std::vector<PointMotion> motions;   ///< of points that are numbered from the body's first one
    Eigen::MatrixXd          stiffness; ///< over the rows of all motions; positive semidefinite
  };

  /**
   * What a body of equal sectors does under any forces about its state of spin, in axes that turn
   * with it: one sector is condensed onto its borders, and the borders of all are solved for
   * harmonic by harmonic (doc/theory/fem.md, Static by sectors). The answers are those of the whole
   * body's stiffness matrix, a hub that turns freely being pinned as HubRotation::pinned says.
   * Supports need not be equal in all directions: braces hold the rigid motions of the borders in
   * the factors, and a correction of low rank replaces them by the supports.
   * Ranks share the harmonics; all functions but column() are collective, and results are equal on
   * all ranks.
   */
  class CyclicStatics
  {
  public:
    /** Throws as CyclicBody, and InputError for bodies with more than one hub that turns or with
     * one that something else holds, and for two sectors on supports; NumericalError where the body
     * is not stable at @p rate. */
    CyclicStatics(const FemSpace       &whole,
                  const FemSpace::Part &part,
                  const FemOptions     &options,
                  double                rate,
                  const BodySupports   &supports,
                  const Communicator   &communicator);

    /** Displacements of all points of the body in the state of spin (3 a point, fixed frame)
     * [mm]. */
    std::vector<double> spun() const;

    /** Displacements of all points under forces at all of them (3 a point, fixed frame) [mm]. */
    std::vector<double> solve(const std::vector<double> &forces) const;

    /** Forces at all points, without those of supports, under displacements of all of them [N]. */
    std::vector<double> apply_stiffness(const std::vector<double> &u) const;
    /** The mass matrix times a field of all points. */
    std::vector<double> apply_mass(const std::vector<double> &u) const;

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
    void factorize();
    /** Against rigid motions of the borders that constraints leave: the turn about the axis, and
     * all others too where the body has supports. */
    std::vector<BorderBrace> make_braces(const Eigen::MatrixXd &S) const;
    /** Displacements of all points in a shift of the body along an axis across it, or itself
     * (@p axis = 2), or in a small turn about that. */
    std::vector<double> rigid_motion(unsigned int axis, bool turns) const;
    Eigen::VectorXd     displacements_of_supports(const std::vector<double> &u) const;
    /** Takes the braces away and adds the supports and the pin of the hub. */
    void correct(const std::vector<BorderBrace> &braces);
    /** Columns of U of the supports, on the unknowns of all sectors, and their part of C^-1. */
    void add_supports(std::vector<Eigen::MatrixXd> &columns, std::vector<double> &inverse) const;
    /** Forces at all points of loads along the motions of the supports. */
    std::vector<double> spread(const Eigen::VectorXd &loads) const;
    [[noreturn]] void   refuse() const;

    Matrix3 turned(unsigned int sector) const;
    /** Puts the displacements of the sector's points @p u into those of sector @p k. */
    void add_sector(unsigned int k, const std::vector<double> &u, std::vector<double> &all) const;
    /** Of a field of all points the displacements of the sector's points and of its images, in its
     * axes. */
    std::vector<double> of_sector(unsigned int k, const std::vector<double> &u) const;
    /** Forces at all points of those on the unknowns of each sector. */
    std::vector<double>
    sum_sectors(const std::function<OwnedVector(unsigned int sector)> &forces) const;
    /** Loads on the unknowns of all sectors, a column each. */
    Eigen::MatrixXd     restrict_forces(const std::vector<double> &forces) const;
    std::vector<double> expand(const Eigen::MatrixXd &x) const;
    Eigen::MatrixXd     solve_sectors(Eigen::MatrixXd x) const;

    CyclicBody                       body_;
    SectorCopies                     copies_;
    BodySupports                     supports_;
    const Communicator              &communicator_;
    HubRotation                      hub_ = HubRotation::pinned; ///< of the sector's unknowns
    std::unique_ptr<FemSystem>       sector_; ///< open: its images are points of their own
    std::unique_ptr<SystemMatrices>  matrices_;
    std::unique_ptr<SparseMatrix>    stiffness_; ///< on supports
    std::vector<unsigned int>        border_;    ///< its unknowns on border 0, then on border 1
    std::unique_ptr<Condensation>    condensed_;
    std::unique_ptr<BorderHarmonics> borders_;

    // Of a hub whose points turn by themselves:
    bool         pinned_ = false;
    unsigned int pin_    = 0; ///< point

    // What is factorized is A^-1 = K - U C U^T, with braces instead of supports and pin: K u = f
    // has u = A f - A U (C^-1 + U^T A U)^-1 U^T A f.
    Eigen::MatrixXd correction_fields_; ///< A U at all points
    Eigen::MatrixXd correction_;        ///< (C^-1 + U^T A U)^-1

    /** Of a watched point in sector 0, and the point's kind. */
    using Copy = std::pair<unsigned int, unsigned int>;
    Copy copy_of(const Watched &watched) const;

    std::vector<Watched>                    watched_;
    Eigen::MatrixXd                         watched_fields_; ///< correction_fields_ there
    std::vector<Copy>                       locals_;         ///< those of them in sector 0
    std::map<unsigned int, Eigen::MatrixXd> flexibility_; ///< by the sectors from force to answer
  };
} // namespace vfife

#endif
