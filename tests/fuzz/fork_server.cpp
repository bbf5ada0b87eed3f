// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The program as often as asked without loading its libraries each time: what contrib/fuzz runs
// thousands of times takes 0.4 s to load and some hundredths of a second to refuse its input.
//
// A job is a line of words on standard input: seconds of processor time, bytes of address space,
// folder to run in, files for standard output and standard error, arguments; all texts as pairs of
// hexadecimal digits. Each job runs in a child of its own. The answer is "exit CODE" or
// "signal NUMBER".
#include <vfife/base/process/failure.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/study/program.h>

#include <csignal>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
  struct Job
  {
    unsigned int             seconds = 0;
    std::size_t              bytes   = 0;
    std::string              folder, output, errors;
    std::vector<std::string> arguments;
  };

  /** "-" is the empty text. */
  std::string decode(const std::string &digits)
  {
    std::string text;
    for (std::size_t i = 0; digits != "-" && i + 1 < digits.size(); i += 2)
      text += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    return text;
  }

  Job read_job(const std::string &line)
  {
    std::istringstream words(line);
    Job                job;
    words >> job.seconds >> job.bytes;
    std::vector<std::string> texts;
    for (std::string word; words >> word;)
      texts.push_back(decode(word));
    job.folder = texts.at(0);
    job.output = texts.at(1);
    job.errors = texts.at(2);
    job.arguments.assign(texts.begin() + 3, texts.end());
    return job;
  }

  void limit(const int what, const rlim_t value)
  {
    const rlimit limits = {value, value};
    setrlimit(what, &limits);
  }

  /** What main() does with its arguments, within the job's limits. */
  int run(const Job &job, vfife::MpiSession &session)
  {
    // A child that waits without computing ends too.
    alarm(10 * job.seconds);
    limit(RLIMIT_CPU, job.seconds);
    limit(RLIMIT_AS, job.bytes);
    if (chdir(job.folder.c_str()) != 0 || std::freopen("/dev/null", "r", stdin) == nullptr ||
        std::freopen(job.output.c_str(), "w", stdout) == nullptr ||
        std::freopen(job.errors.c_str(), "w", stderr) == nullptr)
      return 125;
    std::vector<const char *> argv = {"vfife"};
    for (const std::string &argument : job.arguments)
      argv.push_back(argument.c_str());
    argv.push_back(nullptr);

    vfife::Failure failure;
    try
      {
        vfife::run_program(argv.size() - 1, argv.data(), session.world());
      }
    catch (...)
      {
        failure = vfife::describe_failure(std::current_exception());
      }
    const int code = session.finish(failure);
    std::cout.flush();
    return code;
  }
} // namespace

int main(int argc, char **argv)
{
  vfife::MpiSession session(argc, argv);
  limit(RLIMIT_CORE, 0);
  std::string line;
  while (std::getline(std::cin, line))
    {
      const Job   job   = read_job(line);
      const pid_t child = fork();
      if (child == 0)
        {
          setpgid(0, 0);
          _exit(run(job, session));
        }
      int status = 0;
      waitpid(child, &status, 0);
      kill(-child, SIGKILL); // what the job has started and left behind
      if (WIFSIGNALED(status))
        std::cout << "signal " << WTERMSIG(status) << std::endl;
      else
        std::cout << "exit " << WEXITSTATUS(status) << std::endl;
    }
  return 0;
}
