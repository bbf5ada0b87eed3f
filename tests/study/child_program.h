// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_study_child_program_h
#define vfife_tests_study_child_program_h

#include "../read_files.h"
#include "../tests.h"

#include <vfife/base/process/failure.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/base/process/run_signals.h>
#include <vfife/study/program.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <functional>
#include <mpi.h>
#include <string>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

/** How a program has ended, and what it said on both streams. */
struct Ending
{
  int         exit_code = -1; ///< -1: killed by a signal
  std::string text;
};

/** What the program does (main_study.cc), in children of a process that has loaded the libraries
 * and started MPI: a start of its own takes 0.7 s of processor time. */
class ReadyProgram
{
public:
  static ReadyProgram &get()
  {
    static ReadyProgram ready;
    return ready;
  }

  ~ReadyProgram()
  {
    close(socket_);
    waitpid(server_, nullptr, 0);
  }
  ReadyProgram(const ReadyProgram &)            = delete;
  ReadyProgram &operator=(const ReadyProgram &) = delete;

  /** Its status as waitpid() has it; both streams go into a file. */
  int run(const std::vector<std::string> &words, const std::string &output)
  {
    std::string job = std::filesystem::current_path().string() + '\0' + output + '\0';
    for (const std::string &word : words)
      job += word + '\0';
    const std::uint64_t size   = job.size();
    int                 status = -1;
    if (!send(socket_, &size, sizeof(size)) || !send(socket_, job.data(), size) ||
        !receive(socket_, &status, sizeof(status)))
      throw std::runtime_error("the process of ready programs has ended");
    return status;
  }

private:
  ReadyProgram()
  {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw std::runtime_error("no socket for the process of ready programs");
    // No child may print what is left to print here.
    std::cout.flush();
    std::fflush(nullptr);
    server_ = fork();
    if (server_ == 0)
      {
        close(ends[0]);
        serve(ends[1]);
        _exit(0);
      }
    close(ends[1]);
    socket_ = ends[0];
  }

  static bool send(const int socket, const void *data, const std::size_t size)
  {
    return ::send(socket, data, size, MSG_NOSIGNAL) == static_cast<ssize_t>(size);
  }

  static bool receive(const int socket, void *data, const std::size_t size)
  {
    return recv(socket, data, size, MSG_WAITALL) == static_cast<ssize_t>(size);
  }

  static void serve(const int socket)
  {
    char              name[] = "vfife", *words[] = {name, nullptr}, **argv = words;
    int               argc = 1;
    vfife::MpiSession session(argc, argv);
    for (std::uint64_t size = 0; receive(socket, &size, sizeof(size));)
      {
        std::string job(size, '\0');
        receive(socket, job.data(), size);
        const pid_t child = fork();
        if (child == 0)
          _exit(work(job, session));
        int status = 0;
        waitpid(child, &status, 0);
        send(socket, &status, sizeof(status));
      }
  }

  static int work(const std::string &job, vfife::MpiSession &session)
  {
    std::vector<const char *> texts;
    for (std::size_t at = 0; at < job.size(); at = job.find('\0', at) + 1)
      texts.push_back(job.data() + at);
    const unsigned int n = texts.size();
    texts.push_back(nullptr);
    if (chdir(texts[0]) != 0)
      return 125;
    const int file = open(texts[1], O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    const vfife::StopNotice notice(session.world().is_root());
    vfife::Failure          failure;
    try
      {
        vfife::run_program(n - 2, texts.data() + 2, session.world());
      }
    catch (...)
      {
        failure = vfife::describe_failure(std::current_exception());
      }
    const int code = session.finish(failure);
    std::cout.flush();
    std::fflush(nullptr);
    return code;
  }

  pid_t server_ = -1;
  int   socket_ = -1;
};

inline Ending ending_of(const int status, const std::string &output)
{
  Ending ending;
  if (WIFEXITED(status))
    ending.exit_code = WEXITSTATUS(status);
  ending.text = read_text(output);
  return ending;
}

/** Runs a program; when @p is_time is true first, @p signal is sent to it. */
inline Ending run_program(const std::vector<std::string> &words,
                          const std::function<bool()>    &is_time = nullptr,
                          const int                       signal  = 0)
{
  const std::string output = "program_output.txt";
  // A process that has started MPI itself cannot have it started by its children.
  int has_mpi = 0;
  MPI_Initialized(&has_mpi);
  if (has_mpi == 0 && !is_time && words.front() == program_file())
    return ending_of(ReadyProgram::get().run(words, output), output);
  const pid_t child = fork();
  if (child == 0)
    {
      const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
      dup2(file, STDOUT_FILENO);
      dup2(file, STDERR_FILENO);
      std::vector<char *> arguments;
      for (const std::string &word : words)
        arguments.push_back(const_cast<char *>(word.c_str()));
      arguments.push_back(nullptr);
      execvp(arguments[0], arguments.data());
      _exit(127);
    }
  int  status = 0;
  bool sent   = false;
  while (waitpid(child, &status, WNOHANG) == 0)
    {
      if (is_time && !sent && is_time())
        {
          kill(child, signal);
          sent = true;
        }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  return ending_of(status, output);
}

#endif
