// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Parameter files: values reach their variables, and each kind of mistake gives its message with
// the right line.

#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/types.h>

#include <deal.II/base/parameter_handler.h>

#include "../refusal.h"
#include "../tests.h"

#include <fstream>
#include <sstream>

using namespace vfife;

enum class Stiffness
{
  incompatible_modes,
  full
};

const Choices<Stiffness> stiffness_choices = {{"incompatible modes", Stiffness::incompatible_modes},
                                              {"full", Stiffness::full}};

struct Options
{
  double                   web_thickness = 5.;
  double                   face_angle    = 70. * pi / 180.;
  double                   speed         = 20000. * pi / 30.;
  double                   safety        = 0.9;
  unsigned int             layers        = 2;
  bool                     friction      = false;
  std::string              folder        = "results";
  std::vector<std::string> bodies        = {"beam", "ring"};
  Stiffness                stiffness     = Stiffness::incompatible_modes;

  void declare(dealii::ParameterHandler &prm)
  {
    {
      const Subsection study(prm, "Study");
      declare_text(prm, "output folder", folder, "where results go");
      declare_names(prm, "bodies", bodies, "bodies of the model");
    }
    const Subsection pair(prm, "Gear pair");
    {
      const Subsection gear(prm, "Gear");
      const Subsection body(prm, "Body");
      declare_quantity(
        prm, "Web thickness", web_thickness, "mm", "thickness of the web", Range::positive());
      declare_quantity(
        prm, "Face angle", face_angle, "deg", "angle of the face cone", Range::between(0., 90.));
      declare_integer(prm, "Layers", layers, "elements across the web", 1, 64);
    }
    declare_quantity(prm, "Speed", speed, "rpm", "speed of the pinion", Range::not_negative());
    declare_number(prm, "Safety", safety, "part of the stable step", {0., 1., true});
    declare_switch(prm, "Friction", friction, "whether flanks rub");
    declare_choice(prm, "Stiffness", stiffness, stiffness_choices, "stiffness of the element");
  }
};

void write_file(const std::string &name, const std::string &text)
{
  std::ofstream(name) << text;
}

