// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_study_child_program_h
#define vfife_tests_study_child_program_h

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
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

inline std::string read_text(const std::string &path)
{
  std::ifstream      file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/** Runs a program; when @p is_time is true first, @p signal is sent to it. */
inline Ending run_program(const std::vector<std::string> &words,
                          const std::function<bool()>    &is_time = nullptr,
                          const int                       signal  = 0)
{
  const std::string output = "program_output.txt";
  const pid_t       child  = fork();
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
  Ending ending;
  if (WIFEXITED(status))
    ending.exit_code = WEXITSTATUS(status);
  ending.text = read_text(output);
  return ending;
}

#endif
