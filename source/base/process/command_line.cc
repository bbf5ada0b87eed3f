// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/command_line.h>
#include <vfife/base/text/nearest_name.h>

#include <boost/program_options.hpp>

#include <vfife/base/process/revision.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <sstream>

namespace vfife
{
  namespace
  {
    namespace options = boost::program_options;

    const char usage[] = "usage: vfife FILE.prm [options]";

    /** Options that users see; each is bound to its place in @p line. */
    options::options_description visible_options(CommandLine &line)
    {
      options::options_description description("options");
      description.add_options() //
        ("output,o",
         options::value(&line.output_folder)->value_name("DIR"),
         "write results to DIR (default: Study/output folder)") //
        ("set",
         options::value(&line.overrides)->composing()->value_name("SECTION/SUB/NAME=VALUE"),
         "override one parameter of the file; repeatable") //
        ("check",
         options::bool_switch(&line.check),
         "build the model, report its size, time step, expected time and warnings; do not run it") //
        ("restart",
         options::bool_switch(&line.restart),
         "[DIR]  continue from the last checkpoint in the output folder, or in DIR; FILE.prm is "
         "optional then") //
        ("print-parameters",
         options::bool_switch(&line.print_parameters),
         "print all effective parameters with description, unit and default") //
        ("parameter-reference",
         options::bool_switch(&line.parameter_reference),
         "print the parameters of all study kinds as Markdown")               //
        ("version", options::bool_switch(&line.version), "print the version") //
        ("help,h", options::bool_switch(&line.help), "print this text");
      return description;
    }

    std::vector<std::string> option_names(const options::options_description &description)
    {
      std::vector<std::string> names;
      for (const auto &option : description.options())
        names.push_back("--" + option->long_name());
      return names;
    }

    /** Takes the folder to go on in out of the arguments. */
    void take_folder(std::vector<std::string> &files, CommandLine &line)
    {
      // A folder tells itself from a parameter file; a run that goes on there has its parameters.
      const auto folder = std::find_if(files.begin(), files.end(), [](const std::string &file) {
        std::error_code error;
        return std::filesystem::is_directory(file, error);
      });
      if (folder != files.end())
        {
          line.output_folder = *folder;
          files.erase(folder);
        }
      else
        for (const std::string &file : files)
          if (std::error_code error; std::filesystem::path(file).extension() != ".prm" &&
                                     !std::filesystem::exists(file, error))
            throw InputError("cannot restart: folder \"" + file + "\" does not exist");
      if (files.empty() && !line.output_folder.empty())
        files.push_back(line.output_folder + "/parameters.prm");
    }
  } // namespace

  CommandLine parse_command_line(const int argc, const char *const *argv)
  {
    CommandLine                             line;
    std::vector<std::string>                files;
    const options::options_description      visible = visible_options(line);
    options::options_description            all;
    options::positional_options_description positional;
    // The file stands without a name of an option, which is not shown by --help.
    all.add(visible).add_options()("parameter-file", options::value(&files));
    positional.add("parameter-file", -1);

    try
      {
        // no guessing: an abbreviation today is another option tomorrow
        const int style =
          options::command_line_style::unix_style & ~options::command_line_style::allow_guessing;
        options::variables_map values;
        options::store(options::command_line_parser(argc, argv)
                         .options(all)
                         .positional(positional)
                         .style(style)
                         .run(),
                       values);
        options::notify(values);
        if (values.count("output") > 0 && line.output_folder.empty())
          throw InputError("-o: expected a folder, got \"\". Name a folder, or leave -o out.");
      }
    catch (const options::unknown_option &error)
      {
        const std::vector<std::string> known = option_names(visible);
        const std::string              hint  = did_you_mean(error.get_option_name(), known);
        throw InputError("unknown option " + error.get_option_name() +
                         (hint.empty() ? "; the options are " + list_of(known) : hint));
      }
    catch (const options::error &error)
      {
        throw InputError(std::string(error.what()) + " (vfife --help lists the options)");
      }

    // Only now is it known whether "--restart DIR" was meant: DIR stands among the files.
    if (line.restart)
      take_folder(files, line);
    if (files.size() > 1)
      throw InputError("expected one parameter file, got " + std::to_string(files.size()) + ": " +
                       list_of(files, true));
    if (files.empty() && !line.help && !line.version && !line.parameter_reference)
      throw InputError(std::string("no parameter file; ") + usage);
    if (!files.empty())
      line.parameter_file = files[0];
    return line;
  }

  std::string help_text()
  {
    CommandLine        line;
    std::ostringstream text;
    text << "vfife - finite element dynamics of gear pairs and solid models\n\n"
         << usage << "\n       mpirun -n N vfife FILE.prm [options]\n\n"
         << visible_options(line) << R"(
study kinds (Study/kind in FILE.prm):
  run, reduced, waves, static, linear static, modal, lumped, sweep, compare, flank fit, mesh,
  tooth contact analysis, loaded tooth contact analysis

exit codes: 0 success, 1 input error, 2 computation failed, 3 stopped after a checkpoint
signals: SIGUSR2 writes a checkpoint and stops; SIGTERM and SIGINT likewise without mpirun;
  SIGUSR1 writes a field file

example: vfife prm/spiral_bevel_quick.prm -o results/slow --set "Operation/speed=8000 rpm"
documentation: doc/index.md
)";
    return text.str();
  }

  std::string version_text()
  {
    return std::string("vfife ") + program_version() + " (revision " + program_revision() +
           ", deal.II " + VFIFE_DEAL_II_VERSION + ")\n";
  }

  bool print_requested_text(const CommandLine &line, std::ostream &out)
  {
    if (line.help || line.version)
      out << (line.help ? help_text() : version_text()) << std::flush;
    return line.help || line.version;
  }
} // namespace vfife
