// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/number_list.h>
#include <vfife/base/parameters/parameter_grid.h>
#include <vfife/base/parameters/parameter_table.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/number_text.h>
#include <vfife/gear/errors/member_error_options.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** What single deviations may miss zero by over a revolution, for each tooth: they are rounded
     * in their protocols [um]. */
    constexpr double closing_error = 0.1;

    void refuse_number(const std::size_t numbers, const unsigned int teeth)
    {
      std::ostringstream message;
      message << numbers << " pitch deviations are given, and there are " << teeth << " teeth";
      throw InputError(message.str());
    }

    /** "1, -2.5, 0 um"-like lists without a unit. */
    std::vector<double> parse_list(const std::string &text)
    {
      std::vector<double> numbers;
      std::istringstream  stream(text);
      for (std::string word; std::getline(stream, word, ',');)
        {
          std::string rest;
          for_place("of tooth " + std::to_string(numbers.size()),
                    [&] { numbers.push_back(read_number(word, rest)); });
          if (!rest.empty())
            throw InputError("of tooth " + std::to_string(numbers.size() - 1) +
                             ": expected a number, got \"" + trimmed(word) + "\"");
        }
      return numbers;
    }

    /** Cumulative deviations of single ones [um]. */
    std::vector<double> accumulate(const std::vector<double> &single)
    {
      const double       sum   = std::accumulate(single.begin(), single.end(), 0.);
      const unsigned int teeth = single.size();
      if (std::abs(sum) > closing_error * teeth)
        {
          std::ostringstream message;
          message << "single pitch deviations add up to " << sum
                  << " um over a revolution and must add up to zero (within " << closing_error
                  << " um a tooth); a tooth that is displaced alone by f has f, its next one -f";
          throw InputError(message.str());
        }
      // what is left by rounding is shared by all pitches
      std::vector<double> cumulative(teeth, 0.);
      for (unsigned int k = 1; k < teeth; ++k)
        cumulative[k] = cumulative[k - 1] + single[k] - sum / teeth;
      return cumulative;
    }

    /** Where a grid's table has the cone coordinates of its points, they must go as rows and
     * columns do: from tip to root and from toe to heel. */
    void check_places(const std::string &path)
    {
      const Table table = read_parameter_table(path);
      const auto  check = [&](const char *name, const bool along, const char *wrong) {
        if (std::none_of(table.columns().begin(), table.columns().end(), [&](const auto &column) {
              return column.name == name;
            }))
          return;
        // Along the columns growing, or down the rows falling.
        const Eigen::MatrixXd places = arrange_on_grid(table, path, name, "mm");
        for (Eigen::Index i = along ? 0 : 1; i < places.rows(); ++i)
          for (Eigen::Index j = along ? 1 : 0; j < places.cols(); ++j)
            if (along ? !(places(i, j) > places(i, j - 1)) : !(places(i, j) < places(i - 1, j)))
              throw InputError("the table \"" + path + "\": at row " + std::to_string(i + 1) +
                               ", column " + std::to_string(j + 1) + " " + wrong);
      };
      check("L", true, "L is not larger than a column before: columns go from toe to heel");
      check("h", false, "h is not smaller than a row before: rows go from tip to root");
    }

    /** Deviations of a file, a row a tooth [um]. */
    std::vector<double> read_pitch_table(const std::string &path, const unsigned int teeth)
    {
      const Table table  = read_parameter_table(path);
      bool        single = false;
      for (const Table::Column &column : table.columns())
        single = single || column.name == "single pitch deviation";
      const std::vector<double> tooth = find_column(table, path, "tooth", "-");
      const std::vector<double> value = find_column(
        table, path, single ? "single pitch deviation" : "cumulative pitch deviation", "um");
      if (value.size() != teeth)
        refuse_number(value.size(), teeth);
      std::vector<double> of_tooth(teeth, std::nan(""));
      for (unsigned int i = 0; i < teeth; ++i)
        {
          const bool is_tooth =
            tooth[i] >= 0. && tooth[i] < teeth && tooth[i] == std::floor(tooth[i]);
          if (!is_tooth || !std::isnan(of_tooth[static_cast<unsigned int>(tooth[i])]))
            throw InputError("the table \"" + path + "\": expected each tooth from 0 to " +
                             std::to_string(teeth - 1) + " once, got tooth " +
                             number_text(tooth[i]) + (is_tooth ? " twice" : ""));
          of_tooth[static_cast<unsigned int>(tooth[i])] = value[i];
        }
      return single ? accumulate(of_tooth) : of_tooth;
    }
  } // namespace

  void FlankErrorOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_text(prm,
                 "single pitch deviations",
                 pitch_list,
                 "Single pitch deviations: position of each flank, tooth 0, 1, ..., against "
                 "the one before it; positive is additional metal; one value per tooth, "
                 "separated by commas [um]");
    declare_file_name(
      prm,
      "pitch table",
      pitch_table,
      "Table file with the columns \"tooth\" and \"single pitch deviation [um]\" or "
      "\"cumulative pitch deviation [um]\"");
    declare_quantity(
      prm,
      "pitch amplitude",
      pitch_amplitude,
      "um",
      "Amplitude of cumulative pitch deviations that follow a cosine over the teeth");
    declare_integer(prm, "pitch order", pitch_order, "Periods of this cosine per revolution", 1);
    declare_quantity(prm, "pitch phase", pitch_phase, "deg", "Phase lag of this cosine at tooth 0");
    declare_file_name(prm,
                      "topography",
                      topography,
                      "Grid file of deviations normal to the flank, positive is additional metal "
                      "[um]: rows from tip to root, columns from toe to heel");
    declare_number_list(prm,
                        "topography teeth",
                        topography_teeth,
                        "Teeth that have this grid; empty: all teeth",
                        ListNumbers::whole);
    margins.declare(prm);
    const auto term = [&](const char *name, double &value, const char *meaning) {
      declare_quantity(prm, name, value, "um", meaning);
    };
    term("profile slope",
         terms.pressure_angle,
         "Profile slope deviation: metal at the tip minus metal at the root");
    term("lengthwise slope",
         terms.spiral_angle,
         "Lengthwise slope deviation: metal at the heel minus metal at the toe");
    term("profile crowning",
         terms.profile_crowning,
         "Parabolic relief at tip and root relative to the middle of the flank");
    term("lengthwise crowning",
         terms.lengthwise_crowning,
         "Parabolic relief at toe and heel relative to the middle of the flank");
    term("bias",
         terms.bias,
         "Bias: lengthwise slope at the tip minus lengthwise slope at the root");
  }

  std::vector<double> FlankErrorOptions::read_pitch(const std::string &section,
                                                    const unsigned int teeth) const
  {
    const std::string list_entry  = section + "/single pitch deviations",
                      table_entry = section + "/pitch table";
    if (!pitch_list.empty() && !pitch_table.empty())
      throw InputError(
        table_entry,
        "expected a pitch table or single pitch deviations, got both. Remove one of them");
    std::vector<double> deviations; // [um]
    if (!pitch_list.empty())
      deviations = for_entry(list_entry, [&]() {
        const std::vector<double> single = parse_list(pitch_list);
        if (single.size() != teeth)
          refuse_number(single.size(), teeth);
        return accumulate(single);
      });
    if (!pitch_table.empty())
      deviations = for_entry(table_entry, [&]() { return read_pitch_table(pitch_table, teeth); });
    for (double &deviation : deviations)
      deviation *= micrometre;
    if (pitch_amplitude != 0.)
      {
        deviations.resize(teeth, 0.);
        for (unsigned int k = 0; k < teeth; ++k)
          deviations[k] +=
            pitch_amplitude * std::cos(2. * pi * pitch_order * k / teeth - pitch_phase);
      }
    return deviations;
  }

  Eigen::MatrixXd read_deviation_grid(const std::string &path)
  {
    if (has_headings(path))
      check_places(path);
    return read_parameter_grid(path, "deviation", "um");
  }

  Eigen::MatrixXd FlankErrorOptions::read_topography(const std::string &section) const
  {
    if (topography.empty())
      return {};
    // protocols have the tip above
    return for_entry(section + "/topography", [&]() -> Eigen::MatrixXd {
      return micrometre * read_deviation_grid(topography).colwise().reverse();
    });
  }

  std::vector<bool> FlankErrorOptions::read_teeth(const std::string &section,
                                                  const unsigned int teeth) const
  {
    std::vector<bool> chosen(teeth, topography_teeth.empty());
    for (const std::string &name : topography_teeth)
      for_entry(section + "/topography teeth",
                [&]() { chosen[read_tooth_number(name, teeth)] = true; });
    if (topography.empty() && !topography_teeth.empty())
      throw InputError(section + "/topography teeth",
                       "expected a topography for these teeth, got none");
    return chosen;
  }

  void MemberErrorOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_quantity(prm,
                     "radial runout amplitude",
                     eccentricity,
                     "um",
                     "Distance between the axis of the teeth and the axis of rotation: half the "
                     "total radial runout",
                     Range::not_negative());
    declare_quantity(prm,
                     "radial runout direction",
                     eccentricity_direction,
                     "deg",
                     "Direction in which the axis of the teeth is displaced: angle from tooth 0, "
                     "positive about the body's axis");
    declare_quantity(prm,
                     "axial runout amplitude",
                     wobble,
                     "um",
                     "Amplitude of the axial displacement of the mean pitch circle, caused by a "
                     "tilted axis of the teeth: half the total axial runout",
                     Range::not_negative());
    declare_quantity(prm,
                     "axial runout direction",
                     wobble_direction,
                     "deg",
                     "Position of the largest displacement away from the apex: angle from tooth 0, "
                     "positive about the body's axis");
    declare_section(prm, "Concave flank", concave);
    declare_section(prm, "Convex flank", convex);
  }

  void MemberErrorOptions::check(const std::string &section, const unsigned int teeth) const
  {
    std::vector<InputError>     errors;
    const std::function<void()> checks[] = {
      [&]() { concave.read_pitch(section + "/Concave flank", teeth); },
      [&]() { concave.read_topography(section + "/Concave flank"); },
      [&]() { concave.read_teeth(section + "/Concave flank", teeth); },
      [&]() { convex.read_pitch(section + "/Convex flank", teeth); },
      [&]() { convex.read_topography(section + "/Convex flank"); },
      [&]() { convex.read_teeth(section + "/Convex flank", teeth); }};
    for (const auto &check : checks)
      try
        {
          check();
        }
      catch (const InputError &error)
        {
          errors.push_back(error);
        }
    if (!errors.empty())
      throw InputErrors(errors);
  }
} // namespace vfife
