// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The text files of a run: folder, histories, log, summary.
#include "../model_parts.h"
#include "../read_files.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/summary.h>
#include <vfife/output/folder/file_list.h>
#include <vfife/output/folder/folder_lock.h>
#include <vfife/output/observers/history_writer.h>
#include <vfife/output/observers/probe_writer.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/output/observers/teeth_writer.h>
#include <vfife/output/output_options.h>

#include <deal.II/base/parameter_handler.h>

#include <chrono>
#include <filesystem>
#include <limits>
#include <thread>

using namespace vfife;

const std::string folder_name = "run_files_results";

Model make_pair_model()
{
  Model model;
  for (const char *name : {"pinion", "gear"})
    model.add_body(Body(name, make_block({1, 1, 1}, {{1, 1, 1}}), Material()));
  Transmission pair;
  pair.driver         = 0;
  pair.driven         = 1;
  pair.driver_teeth   = 27;
  pair.driven_teeth   = 79;
  pair.driver_rate    = 20000 * pi / 30;
  model.transmissions = {pair};
  model.contacts.push_back(contact_of("drive", {0, ""}, {1, ""}));
  model.contacts.push_back(contact_of("coast", {1, ""}, {0, ""}));
  model.probes.push_back({"node A", 1, 0});
  return model;
}

State make_state()
{
  State state;
  state.time                         = 0.25e-3;
  state.step                         = 40;
  state.measured.driver_angle        = pi / 4;
  state.measured.driven_angle        = pi / 180;
  state.measured.transmission_error  = -35.5 * arcsecond;
  state.measured.contact_force       = 8918;
  state.measured.contact_torque      = 800e3;
  state.measured.teeth_in_contact    = 2;
  state.measured.largest_penetration = 0.0015;
  state.measured.energy.strain       = 12.5;
  state.measured.energy.scale        = 25;
  ToothContact tooth;
  tooth.slave_group  = 3;
  tooth.master_group = 77;
  tooth.force        = Vector3(3, 0, 4);
  tooth.torque       = 2000;
  tooth.normal_force = 6;
  tooth.area         = 2;
  state.measured.teeth.push_back(tooth);
  tooth.contact = 1;
  state.measured.teeth.push_back(tooth);
  ProbeValue probe;
  probe.displacement = Vector3(0.001, 0.002, 0.003);
  probe.von_mises    = 21;
  probe.stress       = {{1, 2, 3, 4, 5, 6}};
  state.measured.probes.push_back(probe);
  return state;
}

void check_histories(const OutputFolder &folder)
{
  const Model   model = make_pair_model();
  State         state = make_state();
  HistoryWriter history(folder, model, 20);
  TeethWriter   teeth(folder, model, 20);
  ProbeWriter   probes(folder, 20);
  check("due at multiples of the interval",
        history.due(state) && teeth.due(state) && probes.due(state));
  Observer *const observers[] = {&history, &teeth, &probes};
  for (Observer *observer : observers)
    observer->observe(model, state);
  state.step = 41;
  check("not due in between", !history.due(state) && !teeth.due(state) && !probes.due(state));
  for (Observer *observer : observers)
    {
      observer->observe(model,
                        state); // as the solver does with the last state: no row off the grid
      observer->finish(model, state);
    }
  std::cout << read_text(folder.file("history.csv")) << read_text(folder.file("teeth.csv"))
            << read_text(folder.file("probes.csv"));
  check("history stays in memory",
        history.table().n_rows() == 1 && history.table().numbers("dte")[0] < -35.4);

  const Model   free_model;
  HistoryWriter other(folder, free_model, 1);
  std::cout << other.table().csv_header() << std::endl;
}

void check_folder(const Communicator &communicator, const OutputFolder &folder)
{
  folder.write_file("a file", [](std::ostream &out) { out << "text"; });
  check("file in place", read_text(folder.file("a file")) == "text");
  check("no temporary file is left", !std::filesystem::exists(folder.file("a file.part")));
  for (const std::string &path :
       {folder.file("a file"), folder.file("a file") + "/below", std::string()})
    print_refusal<std::exception>([&] { OutputFolder(path, communicator); });
}

