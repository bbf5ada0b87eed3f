// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_bearing_columns_h
#define vfife_output_measures_bearing_columns_h

#include <vfife/base/text/sample_columns.h>
#include <vfife/bearing/shaft_seat.h>
#include <vfife/output/measures/mounting.h>

#include <string>
#include <vector>

namespace vfife
{
  struct Bearing;

  /** One bearing at one instant or position. */
  struct BearingSample
  {
    const std::string &bearing;
    const SeatState   &state;
  };

  /** Name, load on the shaft, displacement of its seat: columns of bearings.csv after the time or
   * the position. */
  SampleColumns<BearingSample> list_bearing_columns();

  /** Load over displacement, radial (along x) and axial, of each bearing of the model whose law is
   * no straight line: rows of bearing_curves.csv. */
  Table make_bearing_curves(const std::vector<Bearing> &bearings);

  /** The four numbers of a misalignment: columns of misalignment.csv after the time or the
   * position. */
  SampleColumns<Mounting> list_mounting_columns();
} // namespace vfife

#endif
