// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/contact/search/group_path.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace vfife
{
  GroupPath::GroupPath(const unsigned int n_groups)
    : lengths_(n_groups, 0.)
    , previous_(n_groups)
  {
  }

  void GroupPath::set_active(const std::vector<unsigned int> &groups)
  {
    // Positions of groups that are no longer followed are out of date when they come back.
    std::vector<bool> keep(previous_.size(), false);
    for (const unsigned int g : groups)
      keep[g] = true;
    for (unsigned int g = 0; g < previous_.size(); ++g)
      if (!keep[g])
        previous_[g].clear();
    active_ = groups;
  }

  void GroupPath::update(const SurfaceGeometry &surface, const RigidMotion &frame)
  {
    // Positions in the frame, R^T (x - t), against those at the last update.
    const Matrix3 back = frame.rotation.transpose();
    const Vector3 to   = -(back * frame.translation);
    for (const unsigned int g : active_)
      {
        const auto &nodes    = surface.group_nodes(g);
        auto       &previous = previous_[g];
        const bool  known    = !previous.empty(); // else the path goes on from here
        previous.resize(3 * nodes.size());
        double *before  = previous.data();
        double  largest = 0., sum = 0.;
        for (const unsigned int node : nodes)
          {
            const double *x      = surface.motion().positions + 3 * static_cast<std::size_t>(node);
            double        square = 0.;
            for (unsigned int i = 0; i < 3; ++i)
              {
                const double now =
                  back(i, 0) * x[0] + back(i, 1) * x[1] + back(i, 2) * x[2] + to[i];
                square += (now - before[i]) * (now - before[i]);
                before[i] = now;
              }
            before += 3;
            largest = std::max(largest, square);
            sum += square; // unlike a maximum, a sum keeps a NaN
          }
        if (!std::isfinite(sum))
          throw NumericalError("contact: a position in group (tooth) " + std::to_string(g) +
                               " of a contact surface is not finite");
        if (known)
          lengths_[g] += std::sqrt(largest);
      }
  }

  void GroupPath::serialize(ByteStream &stream)
  {
    stream.pass(active_);
    stream.pass_known(lengths_);
    stream.pass_known(previous_);
    if (!stream.reads())
      return;
    for (const unsigned int group : active_)
      stream.require(group < lengths_.size(), "a group that the surface has not");
    for (const double length : lengths_)
      stream.require(std::isfinite(length), "a path without end");
  }
} // namespace vfife
