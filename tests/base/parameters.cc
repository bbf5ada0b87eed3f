// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Parameter files: values reach their variables, and each kind of mistake gives its message with
// the right line.

#include <vfife/base/parameters/number_list.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/types.h>

#include <deal.II/base/parameter_handler.h>

#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <array>
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
  print_refusal([&] { ParameterFile("case.prm", overrides).read(prm); });
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
  print_refusal([&] { ParameterFile("case.prm", {"Study/bodies=a,a"}).read_known(prm); });

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

/** 0 becomes the word of an entry that has one for it, and of no other. */
void check_words_for_zero()
{
  const auto read = [](const std::string &text) {
    dealii::ParameterHandler prm;
    double                   layer = 0, size = 0;
    NumberOrWord             cells   = {16, true};
    std::string              formula = "x";
    declare_quantity(prm, "Layer", layer, "mm", "layer", Range::positive().or_word("none"));
    declare_quantity(prm, "Size", size, "mm", "size", Range::not_negative());
    declare_number_or_word(prm, "Cells", cells, "auto", "cells", 0, 100);
    declare_text(prm, "Formula", formula, "formula");
    write_file("words.prm", text);
    ParameterFile("words.prm").read(prm);
    return prm.get("Layer") + ", " + prm.get("Size") + ", " + prm.get("Cells") + ", " +
           prm.get("Formula") + ", " + std::to_string(layer);
  };
  check("words by default", read("") == "none, 0, auto, x, 0.000000");
  check("zeros of earlier files",
        read("set Layer = 0 mm\nset Size = 0\nset Cells = 0\nset Formula = 0\n") ==
          "none, 0, 0, 0, 0.000000");
  dealii::ParameterHandler prm;
  double                   layer = 1;
  declare_quantity(prm, "Layer", layer, "mm", "layer", Range::positive().or_word("none"));
  write_file("words.prm", "\nset Layer = 0\n");
  const std::vector<std::string> zeros = ParameterFile("words.prm").list_zeros_for_words(prm);
  check("zeros for words are listed",
        zeros == std::vector<std::string>{"words.prm:2: Layer = 0 is read as \"none\""});
  check("numbers", read("set Layer = 0.5 mm\n") == "0.5 mm, 0, auto, x, 0.500000");
  print_refusal([&] { read("set Layer = 0 kg\n"); });
  print_refusal([&] { read("set Layer = nothing\n"); });
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

/** Lists of numbers: what may be one number with a comma is none, whatever a blank makes plain is.
 */
void check_number_lists()
{
  const auto read = [](const std::string &text, const ListNumbers numbers = ListNumbers::any) {
    std::vector<std::string> value;
    dealii::ParameterHandler prm;
    declare_number_list(prm, "list", value, "numbers", numbers);
    prm.set("list", text);
    return read_number_list(value, numbers == ListNumbers::whole ? "-" : "rpm");
  };
  using Numbers  = std::vector<double>;
  const auto rpm = [](Numbers numbers) {
    for (double &number : numbers)
      number *= pi / 30.;
    return numbers;
  };
  check("lists with blanks",
        read("0, 5, 10 rpm") == rpm({0, 5, 10}) && read("9, 000 rpm") == rpm({9, 0}) &&
          read("1.5, 2,  1e3") == rpm({1.5, 2, 1e3}) && read("").empty() &&
          read("0, 0, 10") == rpm({0, 0, 10}));
  check("lists without blanks that are no number",
        read("0,5,10 rpm") == rpm({0, 5, 10}) && read("0,4000,9000") == rpm({0, 4000, 9000}) &&
          read("1.5,2") == rpm({1.5, 2}) && read("1,2.5") == rpm({1, 2.5}) &&
          read("-5,-6") == rpm({-5, -6}) && read("0,100,200") == rpm({0, 100, 200}));
  check("lists of whole numbers",
        read("2,3", ListNumbers::whole) == Numbers({2, 3}) &&
          read("0,100", ListNumbers::whole) == Numbers({0, 100}));
  check("the last unit is that of bare numbers",
        read("0, 100, 200 rad/s") == Numbers({0, 100, 200}));
  check("units of their own", read("60 rpm, 2 rad/s") == Numbers({60 * (pi / 30.), 2}));
  for (const char *text : {"9,000 rpm",
                           "1,5",
                           "-1,5 rpm, 2 rpm",
                           "1000, 2,5",
                           "10,000,000",
                           "1,500.5",
                           "1,,2",
                           "1, 2 mm"})
    print_refusal([&] { read(text); });
  print_refusal([&] { read("1,000", ListNumbers::whole); });
  for (const char *text : {"9,000, 0, 0 mm", "9,000, 0 mm", "0,5, 10 mm, 1", "05, 0, 0"})
    print_refusal([text] {
      Vector3                  value = Vector3::Zero();
      dealii::ParameterHandler prm;
      declare_vector(prm, "place", value, "mm", "a place");
      prm.set("place", text);
    });
  Vector3                  value = Vector3::Zero();
  dealii::ParameterHandler prm;
  declare_vector(prm, "place", value, "mm", "a place");
  prm.set("place", "0, 0,10 cm");
  check("three numbers are three numbers", value == Vector3(0, 0, 100));
}

/** An entry that stands a section off its own: the nearest sections that have it. */
void check_misplaced_entries()
{
  dealii::ParameterHandler prm;
  std::array<double, 4>    values = {{1, 2, 3, 4}};
  const std::string        entry  = "web thickness";
  std::string              kind;
  {
    const Subsection pair(prm, "Pair");
    for (unsigned int b = 0; b < 2; ++b)
      {
        const Subsection member(prm, b == 0 ? "Pinion" : "Gear");
        declare_quantity(prm, "diameter", values[2 * b], "mm", "size");
        const Subsection body(prm, "Body");
        declare_quantity(prm, entry, values[2 * b + 1], "mm", "size");
      }
    const Subsection proposal(prm, "Proposal");
    declare_text(prm, "kind", kind, "kind");
  }
  write_file("case.prm", "");
  for (const char *section : {"Pair/Gear", "Pair/Proposal", "Pair", "Pair/Pinion"})
    print_refusal(
      [&] { ParameterFile("case.prm", {std::string(section) + "/web thickness=8"}).read(prm); });
}

int main()
{
  return run_parts({check_good_file,
                    check_first_pass,
                    check_words_for_zero,
                    check_wrong_values,
                    check_wrong_structure,
                    check_number_lists,
                    check_misplaced_entries});
}
