// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The cases of prm/verification on coarse meshes against closed forms; doc/verification/element.md
// has the fine ones.
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>

using namespace vfife;

std::string file_of(const std::string &name)
{
  return tree_folder() + "/prm/verification/" + name + ".prm";
}

Columns run_case(const std::string              &name,
                 const std::vector<std::string> &overrides,
                 Communicator                   &communicator)
{
  std::vector<std::string> all = overrides;
  all.emplace_back("Output/verbosity=quiet"); // no progress on the screen
  run_pair(file_of(name), "results_" + name, communicator, all);
  return read_columns("results_" + name + "/history.csv");
}

void free_spin(Communicator &world)
{
  auto        h       = run_case("free_spin", {"Dynamics/end time=0.6283185307 ms"}, world);
  const auto &angular = h["angular momentum z"];
  // 10^4 steps of sums of 135 terms.
  check_below("free spin: drift of angular momentum", angular.back() / angular.front() - 1, 1e-12);
  check_below("free spin: momentum over m omega r",
              largest_of(largest_size(h["momentum x"]), largest_size(h["momentum y"])) /
                (6.28e-6 * 20000 * 10),
              1e-12);
  // A fifth of the largest stable step; doc/verification/element.md shows how the error falls
  // with it.
  check_below("free spin: energy error", largest_size(h["energy error"]), 0.005);

  // The published frame is not free of moments, to the order of the strain (1e-3).
  auto three =
    run_case("free_spin",
             {"Dynamics/end time=0.6283185307 ms", "Dynamics/corotational frame=three nodes"},
             world);
  const double drift =
    std::abs(three["angular momentum z"].back() / three["angular momentum z"].front() - 1);
  check("free spin: three nodes drift, but little", drift > 1e-10 && drift < 1e-4);
}

void tumbling(Communicator &world)
{
  auto h = run_case("tumbling", {"Dynamics/end time=0.3 ms"}, world);
  for (const char *axis : {"x", "y", "z"})
    {
      const auto &p = h[std::string("momentum ") + axis];
      check_ratio(std::string("tumbling: momentum ") + axis, p.back() / p.front(), 1e-11);
    }
  check_below("tumbling: energy error", largest_size(h["energy error"]), 0.005);
}

void bar_impact(Communicator &world)
{
  auto         h = run_case("bar_impact", {"Model/Body bar/elements x=100"}, world);
  const auto  &t = h["time"], &force = h["contact force total"];
  const double step = t[1] - t[0], wave = 68.951e-6;
  double       impulse = 0, plateau = 0, last = 0;
  unsigned int n = 0;
  for (std::size_t i = 0; i < t.size(); ++i)
    {
      impulse += step * force[i];
      last = force[i] > 0 ? t[i] : last;
      if (t[i] > 0.2 * wave && t[i] < 0.8 * wave)
        {
          plateau += force[i];
          ++n;
        }
    }
  // Ripples behind the front average out; c, A, rho, v0 enter all.
  check_close("bar impact: force [MN]", 1e-6 * plateau / n, 1.8564, 0.01 * 1.8564);
  // The front is spread over some (100 cells)^(1/3) cells.
  check_ratio("bar impact: duration over 2 L/c", last / wave, 0.05);
  // Vibration that stays behind the dispersed front.
  check_close("bar impact: momentum after over before",
              h["momentum x"].back() / h["momentum x"].front(),
              -1.,
              0.01);
  check_ratio("bar impact: impulse over change of momentum",
              impulse / (h["momentum x"].back() - h["momentum x"].front()),
              1e-9);
  check_below("bar impact: energy error", largest_size(h["energy error"]), 0.005);
}

void two_bars(Communicator &world)
{
  auto        h = run_case("two_bars", {}, world);
  const auto &p = h["momentum x"];
  check_ratio("two bars: momentum", p.back() / p.front(), 1e-11);
  const std::size_t n = h["time"].size();
  const double      v = (h["ahead displacement x"][n - 1] - h["ahead displacement x"][n - 101]) /
                   (h["time"][n - 1] - h["time"][n - 101]);
  // The vibration behind the dispersed front, over a hundred steps.
  // Of the energy of approach, m v^2/4; the step of the first touch crosses the penalty's kink.
  check_below("two bars: energy error", largest_size(h["energy error"]), 0.005);
  check_close("two bars: velocity of the struck one [m/s]", 1e-3 * v, 2., 0.1);
}

