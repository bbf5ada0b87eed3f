// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Root stresses by submodels of a run, a reduced pair and a loaded analysis: the same pair in the
// same static equilibrium, and the same motion.
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

using namespace vfife;

/** Rows of root_stress.csv by body, fillet and tooth: tension and compression [MPa]. */
using Stresses = std::map<std::string, std::pair<double, double>>;

/** At the first instant or position. */
Stresses read_stresses(const std::string &folder)
{
  const Table table = read_result_table(folder + "/root_stress.csv");
  const auto &at    = table.columns().front().numbers;
  Stresses    stresses;
  for (std::size_t i = 0; i < table.n_rows() && at[i] == at.front(); ++i)
    stresses[table.column("body").texts[i] + " " + table.column("fillet").texts[i] + " " +
             std::to_string(std::lround(table.numbers("tooth")[i]))] = {
      table.numbers("tension")[i], table.numbers("compression")[i]};
  return stresses;
}

/** Of a body, or of a body and a fillet. */
double largest_tension(const Stresses &stresses, const std::string &body)
{
  double found = 0.;
  for (const auto &[tooth, stress] : stresses)
    if (tooth.rfind(body, 0) == 0)
      raise_to(found, stress.first);
  return found;
}

/** Of the largest tension of a body at each instant, over all instants [MPa]. */
double mean_tension(const std::string &folder, const std::string &body)
{
  const Table              table = read_result_table(folder + "/root_stress.csv");
  std::map<double, double> largest;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    if (table.column("body").texts[i] == body)
      {
        double &known = largest[table.columns().front().numbers[i]];
        raise_to(known, table.numbers("tension")[i]);
      }
  double sum = 0.;
  for (const auto &one : largest)
    sum += one.second;
  return sum / largest.size();
}

/** Over the largest stress, of the teeth that both have. */
double difference(const Stresses &a, const Stresses &b)
{
  double found = 0.;
  for (const auto &[tooth, stress] : a)
    if (const auto other = b.find(tooth); other != b.end())
      raise_to(found,
               std::max(std::abs(stress.first - other->second.first),
                        std::abs(stress.second - other->second.second)));
  return found / std::max(largest_tension(b, "pinion"), largest_tension(b, "gear"));
}

void do_case(const std::string       &kind,
             const std::string       &folder,
             const std::string       &more,
             std::vector<std::string> entries,
             Communicator            &world)
{
  std::ofstream(folder + ".prm")
    << quick_pair("set body type = conical web\nset hub fillet radius = 2 mm", coarse_web, "1e-6")
    << "subsection Study\n set kind = " << kind << "\nend\n"
    << more;
  if (kind != "loaded tooth contact analysis")
    entries.insert(entries.end(), {"Dynamics/start=static equilibrium"});
  run_pair(folder + ".prm", folder, world, entries);
}

int main(int argc, char **argv)
{
  MpiSession                     session(argc, argv);
  Communicator                   world(MPI_COMM_WORLD);
  const std::vector<std::string> submodels = {"Fillets/teeth=in contact",
                                              "Fillets/source=submodel",
                                              "Fillets/submodel elements along face width=4"};
  do_case("run", "run", gauge_of_gear, submodels, world);
  do_case("reduced", "reduced", gauge_of_gear, submodels, world);
  std::vector<std::string> one_position = submodels;
  one_position.insert(one_position.end(),
                      {"Loaded contact/positions=1", "Loaded contact/pressure cells=0"});
  do_case("loaded tooth contact analysis", "loaded", gauge_of_gear, one_position, world);
  one_position.back() = "Loaded contact/pressure cells=8";
  do_case("loaded tooth contact analysis", "grid", gauge_of_gear, one_position, world);
  do_case("loaded tooth contact analysis",
          "elements",
          gauge_of_gear,
          {"Fillets/teeth=in contact",
           "Loaded contact/positions=1",
           "Loaded contact/pressure cells=0"},
          world);

  const Stresses at_start = read_stresses("run"), loaded = read_stresses("loaded");
  check("run: teeth in mesh", at_start.size() >= 8);
  check_below("start of the run and loaded analysis", difference(at_start, loaded), .003);
  check_below("start of the reduced pair and loaded analysis",
              difference(read_stresses("reduced"), loaded),
              .003);
  for (const std::string body : {"pinion", "gear"})
    {
      check_close(body + ": mean tension of run and reduced pair [MPa]",
                  mean_tension("run", body),
                  mean_tension("reduced", body),
                  .05 * mean_tension("reduced", body));
      // On these coarse flanks pressures on their own grid lie elsewhere.
      check_close(body + ": tension under pressures on their own grid [MPa]",
                  largest_tension(read_stresses("grid"), body),
                  largest_tension(loaded, body),
                  .25 * largest_tension(loaded, body));
      check_below(body + ": tension by elements of the mesh over that by submodels",
                  largest_tension(read_stresses("elements"), body) / largest_tension(loaded, body),
                  .5);
    }
  for (const std::string fillet : {"gear hub front", "gear hub back"})
    for (const char *folder : {"run", "reduced"})
      check_close(fillet + ": tension, " + folder + " [MPa]",
                  largest_tension(read_stresses(folder), fillet),
                  largest_tension(loaded, fillet),
                  .01 * largest_tension(loaded, fillet));
  const auto strain = [](const std::string &folder) {
    return read_columns(folder + "/gauges.csv").at("strain").front();
  };
  check_close("gauge, run [um/m]",
              strain("run"),
              strain("loaded"),
              .01 * std::abs(strain("loaded")));
  check_close("gauge, reduced pair [um/m]",
              strain("reduced"),
              strain("loaded"),
              .01 * std::abs(strain("loaded")));
  return 0;
}
