// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/study/reduced/speed_ranges.h>

#include <string>

namespace vfife
{
  namespace
  {
    /** An amplification over speed. */
    struct SpeedCurve
    {
      std::string         direction, quantity;
      std::vector<double> speeds, values;
    };

    /** The one of that name, added where there is none. */
    SpeedCurve &curve_of(const std::string       &direction,
                         const std::string       &quantity,
                         std::vector<SpeedCurve> &curves)
    {
      for (SpeedCurve &curve : curves)
        if (curve.direction == direction && curve.quantity == quantity)
          return curve;
      curves.push_back({direction, quantity, {}, {}});
      return curves.back();
    }
  } // namespace

  std::vector<SpeedRange> find_ranges_above(const std::vector<double> &speeds,
                                            const std::vector<double> &curve,
                                            const double               level)
  {
    const auto crossing = [&](const std::size_t before) {
      const std::size_t after = before + 1;
      return speeds[before] + (level - curve[before]) / (curve[after] - curve[before]) *
                                (speeds[after] - speeds[before]);
    };
    std::vector<SpeedRange> ranges;
    bool                    above = false;
    for (std::size_t i = 0; i < speeds.size(); ++i)
      {
        const bool begins = curve[i] > level && !above, ends = !(curve[i] > level) && above;
        if (begins)
          ranges.push_back({i > 0 ? crossing(i - 1) : speeds[i], speeds[i], curve[i], speeds[i]});
        else if (ends)
          ranges.back().to = crossing(i - 1);
        above = curve[i] > level;
        if (!above)
          continue;
        ranges.back().to = speeds[i]; // as far as it goes
        if (curve[i] > ranges.back().largest)
          {
            ranges.back().largest = curve[i];
            ranges.back().at      = speeds[i];
          }
      }
    return ranges;
  }

  Table make_exceedance_table()
  {
    return {{column::direction},
            {"quantity"},
            {"from", "rpm"},
            {"to", "rpm"},
            {"largest amplification", "-"},
            {"at", "rpm"}};
  }

  void
  add_exceedances(const Table &resonance, const Table &stresses, const double allowed, Table &table)
  {
    std::vector<SpeedCurve> curves;
    const auto              add = [&curves](const Table       &from,
                               const std::size_t  row,
                               const std::string &quantity,
                               const double       value) {
      SpeedCurve &curve = curve_of(from.column(column::direction).texts[row], quantity, curves);
      curve.speeds.push_back(from.numbers(column::speed)[row]);
      curve.values.push_back(value);
    };
    for (std::size_t row = 0; row < resonance.n_rows(); ++row)
      add(resonance,
          row,
          column::contact_force_total,
          resonance.numbers(column::largest_force)[row] /
            resonance.numbers(column::mean_force)[row]);
    for (std::size_t row = 0; row < stresses.n_rows(); ++row)
      add(stresses,
          row,
          stresses.column(column::place).texts[row],
          stresses.numbers(column::amplification)[row]);
    for (const SpeedCurve &curve : curves)
      for (const SpeedRange &range : find_ranges_above(curve.speeds, curve.values, allowed))
        table.add_row(
          {curve.direction, curve.quantity, range.from, range.to, range.largest, range.at});
  }
} // namespace vfife
