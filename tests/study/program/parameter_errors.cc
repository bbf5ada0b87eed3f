// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What a user reads whose parameter file is wrong: file, line, what is wrong, and what may be
// meant; what --check says of one that is right, and of materials that are none.
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

using namespace vfife;

/** A case that can be run, with @p lines in front of its own entries. */
std::string write_case(const std::string &lines)
{
  const std::string name = "case.prm";
  std::ofstream     file(name);
  file << "include " << tree_folder() << "/prm/paper_pair.prm\n"
       << lines << "subsection Operation\n"
       << "  set speed        = 20000 rpm\n"
       << "  set torque       = 800 N m\n"
       << "end\n";
  return name;
}

void refuse(const std::string              &name,
            Communicator                   &communicator,
            const std::vector<std::string> &overrides = {})
{
  try
    {
      check_case(name, communicator, overrides);
      std::cout << "FAILED: accepted" << std::endl;
    }
  catch (const InputError &error)
    {
      const std::string message = error.what();
      std::cout << message.substr(0, message.find(" of memory, ")) << std::endl;
    }
}

/** A model of one body. */
std::string write_model(const std::string &body)
{
  const std::string name = "model.prm";
  std::ofstream(name) << "subsection Study\n  set kind = linear static\nend\nsubsection Model\n"
                         "  set bodies = a\n  subsection Body a\n    "
                      << body << "\n  end\nend\n";
  return name;
}

std::string gear_body(const std::string &entry)
{
  return "subsection Gear pair\n  subsection Gear\n    subsection Body\n      set body type = "
         "conical web\n      " +
         entry + "\n    end\n  end\nend\n";
}

/** Prints the lines of --check that begin with one of the words. */
void show(const std::string              &name,
          Communicator                   &communicator,
          const std::vector<std::string> &words,
          const std::vector<std::string> &overrides = {})
{
  std::istringstream lines(check_case(name, communicator, overrides));
  for (std::string one; std::getline(lines, one);)
    for (const std::string &word : words)
      if (one.compare(0, word.size(), word) == 0)
        std::cout << one << std::endl;
}

/** One body on all that can hold and load it. */
std::string write_held_model()
{
  const std::string name = "held.prm";
  std::ofstream(name) << R"(
subsection Study
  set kind = linear static
end
subsection Model
  set bodies = shaft
  set constraints = left, end, drive, soft
  set loads = pull
  set probes = tip
  subsection Body shaft
    set mesh = stepped shaft
    set sections = 0 60 20
    set elements around = 8
    set axial element size = 20 mm
    set radial element size = 10 mm
    set rotating = yes
    set axis direction = 0, 0, 1
  end
  subsection Constraint left
    set kind = bearing
    set nodes = section 1
    set where = z < 1
    set radial stiffness = 5000 N/mm
    set axial stiffness = 3 N/um
    set radial damping = 2 N s/mm
  end
  subsection Constraint end
    set kind = displacement
    set nodes = section 1
    set where = z > 59
    set directions = x
    set displacement = 0.1, 0, 0 mm
  end
  subsection Constraint drive
    set kind = coupling
    set nodes = section 1
    set where = z > 59
    set torsional stiffness = 1000 N m/rad
  end
  subsection Constraint soft
    set kind = spring
    set nodes = section 1
    set stiffness = 1, 2, 3
  end
  subsection Load pull
    set kind = force
    set nodes = section 1
    set where = z > 59
    set force = 0, 0, 1 kN
    set history = t
  end
  subsection Probe tip
    set point = 10, 0, 60
  end
end
)";
  return name;
}

/** Formulas and lists that would be misread, or that have no value somewhere. */
void formulas_and_lists(Communicator &world)
{
  for (const char *where :
       {"x > 9,5", "(9,5) < x", "x = 5", "0 < x < 5", "sqrt(x-5) > 1", "1/x > 2", "log(x)"})
    refuse(write_model(
             "set mesh = block\n  end\n  set constraints = foot\n  subsection Constraint foot\n"
             "    set kind = fixed\n    set nodes = all\n    set where = " +
             std::string(where)),
           world);
  for (const char *speed : {"9,5*x", "sqrt(x-5)*100", "1/x"})
    refuse(write_model("set mesh = block\n    set initial velocity y = " + std::string(speed)),
           world);
  for (const char *speeds : {"9,000 rpm", "1,5 Hz", "0,5", "1000, 2,5", "100,200,300", "0, 0"})
    refuse(write_model("set mesh = block"),
           world,
           {"Study/kind=modal", "Fem/speeds=" + std::string(speeds)});
}

void files_and_sections(Communicator &world)
{
  refuse(write_case(""), world, {"Gear pair/Errors/Pinion/Concave flank/topography=no.csv"});
  refuse(write_case(""), world, {"Study/kind=flank fit", "Flank fit/measured flank=no.csv"});
  refuse(write_case(""), world, {"Operation/torque=no.csv"});
  refuse(write_case(""),
         world,
         {"Gear pair/Housing/stiffness=no.mtx",
          "Gear pair/Errors/Gear/Convex flank/pitch table=no.csv"});
  refuse(write_case(""), world, {"Gear pair/Gear/web thickness=8 mm"});
  refuse(write_case(""), world, {"Gear pair/Proposal/web thickness=8 mm"});
  std::ofstream("none.prm")
    << "subsection Operation\n  set speed = 9000 rpm\n  set torque = 600 N m\nend\n";
  refuse("none.prm", world);
  refuse("none.prm", world, {"Gear pair/mesh=coarse"});
  refuse("none.prm", world, {"Gear pair/Proposal/module=4 mm"});
}

