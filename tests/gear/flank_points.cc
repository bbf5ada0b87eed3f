// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The table of flank points: where they lie between toe and heel, fillet and tip, and that their
// normals leave the metal.
#include "../tests.h"
#include "paper_pair.h"

#include <vfife/gear/flank_points.h>

using namespace vfife;

void check_member(const std::string &name, const GearMember &member)
{
  constexpr unsigned int lengthwise = 4, profile = 3;
  const Table            table = compute_flank_points(member, lengthwise, profile);
  const Blank           &blank = member.blank();
  check(name + ": points of both sides", table.n_rows() == 2 * lengthwise * profile);
  const auto vector_at = [&](const char *x, const char *y, const char *z, const std::size_t row) {
    return Vector3(table.numbers(x)[row], table.numbers(y)[row], table.numbers(z)[row]);
  };
  double L_off = 0., h_off = 0., place_off = 0., slope = 0., length = 0.;
  bool   outwards = true;
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    {
      const unsigned int i = row / profile % lengthwise, j = row % profile;
      const bool         concave = row < lengthwise * profile;
      const FlankSide    side    = concave ? FlankSide::concave : FlankSide::convex;
      outwards = outwards && table.column("side").texts[row] == (concave ? "concave" : "convex");
      // 1. Even steps from toe to heel along the pitch cone, and from the fillet to the tip.
      const double L = table.numbers("L")[row], h = table.numbers("h")[row];
      const double end = member.blank().coordinates_of(
        member.fillet_point(side, L, member.fillet_end(side)).position)[1];
      raise_to(L_off, std::abs(L - (blank.mean_cone_distance + blank.face_width * (i / 3. - .5))));
      raise_to(h_off, std::abs(h - (end + (blank.addendum(L) - end) * j / 2.)));
      // 2. The point is there, ...
      const Vector3 x = vector_at("x", "y", "z", row);
      raise_to(place_off, (blank.coordinates_of(x) - Vector2(L, h)).norm());
      // 3. ... its normal is across the flank by differences of two neighbours, and leaves the
      // tooth: round the axis the tooth lies on the other side.
      const Vector3 n    = vector_at("normal x", "normal y", "normal z", row);
      const double  step = 1e-4, inside = i == 0 ? step : -step, below = j == 0 ? step : -step;
      raise_to(length, std::abs(n.norm() - 1.));
      slope =
        largest_of({slope,
                    std::abs(n.dot(member.flank_point(side, L + inside, h).position - x) / step),
                    std::abs(n.dot(member.flank_point(side, L, h + below).position - x) / step)});
      const Vector3 other =
        member.flank_point(concave ? FlankSide::convex : FlankSide::concave, L, h).position;
      outwards = outwards && n.dot(other - x) < 0.;
    }
  check_below(name + ": even steps from toe to heel [mm]", L_off, 1e-2);
  check_below(name + ": even steps from the fillet to the tip [mm]", h_off, 1e-9);
  check_below(name + ": points at their places [mm]", place_off, 1e-8);
  check_below(name + ": length of the normals less 1", length, 1e-12);
  // Curvatures of 1/100 mm over the step.
  check_below(name + ": normals across the flank", slope, 1e-5);
  check(name + ": normals leave the tooth", outwards);
}

int main()
{
  const GearPair pair(paper::options());
  check_member("pinion", pair.pinion());
  check_member("gear", pair.gear());
  return 0;
}
