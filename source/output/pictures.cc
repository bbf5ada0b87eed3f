// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/pictures.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include <sys/wait.h>

namespace vfife
{
  namespace
  {
    namespace fs = std::filesystem;

    /** What a command said (both streams) and how it ended. */
    struct Outcome
    {
      int         exit_code = -1;
      std::string text;
    };

    Outcome run_command(const std::string &command)
    {
      Outcome    outcome;
      std::FILE *pipe = popen((command + " 2>&1 </dev/null").c_str(), "r");
      if (pipe == nullptr)
        return outcome;
      // All that the command says is read, also what is not shown: a full pipe would stop it.
      std::array<char, 512> buffer;
      while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr)
        outcome.text += buffer.data();
      const int status = pclose(pipe);
      if (status != -1 && WIFEXITED(status))
        outcome.exit_code = WEXITSTATUS(status);
      return outcome;
    }

    /** One word of the shell. */
    std::string quote(const std::string &word)
    {
      std::string quoted = "'";
      for (const char c : word)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
      return quoted + "'";
    }

    /** The last line that is not empty: of a Python error the one that names it. */
    std::string last_line(const std::string &text)
    {
      const std::size_t end = text.find_last_not_of(" \n");
      if (end == std::string::npos)
        return "no message";
      const std::size_t start = text.rfind('\n', end) + 1; // 0 where there is no line before
      return text.substr(start, end + 1 - start);
    }

    /** The script, installed beside this program or in the sources; empty if it is nowhere. */
    std::string find_script()
    {
      std::error_code error;
      const fs::path  program = fs::read_symlink("/proc/self/exe", error);
      for (const fs::path &folder :
           {program.parent_path().parent_path() / VFIFE_REPORT_BESIDE_PROGRAM,
            fs::path(VFIFE_REPORT_SOURCE),
            fs::path(VFIFE_REPORT_INSTALLED)})
        if (fs::is_regular_file(folder / "make_report.py", error))
          return (folder / "make_report.py").string();
      return "";
    }

    /** Exit codes that ask for another Python: make_report.py's for a missing module, the shell's
     * for a missing program. */
    bool lacks_something(const Outcome &outcome)
    {
      return outcome.exit_code == 77 || outcome.exit_code == 127;
    }
  } // namespace

  void draw_pictures(const OutputFolder &folder, Log &log)
  {
    if (!folder.is_writer())
      return;
    const std::string script = find_script();
    if (script.empty())
      {
        log.line("no pictures: the scripts of share/vfife/report are not installed");
        return;
      }
    // A report is an addition to the results: whatever goes wrong with it is a line of the log and
    // no failure of the run.
    // -B: nothing is written beside the scripts.
    // A name such as "--help" must not be taken for an option.
    const std::string path      = (folder.path()[0] == '-' ? "./" : "") + folder.path();
    const std::string arguments = " -B " + quote(script) + " " + quote(path);
    Outcome           outcome   = run_command("python3" + arguments);
    // A user's Python may lack what is needed, or have other things of the same names: Debian's
    // then, without what users' variables (-E) and folders (-s) bring in.
    if (outcome.exit_code != 0)
      {
        const Outcome of_system = run_command("/usr/bin/python3 -E -s" + arguments);
        if (of_system.exit_code == 0 || lacks_something(outcome))
          outcome = of_system;
      }

    if (outcome.exit_code == 0)
      log.line(last_line(outcome.text));
    else if (lacks_something(outcome))
      log.line(
        "no pictures: python3 with numpy, matplotlib, Jinja2, meshio and, for fields in HDF5, "
        "h5py is required (",
        last_line(outcome.text),
        ")");
    else
      log.line("not all pictures could be drawn: ", last_line(outcome.text));
  }
} // namespace vfife
