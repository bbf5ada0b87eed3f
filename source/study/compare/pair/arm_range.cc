// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/output/files/result_places.h>
#include <vfife/study/compare/compared_case.h>
#include <vfife/study/compare/pair/arm_range.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    double figure(const ComparedCase &run, const char *name)
    {
      return run.number("summary.json", summary_place::figure(name));
    }
  } // namespace

  ArmRange::ArmRange(const ComparedCase &run)
    : mean_(figure(run, figure_name::effective_arm))
    , least_(figure(run, figure_name::least_arm))
    , largest_(figure(run, figure_name::largest_arm))
  {
    known_ = std::isfinite(mean_ + least_ + largest_) && least_ > 0;
  }

  double ArmRange::spread() const
  {
    // T/arm over T/mean, less one
    return known_ ? std::max(mean_ / least_ - 1, 1 - mean_ / largest_) : 0.;
  }

  std::string ArmRange::describe() const
  {
    if (!known_)
      return "";
    std::ostringstream text;
    text << ", " << mean_ << " mm; along the path of contact it is " << least_ << " to " << largest_
         << " mm, which the tolerance has in it";
    return text.str();
  }
} // namespace vfife
