// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Local synthesis: from the contact that the paper's pair has at its mean point follow the
// curvatures of its pinion flanks.
#include "../tests.h"
#include "paper_pair.h"

#include <vfife/gear/spiral_bevel/local_contact.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>

using namespace vfife;

void check_side(const GearPair &pair, const MeshSide side)
{
  const ContactAnalysis analysis = analyse_contact(pair, side, ContactAnalysisOptions());
  const MeanContact    &mean     = pair.mean_contact(side);
  const Flank          &gear     = pair.gear().generated_flank(pair.gear_side(side));
  const Flank          &pinion   = pair.pinion().generated_flank(pair.pinion_side(side));
  const Matrix3         R2       = pair.gear_placement(mean.rot2).rotation;
  const Matrix3         R1       = pair.pinion_placement(mean.rot1).rotation;
  const LineContact     contact(mean.position,
                            mean.normal,
                            R2 * gear.curvature_tensor(mean.gear) * R2.transpose(),
                            R1.col(2),
                            R2.col(2),
                            pair.speed_ratio());
  const LengthAndHeight tangents(pair.gear().blank(), mean.gear.position, mean.gear.normal);
  const double          pitch = pair.pinion().pitch();
  LocalContactDesign    design;
  design.lag_curvature   = 2. * analysis.lag_polynomial[0] / (pitch * pitch);
  design.path            = R2 * (std::cos(analysis.path_angle) * tangents.lengthwise +
                      std::sin(analysis.path_angle) * tangents.upward);
  design.small_curvature = analysis.mean.ellipse.relative_curvatures[0];
  const Matrix3 asked    = pinion_curvature_tensor(contact, design);
  const Matrix3 actual   = R1 * pinion.curvature_tensor(mean.pinion) * R1.transpose();
  // the polynomial's first term and the path's angle are those of a fit and of a difference over
  // 0.02 pitches: 1e-4 of the ease-off's curvature 5e-4 1/mm, and 1e-4 rad of 0.06 1/mm
  check_below(side_name(side) + ": curvatures of the pinion flank [1/mm]",
              (asked - actual).norm(),
              1e-5);
}

int main()
{
  const GearPair pair(paper::options());
  check_side(pair, MeshSide::drive);
  check_side(pair, MeshSide::coast);
  return 0;
}
