// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Loaded tooth contact analysis of a coarse pair by finite elements.
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/process/mpi_session.h>

#include <cmath>
#include <filesystem>

using namespace vfife;

namespace
{
  /** What --check says, about the pair of this test as @p kind with @p overrides. */
  std::string
  inspect(const std::string &kind, const std::vector<std::string> &overrides, Communicator &world)
  {
    CommandLine line;
    line.parameter_file = "checked_pair.prm";
    line.check          = true;
    line.overrides      = overrides;
    line.overrides.push_back("Study/kind=" + kind);
    line.overrides.push_back("Output/verbosity=normal");
    std::ostringstream screen;
    Log                log(screen, world.is_root());
    run_study(line, world, log);
    return screen.str();
  }

  /** The number behind the words, NaN where they are missing. */
  double number_behind(const std::string &words, const std::string &text)
  {
    const std::size_t found = text.find(words);
    return found == std::string::npos ? NAN : std::stod(text.substr(found + words.size()));
  }

  /** The run's masses are scaled, and its penalties follow from them. */
  void mass_scaling(Communicator &world)
  {
    std::ofstream("checked_pair.prm") << quick_pair("set web = none", "set rim rows = 2", "1e-5");
    const std::string words    = "contact penalty of the drive side ",
                      own      = "penalty of a run of this file ",
                      analysis = "loaded tooth contact analysis";
    const std::string unscaled = inspect("run", {}, world);
    const double      step     = number_behind("stable step of the elements ", unscaled);
    check_close("penalty of a run",
                number_behind(own, inspect(analysis, {}, world)) / number_behind(words, unscaled),
                1.,
                1e-5); // digits of the log
    const std::vector<std::string> scaling = {"Dynamics/mass scaling step=" +
                                                std::to_string(1.3 * step) + " ns",
                                              "Dynamics/largest added mass=0.9"};
    const double                   scaled  = number_behind(words, inspect("run", scaling, world));
    check("mass scaling changes it", std::abs(scaled / number_behind(words, unscaled) - 1) > 0.05);
    check_close("penalty of a run with mass scaling",
                number_behind(own, inspect(analysis, scaling, world)) / scaled,
                1.,
                1e-5);
  }
} // namespace

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all("loaded_contact_results");
  std::ofstream("loaded_contact.prm")
    << quick_pair("set web = none", "set rim rows = 2", "1e-5")
    << "subsection Study\n set kind = loaded tooth contact analysis\nend\n"
    << "subsection Loaded contact\n set positions = 2\nend\n";
  run_pair("loaded_contact.prm", "loaded_contact_results", session.world());

  check("loaded_teeth.csv is written",
        std::filesystem::exists("loaded_contact_results/loaded_teeth.csv"));
  auto columns = read_columns("loaded_contact_results/loaded_contact.csv");
  check("two positions", columns["position"].size() == 2);
  for (std::size_t i = 0; i < columns["position"].size(); ++i)
    {
      // Newton's method stops at 1e-9 of the torque.
      check_close("contact torque [N m]", columns["contact torque on the gear"][i], 800., 1e-6);
      check("the gear lags the more under load",
            columns["transmission error"][i] < columns["unloaded transmission error"][i]);
      // Further teeth and points come into contact as the load grows.
      check("the tangent is stiffer than the secant",
            columns["tangent stiffness"][i] > columns["secant stiffness"][i]);
    }
  mass_scaling(session.world());
}
