// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_pair_pair_rows_h
#define vfife_reduced_pair_pair_rows_h

#include <vfife/fem/pair/pressed_pair.h>
#include <vfife/reduced/pair/pair_bearings.h>
#include <vfife/reduced/pair/pair_drive.h>

#include <utility>
#include <vector>

namespace vfife
{
  /**
   * The rows of both bodies of a ReducedPair: three of each node that may touch until the next
   * search for such nodes, and behind them six of each bearing.
   */
  class PairRows
  {
  public:
    using NodeOfBody = std::pair<unsigned int, unsigned int>; ///< body, node

    /** All must outlive the object. */
    PairRows(const Model &model, PairMembers &members, PressedPair &pair, const PairDrive &drive);

    /** Doublings of the distance that searches look at; each one that is due takes one back. */
    unsigned int widening = 0;

    /** Looks for what may touch in the steps until the next search. Forces of @p now and @p earlier
     * ones (or empty) go with their nodes. */
    void search(PressedState &now, Eigen::VectorXd &earlier);
    /** The same at the first of the steps behind these. */
    void search_when_due(PressedState &now, Eigen::VectorXd &earlier);

    /** Of the rows, sorted. */
    const std::vector<NodeOfBody> &nodes() const
    {
      return nodes_;
    }
    /** Those of @p nodes on body @p b, in their order. */
    static std::vector<unsigned int> nodes_of(const std::vector<NodeOfBody> &nodes, unsigned int b);

    Eigen::Index size() const
    {
      return owners_.size();
    }
    /** Body of a row and its place among that body's rows. */
    const std::pair<unsigned int, Eigen::Index> &owner(const unsigned int row) const
    {
      return owners_[row];
    }

    /** Displacements of the rows in the state of spin, under the torques, and with the modes' @p
     * coordinates by body [mm]. */
    Eigen::VectorXd displace(const std::vector<std::vector<Eigen::VectorXcd>> &coordinates) const;
    /** Where any nodes are displaced to now under @p force at the rows (3 each, axes of time zero)
     * [mm]. */
    Eigen::VectorXd displace_nodes(const std::vector<NodeOfBody> &nodes,
                                   const Eigen::VectorXd         &force) const;
    /** Throws NumericalError where bearings let the flanks move farther than contact is looked for;
     * @p u: of displace_nodes(). */
    void check_reach(const std::vector<NodeOfBody> &nodes, const Eigen::VectorXd &u) const;

    /** Passes nodes and search; reading, @p now and @p earlier become those without forces. */
    void serialize(PressedState &now, Eigen::VectorXd &earlier, ByteStream &stream);

  private:
    void set_nodes(std::vector<NodeOfBody> nodes, PressedState &now, Eigen::VectorXd &earlier);
    /** Of a body, behind those that there are. */
    void add_rows(unsigned int b, Eigen::Index n);
    /** Of a node's rows, in the axes of time zero. */
    Matrix3 axes_of(unsigned int body, unsigned int node) const;

    const Model                                       &model_;
    PairMembers                                       &members_;
    PressedPair                                       &pair_;
    const PairDrive                                   &drive_;
    std::vector<NodeOfBody>                            nodes_;
    std::vector<std::pair<unsigned int, Eigen::Index>> owners_;
    unsigned int                                       search_steps_ = 1, since_search_ = 0;
    double          searched_from_ = 0, searched_to_ = 0; ///< turns of the driver [rad]
    Eigen::VectorXd held_; ///< displacements of candidates then, or empty [mm]
  };

  /** What both bodies of a ReducedPair answer to forces at its rows, and what bearings do there. */
  class PairAnswers : public PressedBodies
  {
  public:
    /** @p touch_rows: of the bodies. All must outlive the object. */
    PairAnswers(const PairMembers             &members,
                const PairRows                &rows,
                const PairBearings            &bearings,
                std::vector<const TouchRows *> touch_rows)
      : members_(members)
      , rows_(rows)
      , bearings_(bearings)
      , touch_rows_(std::move(touch_rows))
    {
    }

    Eigen::VectorXd answer(const Eigen::VectorXd &force) override;
    Eigen::MatrixXd flexibility(const std::vector<unsigned int> &rows) override;
    void            add_forces(const Eigen::VectorXd &u, PressedForces &sum) const override;
    PressedSprings  find_springs(const Eigen::VectorXd &u, bool turning, bool own) const override;

  private:
    const PairMembers             &members_;
    const PairRows                &rows_;
    const PairBearings            &bearings_;
    std::vector<const TouchRows *> touch_rows_;
  };
} // namespace vfife

#endif
