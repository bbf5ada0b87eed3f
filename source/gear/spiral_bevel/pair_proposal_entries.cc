// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The part of PairProposal that declares its entries.
#include <vfife/base/parameters/parameters.h>
#include <vfife/gear/spiral_bevel/pair_proposal.h>

namespace vfife
{
  void PairProposal::declare(dealii::ParameterHandler &prm)
  {
    declare_integer(prm,
                    "pinion teeth",
                    pinion_teeth,
                    "Number of teeth; 0: no proposal, blanks and machine settings are given");
    declare_integer(prm, "gear teeth", gear_teeth, "Number of teeth of the gear");
    declare_choice(prm,
                   "pinion hand",
                   pinion_hand,
                   hand_choices(),
                   "Hand of the pinion's spiral; the gear gets the opposite hand");
    declare_quantity(
      prm, "module", module, "mm", "Outer transverse module", Range::between(0., 100.));
    declare_quantity(prm,
                     "face width",
                     face_width,
                     "mm",
                     "Face width; 0: 0.3 of the outer cone distance",
                     Range::not_negative());
    declare_quantity(
      prm, "spiral angle", spiral_angle, "deg", "Mean spiral angle", Range::between(10., 50.));
    declare_quantity(prm,
                     "pressure angle",
                     pressure_angle,
                     "deg",
                     "Blade angle of both flanks",
                     Range::between(10., 30.));
    declare_quantity(prm,
                     "cutter radius",
                     cutter_radius,
                     "mm",
                     "Mean radius of the cutter; 0: 0.82 of the mean cone distance",
                     Range::not_negative());
    declare_quantity(prm,
                     "transmission error at half pitch",
                     lag,
                     "arcsec",
                     "Parabolic transmission error without load, half a pitch from the mean "
                     "contact (the gear lags)",
                     Range::positive());
    declare_quantity(prm,
                     "path direction",
                     path_angle,
                     "deg",
                     "Direction of the path of contact on the gear's convex flank, relative to the "
                     "lengthwise direction; positive: it rises to the tip at the heel; mirrored on "
                     "the concave flank",
                     Range::between(-90., 90.));
    declare_number(prm,
                   "contact ellipse ratio",
                   ellipse_length,
                   "Length of the contact ellipse (6.35 um separation) divided by the face width",
                   Range::positive());
  }
} // namespace vfife