void rotating(Communicator &world)
{
  auto         bar   = run_case("rotating_bar", {"Model/Body bar/elements x=20"}, world);
  const double exact = 15.15724, u = bar["end displacement x"].back();
  // Lumped masses of 20 elements: (k L)^2/20^2 of the difference between bar and point masses.
  check_close("rotating bar: displacement of the end [mm]", u, exact, 2e-3 * exact);

  auto disc = run_case("rotating_disc",
                       {"Model/Body disc/radial elements=10", "Model/Body disc/elements around=48"},
                       world);
  // Chords of 7.5 degrees: the radius of the cells' middles is 0.2 % smaller.
  check_close("rotating disc: u(a) [um]",
              1e3 * disc["inside displacement r"].back(),
              12.979,
              0.005 * 12.979);
  check_close("rotating disc: u(b) [um]",
              1e3 * disc["outside displacement r"].back(),
              11.787,
              0.005 * 11.787);
  // Stresses at the edge are extrapolated within cells of 7.5 mm.
  check_close("rotating disc: hoop stress inside [MPa]",
              disc["inside stress theta"].back(),
              53.475,
              0.03 * 53.475);
}

void large_rotation(Communicator &world)
{
  const std::vector<std::string> coarse = {"Model/Body beam/elements along length=20",
                                           "Model/Body beam/height=4 mm",
                                           "Dynamics/Relaxation/tolerance=1e-5"};
  // Eight times the bending stiffness of the file's beam; strains are 3 % at the end.
  auto overrides = coarse;
  overrides.emplace_back("Model/Load end/moment=0, -86289.077, 0 N mm");
  auto       rolled = run_case("rolled_cantilever", overrides, world);
  const auto check_tip =
    [](const std::string &name, const double displacement, const double reference) {
      check_close(name, displacement / 100, reference, 3e-3);
    };
  // Polygon of 20 chords: (t/20)^2/24 = 3e-4; strains of second order 1e-3.
  check_tip("rolled cantilever: u/L", rolled["tip displacement x"].back(), -0.363380);
  check_tip("rolled cantilever: w/L", rolled["tip displacement z"].back(), 0.636620);

  overrides = coarse;
  overrides.emplace_back("Model/Load end/force=0, 0, 2197.33333 N");
  auto elastica = run_case("elastica", overrides, world);
  // Shear adds (E/G) (h/L)^2 1.2/4 = 1e-3 of the deflection, the load's second order the same.
  const auto &u = elastica["tip displacement x"], &w = elastica["tip displacement z"];
  check_tip("elastica, P L^2/EI = 1: u/L", u.front(), -0.056433);
  check_tip("elastica, P L^2/EI = 1: w/L", w.front(), 0.301721);
  check_tip("elastica, P L^2/EI = 4: u/L", u.back(), -0.328941);
  check_tip("elastica, P L^2/EI = 4: w/L", w.back(), 0.669964);
}

void refuse(const std::string              &name,
            const std::vector<std::string> &overrides,
            Communicator                   &communicator)
{
  const std::string text = message_of([&] { check_case(file_of(name), communicator, overrides); });
  std::cout << (text.empty() ? "FAILED: accepted" : text.substr(text.find("--set"))) << std::endl;
}

/** The message says where the file was looked for: an absolute path, different on each machine.
 */
void refuse_missing_file(Communicator &communicator)
{
  const std::string text = message_of([&] {
    run_pair(file_of("plate_with_hole"),
             "results_plate_with_hole",
             communicator,
             {"Model/Body plate/file=nothing.msh"});
  });
  check("a mesh file that is not there is named",
        has_text(text, "(Model/Body plate/file)") && has_text(text, "verification/nothing.msh\""));
}

int main(int argc, char **argv)
{
  MpiSession    session(argc, argv);
  Communicator &world = session.world();
  free_spin(world);
  tumbling(world);
  bar_impact(world);
  two_bars(world);
  rotating(world);
  large_rotation(world);

  refuse("elastica", {"Model/Body beam/lenght=5 mm"}, world);
  refuse("elastica", {"Model/Body beam/mesh=beem"}, world);
  refuse("elastica", {"Model/Load end/nodes=x*"}, world);
  refuse("elastica", {"Model/Load end/force=1, 2 N"}, world);
  refuse("elastica", {"Model/Load end/history=sin(tt)"}, world);
  refuse("elastica", {"Model/Load end/body=beem"}, world);
  refuse("elastica", {"Model/Constraint clamp/where=x > 0"}, world);
  refuse("bar_impact", {"Dynamics/end time=0"}, world);
  refuse("bar_impact", {"Model/Constraint lateral/directions=y, theta"}, world);
  refuse_missing_file(world);
  return 0;
}
