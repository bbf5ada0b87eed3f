// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_statics_compliance_h
#define vfife_fem_statics_compliance_h

#include <vfife/fem/cyclic/cyclic_statics.h>
#include <vfife/fem/fem_options.h>
#include <vfife/fem/solvers/direct_solver.h>
#include <vfife/fem/statics/facet_parts.h>
#include <vfife/fem/statics/node_averages.h>
#include <vfife/fem/statics/standing_motion.h>
#include <vfife/fem/system/system_matrices.h>

#include <memory>
#include <vector>

namespace vfife
{
  /** What a Compliance factorizes; the answers are the same. */
  enum class Factorized
  {
    sectors, ///< one sector of each body where all are made of equal ones that are held alike
    bodies   ///< the bodies as they are
  };

  /**
   * What all bodies of a model do under forces, in axes that turn with them; factorized once, by
   * one sector of each body where they have equal ones (CyclicStatics). Hubs that turn freely are
   * pinned about the axis, and so is the driven body of a pair that turns in bearings: the pin
   * carries nothing where loads have no moment about the axis, and the rotation of such a body is
   * an unknown of whoever asks (PairEquilibrium). Bearings are springs, linear and in the mean over
   * turns where bodies turn (BearingRings::stiffness()).
   *
   * In spin, and with initial strains, the matrix is the tangent K(u0) - Omega^2 S (+ curvature of
   * the hub) at the state u0 of spin and strains (doc/theory/fem.md). All functions are collective;
   * results are equal on all ranks.
   */
  class Compliance
  {
  public:
    /** Throws InputError where a body can move otherwise than by turning on its hub or, the driven
     * one of a pair, in its bearings, and where bodies with a temperature rotate in bearings
     * without @p centrifugal forces; NumericalError where the speed is too high. */
    Compliance(const Model        &model,
               const FemOptions   &options,
               bool                centrifugal,
               const Communicator &communicator,
               Factorized          factorized = Factorized::sectors);

    const FemSpace &space() const
    {
      return space_;
    }
    /** Whether one sector of each body is factorized. */
    bool by_sectors() const
    {
      return !sectors_.empty();
    }

    /** Displacements of all points (3 a point) under centrifugal forces and initial strains alone
     * [mm]; zero without. */
    const std::vector<double> &spun() const
    {
      return spun_;
    }
    /** Displacements of all points under the model's torques in full [mm]. */
    const std::vector<double> &twisted() const
    {
      return twisted_;
    }

    /** Displacements of all points [mm] under forces given at all points [N]. */
    std::vector<double> solve(const std::vector<double> &forces) const;

    /** Whether nothing holds the body's turn about its axis but the pin. */
    bool turns_freely(unsigned int body) const;

    /** Of bearings and couplings. */
    const BearingRings &rings() const
    {
      return rings_;
    }

    /** What this stiffness lacks for bodies in bearings that spin, and whoever asks adds. */
    const std::vector<StandingMotion> &standing_motions() const
    {
      return standing_;
    }

    /** Points and motions of points at which displacements under unit forces are kept. Rows: three
     * per point in this order, three per surface_points(), those of the motions. Nodes of surfaces
     * in contact move and take forces as NodeAverages says. Forgets what is known, but for the
     * points that are watched already where there are no motions. */
    void watch(std::vector<unsigned int> points, std::vector<PointMotion> motions = {});

    const std::vector<unsigned int> &watched() const
    {
      return watched_;
    }
    /** Corners of FacetParts on the facets whose nodes are watched. They move and take forces as
     * those say; none where elements have no points between the nodes. */
    const std::vector<unsigned int> &surface_points() const
    {
      return surface_points_;
    }
    /** The first row of the motions. */
    std::size_t first_motion_row() const
    {
      return 3 * weights_.size();
    }
    /** By which a watched point moves and takes forces. */
    const PointWeights &weights(const unsigned int watched) const
    {
      return weights_[watched];
    }

    /** Of a field of all points (3 a point) the displacements at the rows. */
    Eigen::VectorXd at_rows(const std::vector<double> &u) const;

    /** Forces at all points of forces at the rows. */
    std::vector<double> spread(const Eigen::VectorXd &force) const;

    /** Solves for unit forces at the @p rows that are not yet known. */
    void prepare(const std::vector<unsigned int> &rows);

    /** Displacements at the @p rows under unit forces there, a column each; prepares them. */
    Eigen::MatrixXd flexibility(const std::vector<unsigned int> &rows);

    /** Displacements at all rows under a unit force at @p row, which is prepared. */
    Eigen::Ref<const Eigen::VectorXd> column(unsigned int row) const
    {
      return columns_[row];
    }

    unsigned int n_unknowns() const
    {
      return n_unknowns_;
    }
    /** Unit forces solved for so far. */
    unsigned int n_prepared() const
    {
      return n_prepared_;
    }
    /** Of the factors on all ranks [MB]. Collective. */
    double memory() const;

  private:
    /** A body by one of its sectors. */
    struct SectorBody
    {
      std::unique_ptr<CyclicStatics> statics;
      std::size_t                    first;   ///< of its displacements among those of all points
      std::size_t                    n;       ///< displacements
      std::vector<unsigned int>      watched; ///< places of its points among the watched ones
    };

    void         check_motions();
    bool         factorize_sectors(const FemOptions &options, bool centrifugal);
    BodySupports make_supports(const FemSpace::Part &part) const;
    void         factorize_bodies(const FemOptions &options, bool centrifugal);
    void         factorize(FemMatrix K, unsigned int n_whirls);
    /** Of @p matrices and their @p stiffness about a state of spin. */
    void find_standing_motions(const SystemMatrices       &matrices,
                               const FemMatrix            &stiffness,
                               const SystemMatrices::Rate &rate);
    void prepare_sectors(const std::vector<unsigned int> &rows);
    void add_column(unsigned int row);
    void add_columns(const std::vector<unsigned int> &rows);

    const Model                  &model_;
    const Communicator           &communicator_;
    FemSpace                      space_;
    BearingRings                  rings_; ///< seats by themselves
    std::unique_ptr<FemSystem>    system_;
    std::unique_ptr<DirectSolver> solver_;
    std::vector<SectorBody>       sectors_; ///< of all bodies, and no matrix of theirs; or none
    unsigned int                  n_unknowns_ = 0;
    std::vector<double>           spun_, twisted_;
    std::vector<StandingMotion>   standing_;
    std::vector<unsigned int>     turning_; ///< bodies free to turn
    std::vector<unsigned int>     pinned_;  ///< of these, whose hub is no constraint
    NodeAverages                  averages_;
    FacetParts                    facet_parts_;
    std::vector<unsigned int>     watched_, surface_points_;
    std::vector<PointWeights>     weights_; ///< of the watched and the surface points
    std::vector<PointMotion>      motions_; ///< watched as well
    std::vector<Eigen::VectorXd>  columns_; ///< empty: not known
    unsigned int                  n_prepared_ = 0;
  };
} // namespace vfife

#endif
