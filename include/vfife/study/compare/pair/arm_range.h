// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_pair_arm_range_h
#define vfife_study_compare_pair_arm_range_h

#include <string>

namespace vfife
{
  struct ComparedCase;

  /**
   * Arms of the contact force of a run, as its summary states them. The mean force is the torque
   * over a mean of the arms at which tooth pairs carry, and these lie along the path of contact:
   * how far they are from the arm of the mean contact is no fault of a run.
   */
  class ArmRange
  {
  public:
    explicit ArmRange(const ComparedCase &run);

    /** Largest part by which torque over an arm of the path is off that over the mean contact's; 0
     * for runs of versions that did not state arms. */
    double spread() const;

    /** The end of a sentence; empty where nothing is known. */
    std::string describe() const;

  private:
    bool   known_;
    double mean_, least_, largest_; ///< [mm]
  };
} // namespace vfife

#endif
