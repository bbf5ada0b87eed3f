// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What a record of a gear's probe has of its passage, of records and turns that are made up.
#include "../tests.h"

#include <vfife/output/measures/probe_record.h>

using namespace vfife;

constexpr double frequency = 100.; // mesh cycles a second
constexpr int    teeth     = 40;

/** 10 MPa far from the mesh; a tooth of a saw that rises to 50 MPa from 2 meshes before the mean
 * contact to 6 meshes after it and falls back in 10 more. */
double stress_at(const double after_mesh)
{
  const double place = after_mesh - teeth * std::floor(after_mesh / teeth + .5);
  return 10 + 40 * std::max(0., std::min((place + 2) / 8, (16 - place) / 10));
}

/** Of a run of some mesh cycles that begins at a place after the mesh, two samples a mesh. */
ProbeRecord record(const double begin, const int meshes)
{
  std::vector<double> times, stresses, turn;
  for (int i = 0; i <= 2 * meshes; ++i)
    {
      times.push_back(.5 * i / frequency);
      stresses.push_back(stress_at(begin + .5 * i));
    }
  for (int m = 0; m < teeth; ++m)
    turn.push_back(stress_at(begin + meshes + m));
  return make_probe_record(
    "A",
    times,
    stresses,
    meshes / frequency,
    turn,
    [](const double time) { return time * frequency; },
    -begin / frequency);
}

void check_record(const std::string &name,
                  const ProbeRecord &found,
                  const bool         has_peak,
                  const bool         has_median)
{
  check_close(name + ": largest of a turn", found.largest, 50., 1e-12);
  check_close(name + ": after the mesh", found.largest_after_mesh, 6., 1e-9);
  check_close(name + ": median of a turn", found.median, 10., 1e-12);
  check(name + ": has the peak", found.has_peak == has_peak);
  check(name + ": has the median", found.has_median == has_median);
  std::cout << found.explain() << std::endl;
}

int main()
{
  // The peak is 9 meshes after the begin, the record begins 3 meshes after the mesh before.
  const ProbeRecord whole = record(-3, 14);
  check_record("whole", whole, true, true);
  check_close("whole: peak", whole.peak, 50., 1e-12);
  check_close("whole: time of the peak", whole.peak_time, 9 / frequency, 1e-12);
  check_close("whole: least", whole.least, 10., 1e-12);
  check_record("peak alone", record(2, 5), true, false);
  check_record("ends at the peak", record(0, 6), true, false);
  check_record("ends a mesh before", record(0, 5), false, false);
  check_record("ends long before", record(-10, 12), false, true);
  check_record("begins behind the peak", record(7, 6), false, false);
  check_record("over a turn", record(-50, 50), true, true);

  ProbeRecord before        = whole;
  before.peak               = 54.2495;
  before.largest_after_mesh = -3.909;
  std::cout << before.explain() << std::endl;
  return 0;
}
