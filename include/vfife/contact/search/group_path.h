// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_search_group_path_h
#define vfife_contact_search_group_path_h

#include <vfife/contact/surface/surface_geometry.h>

#include <vector>

namespace vfife
{
  class ByteStream;

  /**
   * How far the groups of a surface have moved in a frame (the master body's): for every active
   * group the sum over the updates of the largest displacement of its nodes. A facet's points move
   * no farther than its corners, so the sum for a slave and a master group bounds the change of any
   * distance between them.
   */
  class GroupPath
  {
  public:
    explicit GroupPath(unsigned int n_groups);

    /** Groups that were not active before start anew from their position at the next update. */
    void set_active(const std::vector<unsigned int> &groups);

    /** Throws NumericalError when a position is not finite. */
    void update(const SurfaceGeometry &surface, const RigidMotion &frame);

    /** For checkpoints. */
    void serialize(ByteStream &stream);

    /** Length so far [mm]. */
    double length(const unsigned int group) const
    {
      return lengths_[group];
    }

  private:
    std::vector<unsigned int>        active_;
    std::vector<double>              lengths_;
    std::vector<std::vector<double>> previous_; ///< 3 a node; empty: position unknown yet
  };
} // namespace vfife

#endif
