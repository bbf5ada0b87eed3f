// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What main() is made of: the command line, what exceptions mean, exchange between ranks.

#include <vfife/base/process/command_line.h>
#include <vfife/base/process/failure.h>
#include <vfife/base/process/mpi_session.h>

#include <deal.II/base/exceptions.h>

#include "../refusal.h"
#include "../tests.h"

#include <new>
#include <sstream>

using namespace vfife;

CommandLine parse(std::vector<const char *> arguments)
{
  arguments.insert(arguments.begin(), "vfife");
  return parse_command_line(static_cast<int>(arguments.size()), arguments.data());
}

void refuse(const std::vector<const char *> &arguments)
{
  print_refusal([&] { parse(arguments); });
}

void check_command_line()
{
  const CommandLine line =
    parse({"a.prm", "-o", "out", "--set", "A/b=1 mm", "--set=C/d=-2", "--check"});
  check("file", line.parameter_file == "a.prm" && line.output_folder == "out");
  check("settings", line.overrides == std::vector<std::string>({"A/b=1 mm", "C/d=-2"}));
  check("switches", line.check && !line.print_parameters && !line.help && !line.version);
  check("help needs no file", parse({"--help"}).help && parse({"--version"}).version);
  const CommandLine again = parse({"--restart", "."});
  check("going on in a folder",
        again.restart && again.output_folder == "." && again.parameter_file == "./parameters.prm");
  check("going on with a file",
        parse({"a.prm", ".", "--restart"}).parameter_file == "a.prm" &&
          parse({"a.prm", "--restart"}).output_folder.empty());
  refuse({});
  refuse({"a.prm", "b.prm"});
  refuse({"a.prm", "--chek"});
  refuse({"a.prm", "--che"});
  refuse({"a.prm", "--set"});
  refuse({"a.prm", "-o", ""});
  // Longer than the name of a file may be.
  refuse({"a.prm", "--restart", std::string(300, 'x').c_str()});
}

template <typename Thrower>
void show(const Thrower &throw_it)
{
  Failure failure;
  try
    {
      throw_it();
    }
  catch (...)
    {
      failure = describe_failure(std::current_exception());
    }
  std::cout << failure.exit_code << " " << failure.message << std::endl;
}

void check_failures()
{
  show([] { throw InputError("Gear/Web", "too thin"); });
  show([] { throw NumericalError("step 3: energy grows"); });
  show([] { throw Interrupted("stopped at step 3"); });
  show([] { throw std::bad_alloc(); });
  show([] { AssertThrow(false, dealii::ExcMessage("deal.II says\n    two lines")); });
  show([] { AssertThrow(false, dealii::ExcInternalError()); });
  show([] { throw dealii::ExcInternalError(); });
  show([] { throw 3; });
  check("no failure", describe_failure(nullptr).exit_code == 0);
}

void check_exchange(const Communicator &world)
{
  const unsigned int        n = world.size(), me = world.rank();
  const double              rank_sum = n * (n - 1) / 2.;
  std::vector<double>       values   = {1. * me, 2. * me};
  std::vector<unsigned int> ranks, mine(me + 1, me);
  world.sum(values);
  for (unsigned int r = 0; r < n; ++r)
    ranks.insert(ranks.end(), r + 1, r);
  const std::vector<std::string> texts = world.all_gather(std::string(me, 'x'));

  // every rank checks, one speaks
  const bool sums =
    world.sum(1. * me) == rank_sum && values == std::vector<double>({rank_sum, 2. * rank_sum});
  const bool limits = world.max(1. * me) == n - 1. && world.min(me) == 0 && world.max(me) == n - 1;
  const bool flags  = world.any(me == 0) && world.all(me == 0) == (n == 1) && !world.any(false);
  const bool lists  = world.all_gather(mine) == ranks && world.all_gather(me).size() == n;
  const bool words  = texts.size() == n && texts[n - 1] == std::string(n - 1, 'x') &&
                     world.broadcast(me == n - 1 ? "last" : "", n - 1) == "last";
  const std::vector<bool> good = {
    world.all(sums), world.all(limits), world.all(flags), world.all(lists), world.all(words)};
  if (world.is_root())
    {
      check("sums over ranks", good[0]);
      check("smallest and largest over ranks", good[1]);
      check("conditions over ranks", good[2]);
      check("lists of all ranks", good[3]);
      check("texts of all ranks", good[4]);
    }
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  if (session.world().is_root())
    {
      check_command_line();
      check_failures();
    }
  check_exchange(session.world());

  // a failure of the last rank alone must reach all of them; stderr is caught, it would mix with
  // the output
  const Communicator &world = session.world();
  const bool          last  = world.rank() == world.size() - 1;
  std::ostringstream  messages;
  std::streambuf     *screen = std::cerr.rdbuf(messages.rdbuf());
  const int           code   = session.finish(last ? Failure{2, "step 3"} : Failure(), 60.);
  std::cerr.rdbuf(screen);
  const bool agreed      = world.all(code == 2),
             one_message = world.all(messages.str() == (last ? "vfife: step 3\n" : ""));
  if (world.is_root())
    {
      check("exit code of all ranks", agreed);
      check("message of the failing rank only", one_message);
    }
  return 0;
}
