// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What of a contact goes on from one evaluation to the next, and into checkpoints.
#include <vfife/base/text/byte_stream.h>
#include <vfife/contact/contact.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  void Contact::set_shares(const std::vector<PointShare> &shares)
  {
    // The second pass has the same pairs in the same order.
    for (ContactPass &pass : passes_)
      pass.set_shares(shares);
    results_ = passes_[0].results();
  }


  std::vector<double> Contact::take_work()
  {
    std::vector<double> of_pairs(candidate_pairs_.size(), 0.);
    for (ContactPass &pass : passes_)
      pass.take_work(of_pairs);
    return of_pairs;
  }


  void Contact::serialize(ByteStream &stream)
  {
    stream.pass(candidate_pairs_);
    for (const auto &pair : candidate_pairs_)
      stream.require(pair.first < passes_[0].slave().n_groups() &&
                       pair.second < passes_[0].master().n_groups(),
                     "groups that the surfaces have not");
    for (ContactPass &pass : passes_)
      pass.serialize(stream);
    if (stream.reads())
      find_active_nodes();
  }


  void Contact::set_friction_mode(const FrictionMode mode)
  {
    for (ContactPass &pass : passes_)
      pass.set_friction_mode(mode);
  }


  std::vector<AnchorOfPoint> Contact::anchors() const
  {
    std::vector<AnchorOfPoint> anchors;
    for (unsigned int i = 0; i < passes_.size(); ++i)
      passes_[i].append_anchors(i, anchors);
    return anchors;
  }


  bool Contact::has_restored_anchors() const
  {
    return std::any_of(passes_.begin(), passes_.end(), [](const ContactPass &pass) {
      return pass.has_restored_anchors();
    });
  }


  bool Contact::has_place(const AnchorOfPoint &of_point) const
  {
    const ContactAnchor &anchor = of_point.anchor;
    return of_point.pass < passes_.size() &&
           anchor.facet < passes_[of_point.pass].master().n_facets() &&
           std::isfinite(anchor.xi + anchor.eta + anchor.elastic + anchor.energy);
  }


  void Contact::restore_anchors(const std::vector<AnchorOfPoint> &anchors)
  {
    for (unsigned int i = 0; i < passes_.size(); ++i)
      {
        std::vector<AnchorOfPoint> of_pass;
        for (const AnchorOfPoint &anchor : anchors)
          if (anchor.pass == i)
            of_pass.push_back(anchor);
        passes_[i].restore_anchors(of_pass);
      }
  }
} // namespace vfife
