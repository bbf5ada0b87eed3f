// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A gear whose teeth 20 to 70 have 10 um more metal on both flanks than the others: where these
// carry, the loaded contact analysis and a run of the coarse pair have the transmission error of
// the gear without errors and F/r of the turned teeth.
#include "../../model_sections.h"
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/base/types.h>

#include <filesystem>

using namespace vfife;

constexpr double F = 10e-3; ///< [mm]

/** F over the radius of the mean pitch circle [arcsec]. */
double closed_form()
{
  return F / (116.49 * std::sin(std::atan(79. / 27.))) / arcsecond;
}

/** The pair with more metal on the gear's teeth from @p first on up to @p end. */
std::string pair_text(const unsigned int first, const unsigned int end)
{
  std::ofstream table("pitch.csv");
  table << "tooth,cumulative pitch deviation [um]\n";
  for (unsigned int k = 0; k < 79; ++k)
    table << k << "," << (k >= first && k < end ? 1e3 * F : 0.) << "\n";
  const std::string flank = "      set pitch table = pitch.csv\n    end\n";
  return quick_pair("set body type = rim only", "set elements through rim = 2", "1e-5") +
         "subsection Gear pair\n  subsection Errors\n   subsection Gear\n" +
         "    subsection Concave flank\n" + flank + "    subsection Convex flank\n" + flank +
         "   end\n  end\nend\n";
}

Columns analyse(const unsigned int end, const unsigned int mesh, Communicator &world)
{
  std::filesystem::remove_all("loaded_errors");
  std::ofstream("loaded_errors.prm")
    << pair_text(20, end) << model_text::study("loaded tooth contact analysis")
    << "subsection Loaded contact\n set positions = 2\n set first position = " << mesh << "\nend\n";
  run_pair("loaded_errors.prm", "loaded_errors", world);
  return read_columns("loaded_errors/loaded_contact.csv");
}

void loaded_contact(Communicator &world)
{
  // teeth 78, 0 and 1 are in mesh, 45 mesh cycles later 44 to 46
  const auto plain = analyse(20, 0, world), before = analyse(71, 0, world),
             after = analyse(71, 45, world);
  for (unsigned int i = 0; i < 2; ++i)
    {
      const std::string name = "position " + std::to_string(i);
      check_close(name + ": begins there", after.at("position")[i], 45. + i / 2., 1e-9);
      // All meshes are alike but for the errors; what slides along flanks is of second order.
      for (const char *column : {"unloaded transmission error", "transmission error"})
        {
          check_close(name + ", " + column + ": other teeth [arcsec]",
                      before.at(column)[i],
                      plain.at(column)[i],
                      2e-3);
          check_close(name + ", " + column + ": ahead by F/r [arcsec]",
                      after.at(column)[i] - plain.at(column)[i],
                      closed_form(),
                      .02);
        }
      check_ratio(name + ": secant stiffness over that without errors",
                  after.at("secant stiffness")[i] / plain.at("secant stiffness")[i],
                  1e-3);
    }
}

/** All teeth ahead: a run starts there. */
void run(Communicator &world)
{
  const auto dte = [&](const unsigned int end, const std::string &folder, Communicator &ranks) {
    std::filesystem::remove_all(folder);
    std::ofstream(folder + ".prm") << pair_text(0, end);
    run_pair(folder + ".prm", folder, ranks);
    return read_columns(folder + "/history.csv").at("dte");
  };
  const auto plain = dte(0, "plain_run", world), ahead = dte(79, "ahead_run", world);
  double     off = plain.size() == ahead.size() ? 0. : 1e9;
  for (std::size_t i = 0; i < plain.size(); ++i)
    raise_to(off, std::abs(ahead[i] - plain[i] - closed_form()));
  check_below("run: ahead by F/r at all times [arcsec]", off, .05);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  loaded_contact(session.world());
  run(session.world());
  for (const char *surface : {"smooth patches", "flat facets"})
    print_refused_entry([&] {
      std::ofstream("refused.prm") << pair_text(20, 71);
      run_pair("refused.prm",
               "refused",
               session.world(),
               {std::string("Contact/surface=") + surface});
    });
  return 0;
}