void materials(Communicator &world)
{
  // A name without a section would be the default steel.
  refuse(write_case(""),
         world,
         {"Gear pair/Pinion/material=bronze",
          "Gear pair/Gear/material=bronz",
          "Material bronze/density=8.8 g/cm^3"});
  refuse(write_model("set material = stel"), world);
  // Lead, rubber, beryllium, tungsten, foam, cork, diamond; then what no solid has.
  for (const char *solid :
       {"11340 16000", "1100 1", "1850 303000", "19300 411000", "20 5", "200 20", "3515 1.2e6"})
    {
      const std::string text = solid;
      const std::size_t gap  = text.find(' ');
      show(write_model("set mesh = block"),
           world,
           {"warning"},
           {"Material steel/density=" + text.substr(0, gap),
            "Material steel/Young's modulus=" + text.substr(gap)});
    }
  for (const char *entry : {"density=7.85e-9",
                            "density=7.85",
                            "density=7850 g/cm^3",
                            "Young's modulus=2.06e11",
                            "Young's modulus=206",
                            "Young's modulus=206000 GPa",
                            "density=0.284"})
    show(write_model("set mesh = block"),
         world,
         {"warning"},
         {"Material steel/" + std::string(entry)});
}

int main(int argc, char **argv)
{
  MpiSession    session(argc, argv);
  Communicator &world = session.world();

  refuse(write_case(gear_body("set web thicknes = 5 mm")), world);
  refuse(write_case(gear_body("set web thickness = 5 deg")), world);
  refuse(write_case(gear_body("set web thickness = -5 mm")), world);
  refuse(write_case(gear_body("set web inclination = 120 deg")), world);
  refuse(write_case("subsection Gear pair\n  subsection Pinion\n    subsection Shaft\n"
                    "      set sections = 90 120 40 20\n    end\n  end\nend\n"),
         world);
  refuse(write_case("subsection Gear pairs\nend\n"), world);
  refuse(write_case("subsection Study\n  set kind = walk\nend\n"), world);
  refuse(write_case("subsection Operation\n  set bore rotation = rigid hob\nend\n"), world);
  refuse(write_case("subsection Dynamics\n  set mass proportional damping = 1e5 1/s\nend\n"),
         world);
  refuse(write_case("subsection Dynamics\n  set damping ratio = 0.5\n"
                    "  set damping frequency = 3.7 kHz\nend\n"),
         world);
  refuse(write_case("subsection Dynamics\n  set mass proportional damping = 1000 1/s\n"), world);
  refuse(write_case("include nothing_here.prm\n"), world);
  refuse("missing.prm", world);
  refuse(write_case(""), world, {"Operation/sped=1 rpm"});
  refuse(write_case(""), world, {"Operation/speed=1 mm"});
  refuse(write_case(""), world, {"Operation/speed=0 rpm"});
  refuse(write_case(""), world, {"Operation/speed=2e6 rpm"});
  refuse(write_case(""), world, {"Operation/speed"});
  refuse(write_case(""), world, {"Operations/speed=1 rpm"});

  // What is no text.
  refuse(write_case("# a\xff\n"), world);
  refuse(write_case(std::string("set a\0b = 1\n", 12)), world);
  refuse(write_case(""), world, {"Study/output folder=\xc3("});

  // A name that no file can have.
  refuse(write_case("include " + std::string(300, 'x') + ".prm\n"), world);

  // Counts that only a real run would use, and never come to the end of.
  const std::vector<std::pair<std::string, std::string>> endless = {
    {"run", "Operation/mesh cycles=1e7"},
    {"tooth contact analysis", "Tooth contact analysis/points per pitch=1e6"},
    {"mesh", "Export/flank points lengthwise=1e9"},
    {"lumped", "Lumped/samples per mesh cycle=1e6"},
    {"lumped", "Lumped/settling mesh cycles=1e9"},
    {"lumped", "Lumped/speeds=1e9"},
    {"modal", "Fem/maximum nodal diameter=1e9"},
    {"run", "Dynamics/Relaxation/load steps=1e9"}};
  for (const auto &[kind, entry] : endless)
    refuse(write_case(""), world, {"Study/kind=" + kind, entry});

  // Meshes that no machine holds are refused before anything is meshed; how much is free is another
  // number everywhere.
  const std::vector<std::string> shapes = {"block", "beam", "ring", "cylinder", "disc", "sphere"};
  const std::vector<std::string> counts = {
    "cells x", "cells along length", "cells around", "axial cells", "radial cells", "radial cells"};
  for (std::size_t i = 0; i < shapes.size(); ++i)
    refuse(write_model("set mesh = " + shapes[i] + "\n    set " + counts[i] + " = 1e8"), world);
  refuse(write_model("set mesh = block\n    set elements x = 1000\n    set elements y = 1000\n"
                     "    set elements z = 490"),
         world);
  refuse(write_case(""), world, {"Gear pair/Gear/Mesh/elements along face width=1e7"});
  refuse(write_case(""), world, {"Gear pair/Pinion/Mesh/elements across tooth=1e8"});
  refuse(write_case(""),
         world,
         {"Gear pair/Pinion/Shaft/sections=90 200 40 20",
          "Gear pair/Pinion/Shaft/axial element size=1 um",
          "Gear pair/Pinion/Shaft/radial element size=1 um"});

  formulas_and_lists(world);
  files_and_sections(world);
  materials(world);
  show(write_held_model(), world, {"constraint", "bearing", "coupling", "spring", "load"});
  show(write_case(""),
       world,
       {"Gear pair", "constraint", "torque", "contact"},
       {"Study/kind=modal",
        "Gear pair/Errors/Gear/radial runout amplitude=20 um",
        "Gear pair/Mounting/offset=0.02 mm"});
  return 0;
}