/** Reads the file strictly and prints the message. */
void refuse(const std::string &text, const std::vector<std::string> &overrides = {})
{
  write_file("case.prm", text);
  Options                  options;
  dealii::ParameterHandler prm;
  options.declare(prm);
  try
    {
      ParameterFile("case.prm", overrides).read(prm);
      std::cout << "FAILED: accepted " << text << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}

const std::string good_file = "# a comment\n"
                              "subsection Study\n"
                              "  set output folder = some where # a comment\n"
                              "  set bodies = a, \\\n"
                              "               b c\n"
                              "end\n"
                              "\r\n"
                              "subsection Gear pair\n"
                              "  subsection Gear\n"
                              "    subsection Body\n"
                              "      set Web thickness = 0.25 m\n"
                              "      include angle.prm\n"
                              "    end\n"
                              "  end\n"
                              "  set Speed = 600\n"
                              "  set Safety = 80 %\n"
                              "  set Friction=yes\n"
                              "  set Stiffness = full\n"
                              "end\n";

void check_good_file()
{
  write_file("angle.prm", "\nset Face angle = 0.5 rad\n");
  write_file("case.prm", good_file);
  Options                  options;
  dealii::ParameterHandler prm;
  options.declare(prm);
  const ParameterFile file("case.prm",
                           {"Gear pair/Gear/Body/Layers = 7", "Gear pair/Speed=2 rad/s"});
  file.read(prm);
  check("length in another unit", options.web_thickness == 250.);
  check("angle of an included file", options.face_angle == 0.5);
  check("whole number from the command line", options.layers == 7);
  check("the command line wins", options.speed == 2.);
  check("share", options.safety == 0.8);
  check("switch", options.friction);
  check("text with a comment behind it", options.folder == "some where");
  check("names on two lines", options.bodies == std::vector<std::string>({"a", "b c"}));
  check("choice",
        options.stiffness == Stiffness::full &&
          word_of(options.stiffness, stiffness_choices) == "full");

  std::cout << file.locate("Study/bodies") << "\n"
            << file.locate("Gear pair/Gear/Body/Web thickness") << "\n"
            << file.locate("Gear pair/Gear/Body/Face angle") << "\n"
            << file.locate("Gear pair/Speed") << "\n"
            << file.locate("Gear pair/Gear") << "\n"
            << file.explain(InputError("Gear pair/Gear/Body/Web thickness",
                                       "the web is thicker than the gear"))
            << "\n"
            << file.explain(InputError("Body/Web thickness", "the web is thicker than the gear"))
            << "\n"
            << file.explain(InputError("Gear pair/Mounting/Backlash", "too small")) << "\n"
            << file.explain(InputError("no entry is to blame")) << std::endl;
  check("nothing is set there", file.locate("Gear pair/Backlash").empty());
  check("sections of the file",
        file.contains("Gear pair/Gear") && file.contains("Gear pair/Gear/Body/Layers") &&
          !file.contains("Gear pair/Pinion") && !file.contains("Gear"));

  // what is printed must read back as the same values
  std::ostringstream printed;
  print_parameters(printed, prm);
  write_file("printed.prm", printed.str());
  Options                  again;
  dealii::ParameterHandler prm_again;
  again.declare(prm_again);
  ParameterFile("printed.prm").read(prm_again);
  check("printed parameters read back",
        again.web_thickness == options.web_thickness && again.face_angle == options.face_angle &&
          again.speed == options.speed && again.safety == options.safety &&
          again.layers == options.layers && again.friction == options.friction &&
          again.folder == options.folder && again.bodies == options.bodies &&
          again.stiffness == options.stiffness);
}

void check_first_pass()
{
  // in the first pass only what is declared is looked at, but that strictly
  write_file("case.prm",
             "subsection Study\n set bodies = a\n set kind = run\nend\nsubsection Body a\nend\n");
  dealii::ParameterHandler prm;
  std::vector<std::string> bodies;
  {
    const Subsection study(prm, "Study");
    declare_names(prm, "bodies", bodies, "bodies of the model");
  }
  ParameterFile("case.prm", {"Body a/length=3"}).read_known(prm);
  check("first pass", bodies == std::vector<std::string>({"a"}));
  try
    {
      ParameterFile("case.prm", {"Study/bodies=a,a"}).read_known(prm);
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }

  // defaults are kept to the last bit, and setting the default's text restores it
  Options                  options;
  const double             angle = options.face_angle;
  dealii::ParameterHandler defaults;
  options.declare(defaults);
  check("defaults are kept", options.face_angle == angle && options.speed == 20000. * pi / 30.);
  ParameterFile("case.prm",
                {"Gear pair/Gear/Body/Face angle=3", "Gear pair/Gear/Body/Face angle=70"})
    .read_known(defaults);
  check("default set again", options.face_angle == angle);
}

void check_wrong_values()
{
  const std::string begin = "subsection Gear pair\n  subsection Gear\n    subsection Body\n",
                    end   = "end\nend\nend\n";
  refuse(begin + "set Web thicknes = 5\n" + end);
  refuse(begin + "\n\nset Web thickness = -5\n" + end);
  refuse(begin + "set Face angle = 20\nset Web thickness = 5 kg\n" + end);
  refuse(begin + "set Face angle = \\\n  91\n" + end);
  refuse(begin + "set Face angle = 1.6 rad\n" + end);
  refuse(begin + "set Layers = 2.5\n" + end);
  refuse(begin + "set Layers = 65\n" + end);
  refuse(begin + "set Web thickness =\n" + end);
  refuse(begin + "set Speed = 5\n" + end);
  refuse("subsection Gear pair\n set Stiffness = ful\nend\n");
  refuse("subsection Gear pair\n set Friction = maybe\nend\n");
  refuse("subsection Gear pair\n set Speed = -1 rpm\nend\n");
  refuse("subsection Gear pair\n set Safety = 0\nend\n");
  refuse("", {"Gear pair/Gear/Body/Web thickness=5 kg"});
  refuse("", {"Gear pair/Gera/Body/Web thickness=5"});
}

void check_wrong_structure()
{
  refuse("subsection Study\n set output folder = a\nend\nsubsection Gear par\nend\n");
  refuse("subsection Lumped\nend\n");
  refuse("subsection Body\nend\n");
  refuse("subsection Gear pair\n  set Gear = 3\nend\n");
  refuse("subsection Gear pair\n\nsubsection Gear\nend\n\n");
  refuse("subsection Study\nend\nend\n");
  refuse("subsection Study\n  set output folder results\nend\n");
  refuse("subsection Study\n  sett output folder = results\nend\n");
  refuse("subsection Study\n set bodies = a\nend\n\nsubsection Study\n set bodies = b\nend\n");
  refuse("include nowhere.prm\n");
  refuse("\ninclude case.prm\n");
  refuse("", {"Study/bodies"});
  refuse("", {"Study//bodies=3"});
  print_refusal([] { ParameterFile("nothing.prm"); });
}

int main()
{
  check_good_file();
  check_first_pass();
  check_wrong_values();
  check_wrong_structure();
  return 0;
}
