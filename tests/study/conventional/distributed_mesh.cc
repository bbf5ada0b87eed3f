// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Fem/distributed in the kinds linear static and modal: results and files as without it; what is
// refused.
#include "../../model_sections.h"
#include "../../ranks.h"
#include "../../read_files.h"
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/output/files/run_figures.h>

#include <filesystem>

using namespace vfife;

struct Text
{
  std::string kind    = "linear static";
  std::string bodies  = "bar";
  std::string body    = "";
  std::string entries = "set loads = pull\nset probes = tip\n";
  std::string clamp   = "set kind = fixed\nset nodes = x-\n";
  std::string more = model_text::section("Load pull", "set nodes = x+\nset force = 9, 8, 7 N\n") +
                     model_text::probe("tip", "20, 5, 5 mm");
  std::string fem   = "set element type = quadratic\nset local refinement = x- 1\n";
  std::string other = "";

  std::string write(const bool is_distributed) const
  {
    return "subsection Study\n set kind = " + kind + "\nend\nsubsection Model\n" +
           "set bodies = " + bodies + "\nset constraints = clamp\n" + entries +
           model_text::block("bar", {{20, 5, 5}}, {{4, 1, 1}}, body) +
           model_text::section("Constraint clamp", clamp) + more + "end\nsubsection Fem\n" +
           (is_distributed ? "set distributed = yes\n" : "") + fem + "end\n" +
           "subsection Output\n set report = no\n set verbosity = quiet\nend\n" + other;
  }
};

void run(const std::string &name, const std::string &text, Communicator &world)
{
  if (world.is_root())
    std::ofstream(name + ".prm") << text;
  world.barrier();
  run_pair(name + ".prm", name, world);
}

double largest_difference(const Table &one, const Table &two, const std::string &column)
{
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < two.n_rows(); ++i)
    {
      raise_to(worst, std::abs(one.numbers(column)[i] - two.numbers(column)[i]));
      largest = std::max(largest, std::abs(two.numbers(column)[i]));
    }
  return worst / largest;
}

void statics(Communicator &world)
{
  for (const bool is_distributed : {true, false})
    run(is_distributed ? "bar" : "bar_direct", Text().write(is_distributed), world);
  if (!world.is_root())
    return;
  const Table one = read_result_table("bar/history.csv"),
              two = read_result_table("bar_direct/history.csv");
  for (const char *column : {"tip displacement x", "tip displacement z", "strain energy"})
    check_below(column, largest_difference(one, two, column), 1e-8);
  check_below("tip stress", largest_difference(one, two, "tip von mises"), 1e-7);
  check_below("reaction",
              largest_difference(read_result_table("bar/reactions.csv"),
                                 read_result_table("bar_direct/reactions.csv"),
                                 "force y"),
              1e-8);
  for (const char *figure : {"strain energy", "largest displacement", "largest von mises"})
    {
      const std::string name = std::string("/figures/") + figure + "/value";
      check_ratio(figure,
                  read_figure("bar/summary.json", name) /
                    read_figure("bar_direct/summary.json", name),
                  1e-7);
    }
  for (const char *file : {"bar.vtu", "bar.pvtu", "bar_0.vtu"})
    check(std::string("file ") + file, std::filesystem::exists(std::string("bar/fields/") + file));
  check("a file per rank",
        std::filesystem::exists("bar/fields/bar_" + std::to_string(world.size() - 1) + ".vtu"));
}

void modes(Communicator &world)
{
  Text text;
  text.kind = "modal";
  text.fem += "set modes = 3\nset eigenvalue tolerance = 1e-8\n";
  for (const bool is_distributed : {true, false})
    run(is_distributed ? "modes" : "modes_direct", text.write(is_distributed), world);
  if (!world.is_root())
    return;
  check_below("frequencies",
              largest_difference(read_result_table("modes/modes.csv"),
                                 read_result_table("modes_direct/modes.csv"),
                                 "frequency"),
              1e-8);
  check("the log says that modes are not counted",
        has_text(read_text("modes/run.log"), "modes are not counted, so that one may be missing"));
  check("shapes on the whole mesh", std::filesystem::exists("modes/modes/bar_0_rpm.pvtu"));
}

void refusals(Communicator &world)
{
  const auto refuse = [&](const Text &text) {
    print_refusal([&] { run("refused", text.write(true), world); });
  };
  const auto fem = [](const std::string &entry, const std::string &kind = "linear static") {
    Text text;
    text.kind = kind;
    text.fem += entry;
    return text;
  };
  Text text;
  text.fem = "";
  refuse(text);
  refuse(fem("set cyclic symmetry = yes\n", "modal"));
  refuse(fem("set hold hubs = yes\n"));
  refuse(fem("set coriolis = yes\n", "modal"));
  refuse(fem("set speeds = 100 rpm\n", "modal"));
  text       = Text();
  text.other = "subsection Linear static\n subsection Adaptive refinement\n"
               "  set result = strain energy\n end\nend\n";
  refuse(text);
  for (const char *kind : {"free rotation", "rigid hub"})
    {
      text       = Text();
      text.clamp = std::string("set kind = ") + kind + "\nset nodes = x-\n";
      refuse(text);
    }
  text       = Text();
  text.clamp = "set kind = spring\nset stiffness = 1, 1, 1 N/mm\nset nodes = x-\n";
  refuse(text);
  text        = Text();
  text.bodies = "bar, other";
  text.clamp += "set body = bar\n";
  text.more =
    model_text::section("Load pull", "set body = bar\nset nodes = x+\nset force = 9, 8, 7 N\n") +
    model_text::section("Probe tip", "set body = bar\nset point = 20, 5, 5 mm\n") +
    model_text::block("other", {{5, 5, 5}}, {{1, 1, 1}});
  refuse(text);
  text       = Text();
  text.clamp = "set kind = displacement\nset directions = x\nset nodes = x-\n";
  refuse(text);
  text      = Text();
  text.body = "set rotating = yes\nset rotational speed = 100 rad/s\n";
  text.more = model_text::section("Load pull", "set nodes = x+\nset force = 0, 0, 7 N\n") +
              model_text::probe("tip", "20, 5, 5 mm");
  refuse(text);
  text       = Text();
  text.body  = "set temperature = 100\n";
  text.other = "subsection Material steel\n set thermal expansion = 1e-5 1/K\nend\n";
  refuse(text);
}

int main(int argc, char **argv)
{
  TestRanks ranks(argc, argv);
  for (const auto part : {statics, modes, refusals})
    part(ranks.session.world());
  return 0;
}