void check_parameters(OutputFolder &folder)
{
  dealii::ParameterHandler prm;
  double                   speed = 0, factor = 2;
  std::string              remark = "a \"word\" [mm] or two";
  declare_text(prm, "remark", remark, "What is seen");
  prm.enter_subsection("Operation");
  declare_quantity(prm, "speed", speed, "rpm", "Speed of the pinion");
  declare_number(prm, "factor", factor, "Of the load");
  prm.set("speed", "20000 rpm");
  prm.leave_subsection();
  folder.write_parameters(prm, "case.prm");

  const auto json = nlohmann::ordered_json::parse(read_text(folder.file("parameters.json")));
  check("parameters by path", json.size() == 3 && json.items().begin().key() == "remark");
  check("value, unit and default",
        json["Operation/speed"].dump() == R"({"value":"20000 rpm","unit":"rpm","default":"0"})");
  check("a number without dimension", json["Operation/factor"]["unit"] == "-");
  check("a text has no unit", json["remark"]["value"] == remark && json["remark"]["unit"] == "");
  check("the same parameters, readable again",
        has_text(read_text(folder.file("parameters.prm")), "20000 rpm") &&
          folder.parameters().size() == 3);
  check("the file they are from", folder.parameter_file() == "case.prm");
}

void check_log(const Communicator &communicator)
{
  std::ostringstream screen;
  Log                log(screen, true, Verbosity::quiet);
  log.line("before");
  {
    OutputFolder folder(folder_name, communicator);
    folder.attach_log(log);
    log.line("during");

    const Model model = make_pair_model();
    State       state = make_state();
    state.dt          = state.time / state.step;
    ProgressLine progress(log, communicator, 0, 1e-3, 4e-3, 10);
    progress.observe(model, state);
    progress.finish(model, state);
    state.step += 200;
    progress.observe(model, state);
    // At the end, to rounding, nothing is left, and the last line stands alone.
    state.time = 1e-3 * (1 - 1e-12);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    progress.observe(model, state);
    progress.finish(model, state);
  }
  log.line("after");
  const std::string text = read_text(folder_name + "/run.log");
  check("log has the lines of the folder's life",
        text.rfind("before\nduring\n", 0) == 0 && !has_text(text, "after"));
  check("progress in the log", has_text(text, " 25 %  0.250 ms  mesh cycle 2.2  step 40"));
  const std::size_t last = text.find("100 %  1.000 ms");
  check("one line of the end, without time left",
        last != std::string::npos && text.find("100 %", last + 1) == std::string::npos &&
          text.find("left", last) == std::string::npos);
  check("expected time of the whole run and of its part",
        has_text(text, " ms (mean of the first 200); ") &&
          has_text(text, "the whole run of 640 steps takes about ") &&
          has_text(text, "this part of 160 steps takes about "));
  check("quiet screen", screen.str().empty());
  std::cout << duration_text(41.2) << ", " << duration_text(125) << ", "
            << duration_text(3 * 3600 + 12 * 60) << ", "
            << duration_text(std::numeric_limits<double>::quiet_NaN()) << std::endl;
}

void check_options()
{
  OutputOptions      options;
  const Transmission pair = *make_pair_model().only_transmission();
  check_close("mesh frequency", pair.mesh_frequency(), 9000, 1e-9);
  options.history_every = 50;
  options.fields_every  = 2;
  const double dt       = 1. / 9000 / 2000.5;
  check("steps between samples", options.compute_history_steps(&pair, dt) == 40);
  check("fields at samples", options.compute_field_steps(&pair, dt) == 4000);
  check("exact multiple", options.compute_history_steps(&pair, 1. / 9000 / 50) == 1);
  check("long steps", options.compute_history_steps(&pair, 1. / 9000 / 7) == 1);
  check("without a gear pair", options.compute_history_steps(nullptr, dt) == 50);
  options.fields_every = .1;
  check("ten fields a mesh cycle", options.compute_field_steps(&pair, dt) == 200);
  print_refusal([&] { options.compute_field_steps(nullptr, dt); });
  options.fields_every = 0;
  check("no fields", options.compute_field_steps(&pair, dt) == 0);
}

