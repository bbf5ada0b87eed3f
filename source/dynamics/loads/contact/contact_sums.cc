// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/loads/contact/contact_of_pair.h>
#include <vfife/dynamics/loads/contact/contact_sums.h>
#include <vfife/model/tooth_contact.h>

namespace vfife
{
  void ContactSums::set(const ContactPairs &pairs, const bool fails)
  {
    sums_ = {};
    for (const auto &pair : pairs)
      for (const GroupPairResult &result : pair->contact.results())
        {
          sums_[of_energy] += result.energy;
          sums_[of_lost_power] += result.damping_power;
          sums_[of_friction_loss] += result.friction_loss;
          sums_[of_pressure] += result.normal_force;
          if (result.largest_penetration > pair->penetration_limit())
            sums_[of_depth] = 1;
        }
    sums_[of_failure] = fails ? 1. : 0.;
  }

  void ContactSums::set_teeth(const Model &model, const ContactPairs &pairs)
  {
    if (model.transmissions.empty())
      return;
    // As many numbers on all ranks, whether this one has failed or not: candidates are the same.
    teeth_.assign(1, 0.);
    for (unsigned int p = 0; p < pairs.size(); ++p)
      {
        const Contact &contact = pairs[p]->contact;
        const auto    &results = contact.results();
        for (std::size_t i = 0; i < contact.candidate_pairs().size(); ++i)
          {
            const GroupPairResult result = i < results.size() ? results[i] : GroupPairResult();
            teeth_.front() += make_tooth_contact(model, p, result).torque;
            teeth_.insert(teeth_.end(), result.force.begin(), result.force.end());
          }
      }
  }

  void ContactSums::sum(const Communicator &communicator)
  {
    communicator.sum(sums_.data(), sums_.size());
  }

  void ContactSums::append(std::vector<double *> &numbers)
  {
    for (double &sum : sums_)
      numbers.push_back(&sum);
    for (double &sum : teeth_)
      numbers.push_back(&sum);
  }

  double ContactSums::tooth_force() const
  {
    double sum = 0;
    for (std::size_t i = 1; i + 2 < teeth_.size(); i += 3)
      sum += Vector3(teeth_[i], teeth_[i + 1], teeth_[i + 2]).norm();
    return sum;
  }

  double ContactSums::torque() const
  {
    return teeth_.empty() ? 0. : teeth_.front();
  }
} // namespace vfife
