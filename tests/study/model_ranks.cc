// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// General models give the same histories on one rank and on several: bars in contact, a turning
// body, a clamped beam.
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <algorithm>
#include <filesystem>
#include <limits>

using namespace vfife;

namespace
{
  using Columns = std::map<std::string, std::vector<double>>;

  void run_case(const std::string              &name,
                const std::vector<std::string> &overrides,
                const std::string              &folder,
                Communicator                   &communicator)
  {
    CommandLine line;
    line.parameter_file = std::string(SOURCE_DIR) + "/../../prm/verification/" + name + ".prm";
    line.output_folder  = folder;
    line.overrides      = overrides;
    line.overrides.emplace_back("Output/verbosity=quiet");
    line.overrides.emplace_back("Output/pictures=no");
    std::ostringstream nothing;
    Log                log(nothing, communicator.is_root(), Verbosity::quiet);
    run_study(line, communicator, log);
  }

  /** Columns of one vector ("momentum x", "momentum y"...) have one scale, that of the largest:
   * what is zero but for round-off has none of its own. */
  std::string family(const std::string &column)
  {
    static const std::vector<std::string> families = {"angular momentum",
                                                      "momentum",
                                                      " contact force ",
                                                      " displacement "};
    for (const std::string &one : families)
      if (column.find(one) != std::string::npos)
        return column.substr(0, column.find(one)) + one;
    return column;
  }

  bool is_stress(const std::string &column)
  {
    return column.find(" stress ") != std::string::npos ||
           column.find(" von mises") != std::string::npos;
  }

  bool is_reaction(const std::string &column)
  {
    return column.find(" reaction ") != std::string::npos;
  }

  double largest_size(const std::vector<double> &values)
  {
    double size = 0;
    for (const double v : values)
      size = largest_of(size, std::abs(v));
    return size;
  }

  double largest_difference(const std::vector<double> &one, const std::vector<double> &other)
  {
    double difference = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
      difference = largest_of(difference, std::abs(one[i] - other.at(i)));
    return difference;
  }

  struct Difference
  {
    double      relative = 0; ///< largest of any column over its largest value
    double      stress   = 0; ///< [MPa]
    double      reaction = 0; ///< [N], moments over the largest coordinate
    std::string column;       ///< of the first
  };

  /** The energy error is left out: round-off of the energy of flight over the little exchanged. */
  Difference compare(const Columns &one, const Columns &other, const double coordinate)
  {
    std::map<std::string, double> size;
    for (const auto &[name, values] : one)
      size[family(name)] = largest_of(size[family(name)], largest_size(values));
    Difference result;
    for (const auto &[name, values] : one)
      {
        const double difference = largest_difference(values, other.at(name));
        if (is_stress(name))
          result.stress = largest_of(result.stress, difference);
        else if (is_reaction(name))
          result.reaction =
            largest_of(result.reaction,
                       name.find(" moment ") == std::string::npos ? difference
                                                                  : difference / coordinate);
        else if (name != "energy error" && difference > result.relative * size[family(name)])
          {
            result.relative = difference / size[family(name)];
            result.column   = name;
          }
      }
    return result;
  }

  /** @p coordinate, @p cell: the largest one, and the length of a cell [mm]. */
  void compare_ranks(const std::string              &name,
                     const std::vector<std::string> &overrides,
                     const double                    coordinate,
                     const double                    cell,
                     Communicator                   &world,
                     const bool                      tell)
  {
    if (world.is_root())
      {
        for (const char *folder : {"_alone", "_shared"})
          std::filesystem::remove_all(name + folder);
        Communicator alone(MPI_COMM_SELF);
        run_case(name, overrides, name + "_alone", alone);
      }
    world.barrier();
    run_case(name, overrides, name + "_shared", world);
    world.barrier();
    if (!world.is_root())
      return;
    const Columns one     = read_columns(name + "_alone/history.csv"),
                  other   = read_columns(name + "_shared/history.csv");
    const bool comparable = one.size() == other.size() && one.size() > 20 &&
                            one.at("time").size() > 3 && one.at("time") == other.at("time");
    check(name + ": same columns and samples", comparable);
    if (!comparable)
      return;
    const Difference difference = compare(one, other, coordinate);
    // A unit in the last place of a coordinate is a strain of eps x/h.
    const double unit = 206000 * std::numeric_limits<double>::epsilon() * coordinate / cell;
    if (tell)
      std::cout << name << ": " << difference.relative << " of " << difference.column << ", stress "
                << difference.stress << " MPa, " << difference.stress / unit
                << " units in the last place" << std::endl;
    // doc/conventions.md.
    check_below(name + ": histories over their largest values", difference.relative, 1e-8);
    // Some 10^2 to 10^3 steps add up at random to some 10 to 30 of them.
    check_below(name + ": stresses in units in the last place", difference.stress / unit, 200);
    // Forces of nodes with the stiffness E h.
    check_below(name + ": reactions in units in the last place",
                difference.reaction / (unit * cell * cell),
                200);
  }
} // namespace

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  const bool tell = argc > 1;
  compare_ranks("two_bars",
                {"Model/Body flying/cells x=40",
                 "Model/Body resting/cells x=40",
                 "Dynamics/end time=40 us"},
                200.,
                2.5,
                session.world(),
                tell);
  compare_ranks("tumbling", {"Dynamics/end time=0.05 ms"}, 20., 2., session.world(), tell);
  compare_ranks(
    "vibrating_cantilever", {"Dynamics/end time=0.3 ms"}, 100., 2.5, session.world(), tell);
}
