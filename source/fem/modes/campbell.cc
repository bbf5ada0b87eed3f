// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/base/types.h>
#include <vfife/fem/modes/campbell.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace vfife
{
  namespace
  {
    constexpr double rpm = 30. / pi; // of 1 rad/s

    /** Waves that clearly travel; the bodies' unequal meshes may mix others. */
    std::string direction_of(const ModeDescription &description)
    {
      if (!description.is_pair)
        return "standing";
      return description.forward > .75   ? "forward"
             : description.forward < .25 ? "backward"
                                         : "standing";
    }

    /** A wave of n diameters as an observer at rest sees it: its rate [rad/s], negative where it
     * travels against the spin; not a number where diameters are not known. cos(n phi - s w t) in
     * axes that turn is cos(n phi' - (n Omega + s w) t) in axes that do not. */
    double fixed_rate(const int          nodal_diameter,
                      const std::string &direction,
                      const double       frequency,
                      const double       rate)
    {
      const double sense = direction == "forward" ? 1. : direction == "backward" ? -1. : 0.;
      // Standing waves in turning axes are two travelling ones to others, unless nothing turns.
      if (nodal_diameter < 0 || frequency == 0 || (sense == 0 && nodal_diameter > 0 && rate != 0))
        return not_known;
      return nodal_diameter * std::abs(rate) + (sense == 0 ? 1. : sense) * 2. * pi * frequency;
    }

    double fixed_rate(const RotatingMode &mode, const double rate)
    {
      const ModeDescription &d = mode.description;
      return fixed_rate(d.nodal_diameter, direction_of(d), mode.frequency, rate);
    }

    /** Of a wave that travels: what stands, as a mode without nodal diameters, has no sense. */
    std::string whirl_of(const RotatingMode &mode, const double rate)
    {
      return std::isnan(rate) || direction_of(mode.description) == "standing" ? "-"
             : rate < 0                                                       ? "backward"
                                                                              : "forward";
    }
  } // namespace

  Table make_mode_table()
  {
    Table table{{"body"},
                {column::speed, "rpm"},
                {"mode", "-"},
                {column::frequency, "Hz"},
                {"residual", "-"},
                {"nodal diameter", "-"},
                {"nodal circles", "-"},
                {"share of the diameter", "-"},
                {column::direction},
                {"fixed frequency", "Hz"},
                {"whirl"}};
    for (const char *part : {"axial", "radial", "tangential"})
      table.add_column(part, "-");
    for (const char *axis : {"x", "y", "z"})
      table.add_column(std::string("effective mass ") + axis, "kg");
    for (const char *axis : {"x", "y", "z"})
      table.add_column(std::string("effective inertia ") + axis, "kg mm^2");
    for (const char *axis : {"x", "y", "z"})
      table.add_column(std::string("axis point ") + axis, "mm");
    table.add_column(column::damping_ratio, "-");
    return table;
  }

  void
  add_modes(const std::string &body, const ModesAtSpeed &modes, const double zeta, Table &table)
  {
    for (std::size_t k = 0; k < modes.modes.size(); ++k)
      {
        const RotatingMode      &mode = modes.modes[k];
        const ModeDescription   &d    = mode.description;
        std::vector<Table::Cell> row  = {body,
                                         modes.rate * rpm,
                                         k + 1,
                                         mode.frequency,
                                         mode.residual,
                                         d.nodal_diameter,
                                         d.nodal_circles,
                                         d.share,
                                         direction_of(d),
                                         std::abs(fixed_rate(mode, modes.rate)) / (2. * pi),
                                         whirl_of(mode, fixed_rate(mode, modes.rate)),
                                         d.axial,
                                         d.radial,
                                         d.tangential};
        for (const double value : mode.effective_mass)
          row.emplace_back(1e3 * value); // t -> kg
        for (unsigned int c = 0; c < 3; ++c)
          row.emplace_back(modes.axis_point[c]);
        row.emplace_back(mode.damping_ratio(zeta));
        table.add_row(row);
      }
  }

  std::vector<CampbellBranch> make_branches(const std::vector<ModesAtSpeed> &speeds)
  {
    //   frequency     ___--- backward    A branch: modes of one diameter, direction and order
    //       |  o==<---___                 over the speeds. Without splitting a pair is one branch;
    //       +----------- forward         with it, the pair at rest is where two begin.
    // Whether Coriolis forces split pairs at any speed. If so, a pair at rest is where two
    // branches begin.
    bool travelling = false;
    for (const ModesAtSpeed &at_speed : speeds)
      for (const RotatingMode &mode : at_speed.modes)
        travelling = travelling || direction_of(mode.description) != "standing";

    std::map<std::tuple<int, std::string, unsigned int>, CampbellBranch> branches;
    for (const ModesAtSpeed &at_speed : speeds)
      {
        // Of each diameter and direction. Standing modes of a pair have one frequency: both are one
        // branch, or the two waves of a body at rest whose waves differ at speed.
        std::map<std::pair<int, std::string>, std::vector<double>> frequencies;
        std::map<int, unsigned int>                                n_standing;
        for (const RotatingMode &mode : at_speed.modes)
          {
            if (mode.frequency == 0)
              continue; // rigid
            const int         n         = mode.description.nodal_diameter;
            const std::string direction = direction_of(mode.description);
            if (direction != "standing")
              {
                // A wave that the spin has overtaken runs against it in turning axes, and goes on
                // the branch of the direction that it came from with a negative frequency.
                const bool turned = mode.is_overtaken();
                frequencies[{n,
                             turned ? (direction == "forward" ? "backward" : "forward")
                                    : direction}]
                  .push_back(turned ? -mode.frequency : mode.frequency);
              }
            else if (!mode.description.is_pair)
              frequencies[{n, direction}].push_back(mode.frequency);
            else if (const bool is_second = n_standing[n]++ % 2 == 1; travelling)
              frequencies[{n, is_second ? "forward" : "backward"}].push_back(mode.frequency);
            else if (!is_second)
              frequencies[{n, direction}].push_back(mode.frequency);
          }
        // Frequencies ascend: the n-th of its diameter and direction belongs to branch n.
        for (auto &[key, list] : frequencies)
          {
            std::sort(list.begin(), list.end());
            for (unsigned int k = 0; k < list.size(); ++k)
              {
                CampbellBranch &branch = branches[{key.first, key.second, k + 1}];
                branch.nodal_diameter  = key.first;
                branch.direction       = key.second;
                branch.order           = k + 1;
                branch.rates.push_back(at_speed.rate);
                branch.frequencies.push_back(list[k]);
              }
          }
      }
    std::vector<CampbellBranch> list;
    for (auto &branch : branches)
      list.push_back(std::move(branch.second));
    return list;
  }

  Table make_campbell_table()
  {
    return {{"body"},
            {"nodal diameter", "-"},
            {"order", "-"},
            {column::direction},
            {column::speed, "rpm"},
            {column::frequency, "Hz"},
            {"fixed frequency", "Hz"}};
  }

  void
  add_branches(const std::string &body, const std::vector<CampbellBranch> &branches, Table &table)
  {
    for (const CampbellBranch &branch : branches)
      for (std::size_t i = 0; i < branch.rates.size(); ++i)
        table.add_row(
          {body,
           branch.nodal_diameter,
           branch.order,
           branch.direction,
           branch.rates[i] * rpm,
           std::abs(branch.frequencies[i]),
           std::abs(fixed_rate(
             branch.nodal_diameter, branch.direction, branch.frequencies[i], branch.rates[i])) /
             (2. * pi)});
  }

  Table make_resonance_table()
  {
    return {{"body"},
            {"nodal diameter", "-"},
            {"order", "-"},
            {"excitation"},
            {"wave"},
            {"mesh order", "-"},
            {column::speed, "rpm"},
            {column::frequency, "Hz"},
            {"pinion speed", "rpm"}};
  }

  void add_resonances(const std::string                 &body,
                      const std::vector<CampbellBranch> &branches,
                      const unsigned int                 teeth,
                      const unsigned int                 mesh_orders,
                      const double                       pinion_ratio,
                      Table                             &table)
  {
    for (const CampbellBranch &branch : branches)
      {
        // Speeds [rad/s] at which the frequency of the branch is that multiple of the speed: less
        // that, it has opposite signs at two neighbouring speeds.
        const auto crossings = [&branch](const int orders) {
          std::vector<double> rates;
          const auto          excess = [&](const std::size_t i) {
            return branch.frequencies[i] - std::abs(orders * branch.rates[i]) / (2. * pi);
          };
          for (std::size_t i = 1; i < branch.rates.size(); ++i)
            if ((excess(i - 1) > 0) != (excess(i) > 0))
              {
                const double part = excess(i - 1) / (excess(i - 1) - excess(i));
                rates.push_back(branch.rates[i - 1] +
                                part * (branch.rates[i] - branch.rates[i - 1]));
              }
          return rates;
        };
        const auto add = [&](const std::string &excitation,
                             const std::string &wave,
                             const double       mesh_order,
                             const int          orders) {
          for (const double rate : crossings(orders))
            table.add_row({body,
                           branch.nodal_diameter,
                           branch.order,
                           excitation,
                           wave,
                           mesh_order,
                           rate * rpm,
                           std::abs(orders * rate) / (2. * pi),
                           pinion_ratio * std::abs(rate) * rpm});
        };
        for (unsigned int m = 0; m <= mesh_orders && branch.nodal_diameter >= 0; ++m)
          for (const int sign : {1, -1})
            {
              // Multiples of the speed at which the turning body feels the force.
              const int         orders = static_cast<int>(m * teeth) + sign * branch.nodal_diameter;
              const std::string wave   = branch.nodal_diameter == 0 ? "standing"
                                         : sign > 0 || orders < 0   ? "backward"
                                                                    : "forward";
              const bool        same_again = sign < 0 && (branch.nodal_diameter == 0 || m == 0);
              // Without diameters, or under the constant load, both waves are one; a travelling
              // branch answers to the wave of its own direction alone.
              if (orders != 0 && !same_again &&
                  (branch.direction == "standing" || branch.direction == wave))
                add(m == 0 ? "constant load" : "mesh", wave, m, orders);
            }
        // Unbalance turns with the body: it meets the wave that the spin overtakes.
        if (branch.nodal_diameter == 1 && branch.direction != "standing")
          add("unbalance", branch.direction, not_known, 0);
      }
  }
} // namespace vfife