void check_summary(const OutputFolder &folder)
{
  RunSummary summary;
  summary.study              = "run";
  summary.bodies             = {{"pinion", 1000, 1200, 1e-3, 2., 2094.4},
                                {"gear", 3000, 4000, 5e-3, 40., -715.8}};
  summary.steps              = 500;
  summary.run_time           = 4;
  summary.dt                 = 5e-8;
  summary.figures            = {{"torque", {800, "N m"}}, {"lever arm", {89.7, "mm"}}};
  summary.transmission_error = {{"wind-up", {std::numeric_limits<double>::quiet_NaN(), "arcsec"}}};
  summary.damping            = {{"gear", 2000, 5e6, pi / 30}};
  summary.warnings           = {"a \"quoted\" warning \xff"};
  EnergyLedger ledger;
  ledger.strain  = 3;
  ledger.scale   = 6;
  summary.energy = ledger;
  SteadyPart part;
  part.found     = true;
  part.columns   = {{"dte", "arcsec", -35.7, 2.5, 0.4}};
  summary.steady = part;
  write_summary(folder, summary);

  const auto json = nlohmann::ordered_json::parse(read_text(folder.file("summary.json")));
  check("status", json["status"] == "finished" && !json.contains("failure"));
  check("mesh", json["mesh"]["cells"] == 4000 && json["mesh"]["bodies"][1]["nodes"] == 4000);
  check_ratio("mass [kg]", json["mesh"]["bodies"][0]["mass"]["value"], 1e-12);
  check_close("inertia [kg m^2]", json["mesh"]["bodies"][1]["axial inertia"]["value"], 0.04, 1e-12);
  check_close("element-steps", json["run"]["element-steps per second"]["value"], 500000, 1e-6);
  check("figures keep order and units",
        json["figures"].begin().key() == "torque" && json["figures"]["torque"]["unit"] == "N m");
  check("not a number is null", json["transmission error"]["wind-up"]["value"].is_null());
  check_close("energy error", json["energy"]["error"]["value"], 0.5, 1e-12);
  check_close("damping power [W]", json["damping audit"][0]["power"]["value"], 5000, 1e-9);
  check_ratio("drift of rotation speed [rpm]",
              json["damping audit"][0]["drift of rotation speed"]["value"],
              1e-12);
  check_close("mean", json["steady part"]["columns"]["dte"]["mean"], -35.7, 0);

  summary.status  = "failed";
  summary.failure = "energy error 0.6 at step 12";
  check("failure", nlohmann::json::parse(make_summary_text(summary))["failure"] == summary.failure);
}

void check_lock(const Communicator &communicator)
{
  namespace fs = std::filesystem;
  std::ostringstream screen;
  Log                log(screen, true, Verbosity::quiet);
  const std::string  made = folder_name + "/a/b";
  {
    const FolderLock lock(made, "one.prm", communicator, log);
    check("a folder is made for its lock", fs::exists(made + "/vfife.lock"));
    check("in use", is_in_use(folder_name + "/./a/b"));
    check("once more in the same process",
          has_text(message_of(
                     [&] { FolderLock(folder_name + "/a/../a/b", "two.prm", communicator, log); }),
                   "is in use (process "));
  }
  check("not in use any more", !is_in_use(made));
  check("folders without results are removed", !fs::exists(folder_name + "/a"));
  check("not where there is nothing", !is_in_use(made));
}

/** Results are what the list names; all others are a user's files. */
void check_list()
{
  const std::string other = folder_name + "/other";
  std::filesystem::create_directories(other + "/modes");
  std::ofstream(other + "/history.csv") << "time";
  FileList list(other);
  check("nothing without a list", list.names().empty());
  list.add("modes/gear.vtu");
  list.add("modes/pinion.vtu");
  check("with the list that is begun",
        FileList(other).names() == std::set<std::string>{"files.txt", "modes/"});
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all(folder_name);
  {
    OutputFolder folder(folder_name, session.world());
    check_histories(folder);
    check_folder(session.world(), folder);
    check_parameters(folder);
    check_summary(folder);
  }
  check_log(session.world());
  check_options();
  check_lock(session.world());
  check_list();
  return 0;
}
