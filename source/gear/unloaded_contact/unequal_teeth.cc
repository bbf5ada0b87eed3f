// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/gear/unloaded_contact/unequal_teeth.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace vfife
{
  namespace
  {
    /** No pair touches farther from its mean contact [pitches]. */
    constexpr double farthest_pair = 2.;
  } // namespace

  UnequalTeeth::UnequalTeeth(const GearPair &pair, const MeshSide side)
    : pair_(pair)
    , side_(side)
  {
  }

  const PairContact &UnequalTeeth::contact(const int k)
  {
    const auto known = contacts_.find(k);
    if (known != contacts_.end())
      return known->second;
    // pairs that have left the mesh, whichever way it goes
    for (auto entry = contacts_.begin(); entry != contacts_.end();)
      entry =
        std::abs(entry->first - k) > 2. * farthest_pair + 1. ? contacts_.erase(entry) : ++entry;
    return contacts_.emplace(k, PairContact(pair_, side_, k)).first->second;
  }

  UnequalTeeth::Position UnequalTeeth::at(const double pitches)
  {
    Position result{std::numeric_limits<double>::infinity(), 0};
    // pair k passes its mean contact at -k pitches
    const int last = static_cast<int>(std::floor(farthest_pair - pitches));
    for (int k = static_cast<int>(std::ceil(-farthest_pair - pitches)); k <= last; ++k)
      {
        const PairContact &own   = contact(k);
        const double       place = pitches + k;
        if (place < own.whole()[0] || place > own.whole()[1])
          continue;
        const double lag = own.lag(place);
        if (lag < result.lag)
          result = {lag, k};
      }
    return result;
  }

  unsigned int UnequalTeeth::hunting_cycle(const GearPair &pair)
  {
    return std::lcm(pair.pinion().blank().teeth, pair.gear().blank().teeth);
  }

  Table transmission_of_meshes(const GearPair               &pair,
                               const ContactAnalysisOptions &options,
                               const unsigned int            meshes)
  {
    Table table;
    table.add_column("mesh cycles", "-");
    table.add_column("driver angle", "deg");
    table.add_column("transmission error", "arcsec");
    table.add_column("pinion tooth", "-");
    table.add_column("gear tooth", "-");
    const MeshSide     side  = options.working_side();
    const double       sense = options.direction == TurningDirection::forward ? 1. : -1.;
    const double       ratio = pair.speed_ratio(), pitch = pair.pinion().pitch();
    const unsigned int n = options.points_per_pitch;
    UnequalTeeth       teeth(pair, side);
    for (unsigned int i = 0; i <= meshes * n; ++i)
      {
        const double pitches  = i / static_cast<double>(n);
        const auto   position = teeth.at(sense * pitches);
        if (!std::isfinite(position.lag))
          continue; // nothing touches: a gap in the curve
        // as in transmission_table(): a driving gear is ahead of the exact ratio
        const bool   pinion_drives = options.driving == DrivingMember::pinion;
        const double angle =
          pinion_drives ? pitches * pitch : ratio * pitches * pitch + position.lag;
        const double error   = pinion_drives ? -position.lag : -position.lag / ratio;
        const auto   numbers = teeth_of_pair(pair, side, position.pair);
        table.add_row(
          {pitches, angle * 180. / pi, error / arcsecond, numbers.first, numbers.second});
      }
    return table;
  }
} // namespace vfife
