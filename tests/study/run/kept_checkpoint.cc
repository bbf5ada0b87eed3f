// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Runs go on from checkpoints of other versions of the program: from one that is kept beside this
// test (kept_checkpoint/model.prm says how it was written), and from ones that know other entries
// and other parts than this version does.
#include "../../refusal.h"
#include "../forged_checkpoint.h"
#include "../history_difference.h"
#include "../quick_pair.h"

#include <vfife/base/text/byte_stream.h>

using namespace vfife;

const std::string kept_folder = source_folder() + "/kept_checkpoint/";
const std::string kept        = kept_folder + "checkpoint.bin";
// Of 16 mm, with cells of 4 mm and all three bodies.
const histories::Bodies bodies = {49., 4., 9e-6};

/** The log of the run, or the message that ends it, without this folder's name. */
std::string go_on(const std::string              &folder,
                  const std::vector<std::string> &overrides,
                  Communicator                   &communicator,
                  const bool                      restart = true)
{
  std::string message = message_of(
    [&] { run_case(kept_folder + "model.prm", folder, communicator, overrides, restart); });
  for (std::size_t at; (at = message.find(kept_folder)) != std::string::npos;)
    message.erase(at, kept_folder.size());
  return message.empty() ? read_text(folder + "/run.log") : message;
}

/** The first part of a checkpoint: who wrote it, and its entries. */
struct Origin
{
  std::string                                      version;
  std::vector<std::pair<std::string, std::string>> parameters;
  std::size_t                                      log_size = 0;

  void pass(ByteStream &stream)
  {
    stream.pass(version, parameters, log_size);
  }
};

/** Of a checkpoint's state: it is that of another version, with what @p change makes of it. */
void change_origin(std::string &state, const std::function<void(Origin &)> &change)
{
  change_part(state, "origin", [&](std::string &bytes) {
    Origin     origin;
    ByteStream in(bytes), out;
    origin.pass(in);
    origin.version = "0.0.0 (another)";
    change(origin);
    origin.pass(out);
    bytes = out.bytes();
  });
}

/** The kept checkpoint as one with other entries; the name @p set is added to those that were not
 * at their defaults. */
void forge_entries(
  const std::string                   &folder,
  const std::function<void(Origin &)> &change = [](Origin &) {},
  const std::string                   &set    = "")
{
  forge_checkpoint(kept, folder, [&](std::string &state) {
    change_origin(state, change);
    change_part(state, "set parameters", [&](std::string &bytes) {
      std::vector<std::string> names;
      ByteStream               in(bytes), out;
      in.pass(names);
      if (!set.empty())
        names.push_back(set);
      out.pass(names);
      bytes = out.bytes();
    });
  });
}

using ChangeRun = std::function<void(std::string &common, std::vector<std::string> &own)>;

/** Changes what all ranks know of a run, and what each one knows. */
void change_run(std::string &state, const ChangeRun &change)
{
  change_part(state, "run", [&](std::string &bytes) {
    std::string              common;
    std::vector<std::string> own;
    ByteStream               in(bytes), out;
    in.pass(common, own);
    change(common, own);
    out.pass(common, own);
    bytes = out.bytes();
  });
}

/** The same with another part of the solver's. */
void forge_solver(const std::string &folder, const ChangeRun &change)
{
  forge_checkpoint(kept, folder, [&](std::string &state) {
    change_origin(state, [](Origin &) {});
    change_run(state, [&](std::string &common, std::vector<std::string> &own) {
      change_part(common, "solver", [&](std::string &solver) { change(solver, own); });
    });
  });
}

std::string line_with(const std::string &text, const std::string &words)
{
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (has_text(line, words))
      return line;
  return "no line with \"" + words + "\"";
}

void keep_going(Communicator &world)
{
  go_on("whole", {}, world, false);
  forge_entries("kept");
  const std::string said = go_on("kept", {}, world);
  check("the kept checkpoint is of a step on the way",
        has_text(line_with(said, "continues from"), ", step 150"));
  const Table whole = read_result_table("whole/history.csv"),
              parts = read_result_table("kept/history.csv");
  // From the sample after the checkpoint on: earlier ones are those that it holds.
  histories::check_same("kept", parts, whole, bodies, {11});
  // All that the model is to have in it.
  const auto last = [&](const std::string &name) { return whole.numbers(name).back(); };
  check("it presses, pulls, slides and turns",
        last("face contact force z") > 1000 && last("face contact force x") < -100 &&
          last("floor contact force x") < -10 && last("contact loss") > 0 &&
          std::abs(last("holder reaction force x")) > 0.1 && last("damping loss") > 0 &&
          last("angular momentum z") > 0);
}

