// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_study_quick_pair_h
#define vfife_tests_study_quick_pair_h

#include "../tests.h"
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/output/files/table_reader.h>
#include <vfife/study/study.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

/** The paper's pair on meshes as coarse as they go, with entries of the gear's body and mesh. All
 * kinds have the elements of a run, so that they are compared on equal bodies. Three
 * points per facet: by its width the contact would have twelve, which takes three times as long. */
inline std::string coarse_pair(const std::string &gear_body, const std::string &gear_mesh)
{
  const std::string mesh = R"(
    subsection Mesh
      set elements along face width = 2
      set elements across tooth = 2
      set elements along profile = 2
)";
  return std::string("include ") + tree_folder() + "/prm/paper_pair.prm\n" +
         "subsection Gear pair\n  subsection Pinion" + mesh +
         "      set elements through rim = 2\n    end\n  end\n" +
         "  subsection Gear\n    subsection Body\n" + gear_body + "\n    end" + mesh + gear_mesh +
         "\n    end\n  end\nend\ninclude " + tree_folder() +
         "/tests/study/quick_contact/contact.prm\n\n\n";
}

/** A conical web in its coarsest mesh: entries for coarse_pair(). */
constexpr char coarse_web[] =
  "set elements through rim = 3\nset elements through web = 1\nset elements along web = 3\n"
  "set elements through hub = 1\nset elements beside web = 1";

/** Sections of a run of one mesh cycle; root stresses are those of the mesh, without submodels. */
inline std::string one_tooth_mesh(const std::string &tolerance)
{
  return R"(
subsection Operation
  set speed        = 20000 rpm
  set torque       = 800 N m
  set mesh cycles = 1
end
subsection Dynamics
  subsection Relaxation
    set tolerance = )" +
         tolerance + R"(
  end
end
subsection Fillets
  set source = elements
end
subsection Output
  set samples per mesh cycle = 98
  set report        = false
  set verbosity     = quiet
end
)";
}

/** A strain gauge on the gear. */
constexpr char gauge_of_gear[] = R"(
subsection Fillets
  set gauges = G
  subsection Gauge G
    set body   = gear
    set side   = convex
    set height = 0.6
    set place  = 0.4
    set length = 0.5 mm
  end
end
)";

/** The penalty of contact.prm as an entry, for starts without calibration. */
constexpr char quick_penalty[] = "Contact/penalty=1071025";

/** One mesh cycle of that pair. */
inline std::string
quick_pair(const std::string &gear_body, const std::string &gear_mesh, const std::string &tolerance)
{
  return coarse_pair(gear_body, gear_mesh) + one_tooth_mesh(tolerance);
}

/** Does the case of a parameter file without a word, with other entries, or goes on with it. */
inline void run_case(const std::string              &file,
                     const std::string              &folder,
                     vfife::Communicator            &communicator,
                     const std::vector<std::string> &overrides = {},
                     const bool                      restart   = false)
{
  vfife::CommandLine line;
  line.parameter_file = file;
  line.output_folder  = folder;
  line.overrides      = overrides;
  line.restart        = restart;
  std::ostringstream nothing;
  vfife::Log         log(nothing, communicator.is_root(), vfife::Verbosity::quiet);
  vfife::run_study(line, communicator, log);
}

/** What --check says of the case. */
inline std::string check_case(const std::string              &file,
                              vfife::Communicator            &communicator,
                              const std::vector<std::string> &overrides = {})
{
  vfife::CommandLine line;
  line.parameter_file = file;
  line.overrides      = overrides;
  line.check          = true;
  std::ostringstream said;
  vfife::Log         log(said, communicator.is_root());
  vfife::run_study(line, communicator, log);
  return said.str();
}

/** run_case() of a kind that reads the section Output, without its report. */
inline void run_pair(const std::string       &file,
                     const std::string       &folder,
                     vfife::Communicator     &communicator,
                     std::vector<std::string> overrides = {},
                     const bool               restart   = false)
{
  overrides.insert(overrides.begin(), "Output/report=no");
  run_case(file, folder, communicator, overrides, restart);
}

using Columns = std::map<std::string, std::vector<double>>;

/** Columns of a CSV file of numbers by name ("dte"), without the units of the header. */
inline Columns read_columns(const std::string &path)
{
  const vfife::Table table = vfife::read_result_table(path);
  Columns            columns;
  for (const vfife::Table::Column &column : table.columns())
    if (!column.is_text)
      columns[column.name] = column.numbers;
  return columns;
}

/** Does the case of a parameter file with this text; its histories. */
inline Columns
run_text(const std::string &name, const std::string &text, vfife::Communicator &communicator)
{
  std::ofstream(name + ".prm") << text;
  run_pair(name + ".prm", name, communicator);
  return read_columns(name + "/history.csv");
}

#endif
