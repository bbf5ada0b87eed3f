// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A run whose step is too long, because the bound of the assembly was given wrong: it goes back to
// a state before and on with two steps in the place of one; samples stay where they were.
#include "../../model/model_text.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/operator/step_bound.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/observers/history_writer.h>
#include <vfife/output/output_options.h>
#include <vfife/study/run/explicit_stepping.h>
#include <vfife/study/run/run_start.h>
#include <vfife/study/run/start_kinds.h>
#include <vfife/study/run/stepped_solver.h>

using namespace vfife;

constexpr std::uint64_t n_steps = 8000, sample_steps = 100;
constexpr double        limit = 1.62e-7; ///< stable step of the block, about [s]

/** A block that is stretched slowly, by 0.1 MPa in @p end_time: more
 * would lower its frequencies by more than the step is too long. */
Model make_stretched_block(const double end_time)
{
  std::ostringstream text;
  text << "subsection Model\nset bodies = block\nset loads = left, right\nset probes = end\n"
       << model_text::block("block", {{5, 2, 2}}, {{5, 2, 2}});
  for (const std::string side : {"left", "right"})
    text << "subsection Load " << side << "\nset nodes = " << (side == "left" ? "x-" : "x+")
         << "\nset force = " << (side == "left" ? -0.4 : 0.4) << ", 0, 0 N\nset history = t < "
         << end_time << " ? 0.5*(1 - cos(pi*t/" << end_time << ")) : 1\nend\n";
  text << "subsection Probe end\nset point = 0, 0, 0 mm\nset axes = x, y, z\nend\nend\n";
  return make_model(text.str());
}

struct Result
{
  Columns                  history;
  std::vector<std::string> warnings;
  unsigned int             n_substeps = 0;
};

/** Runs with steps of @p part of the largest stable one, as the exact frequency has it. */
Result run(const std::string &name, const double part, Communicator &world)
{
  Model           model = make_stretched_block(500 * limit);
  DynamicsOptions options;
  options.damping    = 0;
  options.step_bound = StepBound::assembly;
  OutputFolder       folder(name, world);
  std::ostringstream nothing;
  Log                log(nothing, true, Verbosity::quiet);
  OutputOptions      output;
  output.checkpoint_every = 0;

  SteppedSolver stepped(model, options, world, log, [](const double stable) { return stable; });
  // Lanczos' method takes all vectors of so small a model: the Ritz value is the frequency.
  const auto frequency =
    bound_largest_frequency(model, stepped.solver.vfife_operator(), world).ritz_value;
  const double dt = part * 2 / std::sqrt(frequency);
  stepped.solver.set_step(dt);
  const auto       start    = make_start({model, options, stepped.solver, nullptr, world, log});
  const double     end_time = n_steps * dt;
  ExplicitStepping stepping({folder, log, model, output, {sample_steps, end_time, end_time}},
                            stepped.solver,
                            *start);
  stepping.observers().add<HistoryWriter>(model, sample_steps);
  stepping.run(
    nullptr, [] {}, [] {});

  Result result;
  result.history = read_columns(name + "/history.csv");
  for (const Log::Warning &warning : log.warnings())
    result.warnings.push_back(warning.text);
  result.n_substeps = stepped.solver.n_substeps();

  // What the checkpoint of such a run says.
  ByteStream common, own;
  State      last = stepping.state();
  stepped.solver.serialize(common, &own, last);
  SteppedSolver other(model, options, world, log, [dt](const double) { return dt; });
  State         state;
  other.solver.start(state);
  ByteStream back(common.bytes());
  other.solver.serialize(back, nullptr, state);
  check(name + ": a checkpoint knows of them", other.solver.n_substeps() == result.n_substeps);
  return result;
}

int main(int argc, char **argv)
{
  MpiSession    session(argc, argv);
  Communicator &world = session.world();

  const Result stable = run("stable", 0.99, world);
  check("stable: one step in the place of one", stable.n_substeps == 1 && stable.warnings.empty());

  // Beyond the limit by the part d a mode grows by the factor 1 + sqrt(8 d) in each step.
  const Result mended = run("mended", 1 + 1e-5, world);
  check("mended: two steps in the place of one", mended.n_substeps == 2);
  check("mended: one warning", mended.warnings.size() == 1);
  if (argc > 1 && !mended.warnings.empty())
    std::cerr << mended.warnings[0] << std::endl;
  const std::string text = mended.warnings.empty() ? "" : mended.warnings[0];
  check("mended: not from the beginning",
        has_text(text, "restarting at ") && !has_text(text, "step 0,"));

  const auto &time = mended.history.at("time");
  double      gap  = 0;
  for (std::size_t i = 1; i < time.size(); ++i)
    raise_to(gap, std::abs((time[i] - time[i - 1]) / time[1] - 1));
  check("mended: all samples", time.size() == n_steps / sample_steps + 1);
  check_below("mended: samples at equal distances", gap, 1e-9);
  check_below("mended: energy error", largest_size(mended.history.at("energy error")), 1e-3);
  check_ratio("mended: displacement of the end over F L/(2 E A)",
              mended.history.at("end displacement x").back() / (-0.5 * 5 * 0.1 / 206000),
              0.02);
  return 0;
}