/** A checkpoint that is written before the first step after another one knows as much. */
void write_at_once(Communicator &world)
{
  forge_entries("at_once");
  const std::string before = read_text("at_once/checkpoint.bin");
  go_on("at_once", {"Dynamics/maximum number of steps=150"}, world);
  check("written at once", read_text("at_once/checkpoint.bin") != before);
  go_on("at_once", {}, world);
  histories::check_same("at once",
                        read_result_table("at_once/history.csv"),
                        read_result_table("whole/history.csv"),
                        bodies,
                        {11});
}

/** Equal runs write equal checkpoints, apart from the time that they took and how much they have
 * said of it. */
void write_equal_bytes(Communicator &world)
{
  const auto state_of = [&](const std::string &folder) {
    go_on(folder, {"Dynamics/maximum number of steps=150"}, world, false);
    std::string state = read_text(folder + "/checkpoint.bin").substr(checkpoint_header);
    change_origin(state, [](Origin &origin) { origin.log_size = 0; });
    change_run(state, [](std::string &common, std::vector<std::string> &) {
      change_part(common, "wall time", [](std::string &time) { time.clear(); });
    });
    return state;
  };
  check("equal runs: equal checkpoints", state_of("one") == state_of("other"));
}

void younger_entry(Communicator &world)
{
  const std::string younger = "Model/Contact face/tangential stiffness ratio";
  forge_entries("younger", [&](Origin &origin) {
    auto      &all  = origin.parameters;
    const auto gone = std::remove_if(all.begin(), all.end(), [&](const auto &entry) {
      return entry.first == younger;
    });
    check("an entry is taken out", all.end() - gone == 1);
    all.erase(gone, all.end());
  });
  // Refused first: the run that is not would write its own checkpoint.
  std::cout << go_on("younger", {younger + "=0.25"}, world) << std::endl;
  std::cout << go_on("younger", {"Model/Contact face/integration=implicit"}, world) << std::endl;
  std::cout << line_with(go_on("younger", {}, world), "the version of the start did not have")
            << std::endl;
  check("younger entry: same digits",
        read_text("younger/history.csv") == read_text("kept/history.csv"));
}

void entry_that_is_gone(Communicator &world)
{
  const std::string gone = "Dynamics/forgotten";
  const auto        add  = [&](Origin &origin) { origin.parameters.emplace_back(gone, "7"); };
  forge_entries("gone", add, gone);
  std::cout << go_on("gone", {}, world) << std::endl;
  std::cout << go_on("gone", {"Dynamics/mass proportional damping=400"}, world) << std::endl;
  // A checkpoint that does not say which entries were set: any may have been.
  forge_entries("gone", add);
  forge_checkpoint("gone/checkpoint.bin", "older", [](std::string &state) {
    state.replace(state.find("set parameters"), 14, "set_parameters");
  });
  std::cout << go_on("older", {}, world) << std::endl;
  std::cout << line_with(go_on("gone", {}, world), "at the start that this version") << std::endl;
  check("entry at its default: same digits",
        read_text("gone/history.csv") == read_text("kept/history.csv"));
}

/** What each rank knows is laid out as a version has it: that of another one is not read. */
void other_layout(Communicator &world)
{
  forge_solver("layout", [](std::string &solver, std::vector<std::string> &own) {
    own = {"another layout"};
    ByteStream more;
    more.pass_part("younger part", [](ByteStream &part) {
      double anything = 1;
      part.pass(anything);
    });
    solver += more.bytes();
  });
  go_on("layout", {}, world);
  check("other layout and unknown part: same digits",
        read_text("layout/history.csv") == read_text("kept/history.csv"));
}

/** Numbers of each node, from the checkpoint of a model with fewer of them. */
void fewer_nodes(Communicator &world)
{
  const auto shorten = [](const std::string &name, const std::uint64_t numbers) {
    forge_solver("fewer", [&](std::string &solver, std::vector<std::string> &) {
      change_part(solver, name, [&](std::string &part) {
        // The last numbers of the part, behind their count.
        const std::uint64_t before = numbers, after = numbers - 2;
        const std::size_t   at = part.size() - 8 * (numbers + 1);
        check(name + ": the numbers are found",
              part.compare(at, 8, reinterpret_cast<const char *>(&before), 8) == 0);
        part.replace(at, 8, reinterpret_cast<const char *>(&after), 8);
        part.resize(part.size() - 16);
      });
    });
  };
  // Angle and rate of every node of the model; six numbers of every node at the wall.
  shorten("constraints", 2 * (12 + 12 + 24));
  std::cout << go_on("fewer", {}, world) << std::endl;
  shorten("friction", 6 * 6);
  std::cout << go_on("fewer", {}, world) << std::endl;
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  for (const char *folder :
       {"whole", "kept", "younger", "gone", "older", "layout", "fewer", "at_once", "one", "other"})
    std::filesystem::remove_all(folder);
  keep_going(session.world());
  write_at_once(session.world());
  write_equal_bytes(session.world());
  younger_entry(session.world());
  entry_that_is_gone(session.world());
  other_layout(session.world());
  fewer_nodes(session.world());
  return 0;
}
