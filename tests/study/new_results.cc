// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Studies one after the other in one folder: what an earlier one has left does not pass for the
// results of one that fails, whatever their kinds.
#include "../model_sections.h"
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/errors.h>
#include <vfife/base/process/mpi_session.h>

#include <nlohmann/json.hpp>

#include <filesystem>

using namespace vfife;

namespace
{
  const std::string folder = "new_results_folder";

  const std::string model =
    "subsection Model\n set bodies = bar\n set constraints = foot\n set loads = pull\n" +
    model_text::block("bar", {{100, 10, 10}}, {{10, 2, 2}}) +
    "subsection Constraint foot\n set kind = fixed\n set nodes = x-\nend\n"
    "subsection Load pull\n set kind = force\n set nodes = x+\n set force = 1000, 0, 0 N\nend\n"
    "end\n";

  /** "done", or which of the two errors has ended the study. */
  std::string run(const std::string &kind, const std::string &more, Communicator &world)
  {
    std::ofstream("new_results.prm") << "subsection Study\n  set kind = " << kind << "\nend\n"
                                     << model << more;
    try
      {
        run_pair("new_results.prm", folder, world);
      }
    catch (const InputError &)
      {
        return "input error";
      }
    catch (const NumericalError &)
      {
        return "numerical error";
      }
    return "done";
  }

  nlohmann::json read_summary()
  {
    return nlohmann::json::parse(std::ifstream(folder + "/summary.json"));
  }

  bool has(const std::string &file)
  {
    return std::filesystem::exists(folder + "/" + file);
  }
} // namespace

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all(folder);
  const std::string quiet = "subsection Output\n  set pictures = no\nend\n";
  const auto        fem   = [](const std::string &entry) {
    return "subsection Fem\n  set " + entry + "\nend\n";
  };

  check("linear static", run("linear static", quiet, session.world()) == "done");
  nlohmann::json summary = read_summary();
  check("the summary says that it has finished", summary.at("status") == "finished");
  check("and of which file", summary.at("parameter file") == "new_results.prm");

  const std::string one_step = "subsection Dynamics\n  subsection Relaxation\n    set largest "
                               "number of steps = 1\n  end\nend\n";
  check("an equilibrium that is not reached",
        run("static", quiet + one_step, session.world()) == "numerical error");
  summary = read_summary();
  check("the summary says that it has failed", summary.at("status") == "failed");
  check("and why",
        summary.at("failure").get<std::string>().find("the equilibrium was not reached in 1") == 0);

  check("modal", run("modal", fem("modes = 4"), session.world()) == "done");
  check("modes are there", has("modes.json"));
  check("a mistake in the file", run("modal", fem("mode = 4"), session.world()) == "input error");
  check("it leaves the results alone", has("modes.json"));
  check("more modes than there are",
        run("modal", fem("modes = 5000"), session.world()) == "input error");
  check("no modes of the study before", !has("modes.json"));

  check("modal again", run("modal", fem("modes = 4"), session.world()) == "done");
  check("another kind", run("linear static", quiet, session.world()) == "done");
  check("the folder has its results alone", has("summary.json") && !has("modes.json"));
  return 0;
}
