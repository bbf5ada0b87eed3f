// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_pass_point_lists_h
#define vfife_contact_pass_point_lists_h

#include <vfife/contact/pass/pass_surfaces.h>
#include <vfife/contact/pass/point_list.h>
#include <vfife/contact/pass/stick_slip.h>
#include <vfife/contact/search/group_path.h>

#include <utility>
#include <vector>

namespace vfife
{
  class ByteStream;

  /**
   * Which points of the slave touch the master, found again from one evaluation to the next.
   *
   * Every pair of groups keeps a list of the points that may touch before the groups have moved by
   * the skin, each with its last projection. A point with gap g sleeps until the path of its groups
   * has grown by 0.8 g, a point beyond the border until half the way to the border: so most of a
   * list costs one comparison a step.
   */
  class PointLists
  {
  public:
    PointLists(PassSurfaces &surfaces, const ContactOptions &options);

    /** Pairs of groups to look at (sorted); lists of pairs that remain are kept. */
    void set_pairs(const std::vector<std::pair<unsigned int, unsigned int>> &pairs);

    /** See Contact::set_shares, Contact::take_work (adds it). */
    void set_shares(const std::vector<PointShare> &shares);
    void take_work(std::vector<double> &of_pairs);

    /** Measures how far the groups of this rank's points have moved since the last call. Throws
     * NumericalError when a position is not finite. */
    void update_paths();

    /** Finds again the points of pairs whose groups have moved by the skin since their list was
     * made; the @p friction puts anchors of the old points under the new ones. */
    void renew(const StickSlip &friction);

    /** Projects the points that are awake and finds those with a gap below zero, and those that
     * close or have been closed within @p look_ahead [s]; the others are open to the @p friction.
     */
    void find_touching(double look_ahead, StickSlip &friction);

    /** All points are looked at in the next evaluation. */
    void wake();

    /** All points of the pair of @p list within +- @p reach [mm], found without warm start. */
    PointList points_within(const PointList &list, double reach, const PointShare &share);

    std::vector<PointList> &all()
    {
      return lists_;
    }
    const std::vector<PointList> &all() const
    {
      return lists_;
    }

    /** Path of the groups between wide searches, depth beyond which a point is no contact [mm]. */
    double skin() const
    {
      return skin_;
    }
    double depth_limit() const
    {
      return depth_limit_;
    }

    /** Points listed for the current pairs, wide searches made so far (for timing and tests). */
    std::size_t n_points() const;
    std::size_t n_wide_searches() const
    {
      return n_wide_searches_;
    }

    /** For checkpoints: lists with their last projections, and paths. Throws InputError when they
     * are of other surfaces. */
    void serialize(ByteStream &stream);

  private:
    /** Groups whose motion is measured: those of pairs that this rank has points of. */
    void   follow_groups();
    double path_of(const PointList &list) const;
    void   find_points(PointList &list, double open_reach, double depth_reach);
    void   find_touching(PointList &list, double look_ahead, StickSlip &friction);
    /** Whether point @p i has a foot on the master; one without sleeps from @p path [mm] on. */
    bool locate(PointList &list, unsigned int i, double path);
    /** Gap below which a point touches within @p look_ahead [mm]. */
    double find_reach(const ListedPoint &point, double look_ahead) const;
    void   check(const ByteStream &stream) const;

    PassSurfaces          &surfaces_;
    double                 skin_, depth_limit_;
    GroupPath              slave_path_, master_path_;
    std::vector<PointList> lists_;
    std::size_t            n_wide_searches_ = 0;
  };
} // namespace vfife

#endif
