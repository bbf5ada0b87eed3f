// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Study kind linear static against closed forms: loads, springs, histories, reactions, prescribed
// displacements, spin; what it refuses; a gear pair's members in their turning axes.
#include "../model_sections.h"
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"
#include "prescribed_ring.h"
#include "quick_pair.h"

#include <vfife/base/errors.h>
#include <vfife/base/types.h>

#include <filesystem>

using namespace vfife;

namespace
{
  using Columns = std::map<std::string, std::vector<double>>;

  Columns run_static(const std::string &name, const std::string &text, Communicator &world)
  {
    return run_text(name, "subsection Study\n set kind = linear static\nend\n" + text, world);
  }

  constexpr double E = 206000, length = 100, side = 10;

  /** A bar of 100 x 10 x 10 mm, nu = 0, with loads on its end; @p support: of the other end. */
  std::string bar(const std::string &support, const std::string &load, const std::string &more = "")
  {
    return R"(
subsection Model
  set bodies      = bar
  set constraints = foot
  set loads       = load
  set probes      = tip, corner
)" + model_text::block("bar", {{100, 10, 10}}, {{10, 2, 2}}) +
           model_text::section("Constraint foot", "set nodes = x-\n" + support + "\n") +
           model_text::section("Load load", "set nodes = x+\n" + load + "\n") +
           model_text::probe("tip", "100, 5, 5 mm") + model_text::probe("corner", "50, 5, 10 mm") +
           more + R"(
end
subsection Material steel
  set Poisson's ratio = 0
end
subsection Output
  set verbosity = quiet
end
)";
  }

  void pulled(Communicator &world)
  {
    const double stretch = 1000. * length / (E * side * side);
    const auto   check_pulled =
      [&](const std::string &name, const std::string &text, const double factor) {
        auto h = run_static("linear_bar", text, world);
        // The solver's tolerance is 1e-10.
        check_close(name + ": displacement over F L/(E A)",
                    h["tip displacement x"].back() / stretch,
                    factor,
                    1e-8);
        check_close(name + ": stress [MPa]", h["corner stress x"].back(), 10. * factor, 1e-6);
      };
    const std::string fixed = "set kind = fixed",
                      force = "set kind = force\nset force = 1000, 0, 0 N";
    check_pulled("force", bar(fixed, force), 1.);
    check_pulled("pressure", bar(fixed, "set kind = pressure\nset pressure = -10 MPa"), 1.);
    check_pulled("history",
                 bar(fixed, force + "\nset history = 3*t") +
                   "subsection Linear static\n set loads = at time\n set time = 0.5 s\nend\n",
                 1.5);
    check_pulled("quadratic elements, direct solver",
                 bar(fixed, "set kind = pressure\nset pressure = -10 MPa") +
                   "subsection Fem\n set linear solver = direct\n set element = quadratic\nend\n",
                 1.);

    auto h = run_static("linear_bar",
                        bar("set kind = spring\nset stiffness = 5000, 5000, 5000 N/mm", force),
                        world);
    check_close("spring: displacement over F/k + F L/(E A)",
                h["tip displacement x"].back() / (1000. / 5000 + stretch),
                1.,
                1e-8);
    check_close("spring: energy over that of spring and bar",
                h["strain energy"].back() / (500. * (1000. / 5000 + stretch)),
                1.,
                1e-8);
  }

  void bent(Communicator &world)
  {
    // Plane sections and a linear field of strains: exact with incompatible modes.
    auto h =
      run_static("linear_bent",
                 bar("set kind = fixed", "set kind = moment\nset moment = 0, -20000, 0 N mm"),
                 world);
    const double I   = side * side * side * side / 12;
    const double sag = 20000. * length * length / (2 * E * I);
    check_close("moment: deflection over M L^2/(2 E I)",
                h["tip displacement z"].back() / sag,
                1.,
                1e-8);
    check_close("moment: stress over M z/I",
                h["corner stress x"].back() / (-20000. * 5 / I),
                1.,
                1e-8);
    check("fields are written", std::filesystem::exists("linear_bent/fields/bar.vtu"));
    check("a summary is written", std::filesystem::exists("linear_bent/summary.json"));

    // About the bar's axis, along z through its centre: both forces of 200 N have an arm of 50 mm.
    run_static("linear_bent",
               bar("set kind = fixed", "set kind = force\nset force = 0, 200, 0 N"),
               world);
    const auto reactions = read_columns("linear_bent/reactions.csv");
    check_close("reaction y [N]", reactions.at("force y").front(), -200., 1e-5);
    check_below("reaction x [N]", reactions.at("force x").front(), 1e-5);
    check_close("reaction about the axis [N m]",
                reactions.at("torque about the axis").front(),
                -10.,
                1e-6);
  }

  void spun(Communicator &world)
  {
    std::filesystem::remove_all("linear_spun");
    CommandLine line;
    line.parameter_file = std::string(SOURCE_DIR) + "/../../prm/verification/rotating_bar.prm";
    line.output_folder  = "linear_spun";
    line.overrides      = {"Study/kind=linear static",
                           "Output/verbosity=quiet",
                           "Fem/mass=consistent",
                           "Linear static/stress stiffness=no"};
    std::ostringstream nothing;
    Log                log(nothing, world.is_root(), Verbosity::quiet);
    run_study(line, world, log);
    // L (tan(kL)/(kL) - 1); 100 elements: (kL)^2/(12 100^2) of it.
    check_close("spinning bar, load on the moved mass [mm]",
                read_columns("linear_spun/history.csv")["end displacement x"].back(),
                15.1572,
                2e-4);
    line.overrides.back() = "Linear static/spin softening=no";
    line.overrides.push_back("Linear static/stress stiffness=no");
    run_study(line, world, log);
    check_close("spinning bar, linear [mm]",
                read_columns("linear_spun/history.csv")["end displacement x"].back(),
                14.6250,
                2e-4);
  }

  void prescribed_ring_cases(Communicator &world)
  {
    auto         ring = run_static("linear_ring",
                           prescribed_ring() + "subsection Output\n set verbosity = quiet\nend\n",
                           world);
    const double a = 20, b = 40, nu = 0.29;
    // Lame, plane stress; chords of 6 degrees, ten cells: some 1e-3.
    const double grown =
      0.01 * ((1 - nu) * b + (1 + nu) * b) / ((1 - nu) * a + (1 + nu) * b * b / a);
    check_close("prescribed radius: growth outside over Lame's",
                ring["outer displacement r"].back() / grown,
                1.,
                5e-3);
    check_close("prescribed angle: way outside over r phi",
                ring["outer displacement theta"].back() / (40 * pi / 360),
                1.,
                1e-8);
  }

  void pair(Communicator &world)
  {
    std::filesystem::remove_all("linear_pair");
    std::ofstream("linear_pair.prm")
      << quick_pair("set web = conical", coarse_web, "1e-5")
      << "subsection Study\n set kind = linear static\nend\nsubsection Fem\n set bodies = "
         "gear\nend\n";
    run_pair("linear_pair.prm", "linear_pair", world);
    std::ifstream file("linear_pair/probes.csv");
    std::string   line;
    unsigned int  n = 0;
    while (std::getline(file, line))
      ++n;
    check("a row for each probe of the pair", n == 3);
  }

  void refused(const std::string &text, Communicator &world)
  {
    print_refusal([&] { run_static("linear_refused", text, world); });
  }

  void errors(Communicator &world)
  {
    const std::string force = "set kind = force\nset force = 1, 0, 0 N";
    refused(bar("set kind = fixed",
                force,
                "set contacts = floor\nsubsection Contact floor\nset kind = wall\nset nodes = z-\n"
                "set wall normal = 0, 0, 1\nend\n"),
            world);
    refused(bar("set kind = displacement\nset directions = x", force), world);
    refused(bar("set kind = fixed", force) + "subsection Linear static\nset time = 1 s\nend\n",
            world);
    refused(bar("set kind = fixed", force) + "subsection Fem\nset cyclic symmetry = yes\nend\n",
            world);
  }
} // namespace

int main(int argc, char **argv)
{
  run_parts(argc, argv, {pulled, bent, spun, prescribed_ring_cases, pair, errors});
}
