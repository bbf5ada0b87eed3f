// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Adaptive refinement of kind linear static: an L-shaped plate in plane strain, whose inner corner
// has infinite stresses, needs fewer unknowns than uniform refinement; a result that does not
// settle; refused names.
#include "../../model_sections.h"
#include "../../parts.h"
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/output/files/run_figures.h>

using namespace vfife;

/** Three squares of 10 mm, four cells each, one layer: the cells between both legs of the L. */
void write_plate()
{
  constexpr unsigned int n = 2, row = 2 * n + 1, layer = row * row;
  constexpr double       h = 10. / n;
  const auto inside = [](const unsigned int i, const unsigned int j) { return i <= n || j <= n; };
  std::ofstream file("l_plate.inp");
  std::string   sets[3] = {"*NSET, NSET=foot\n", "*NSET, NSET=end\n", "*NSET, NSET=sides\n"};
  file << "*NODE\n";
  for (unsigned int k = 0; k < 2; ++k)
    for (unsigned int j = 0; j < row; ++j)
      for (unsigned int i = 0; i < row; ++i)
        if (inside(i, j))
          {
            const unsigned int node = 1 + i + row * j + layer * k;
            file << node << ", " << i * h << ", " << j * h << ", " << k * h << "\n";
            const bool in_set[3] = {j == 0, i == 2 * n, true};
            for (unsigned int s = 0; s < 3; ++s)
              if (in_set[s])
                sets[s] += std::to_string(node) + ",\n";
          }
  file << "*ELEMENT, TYPE=C3D8, ELSET=plate\n";
  unsigned int element = 0;
  for (unsigned int j = 0; j < 2 * n; ++j)
    for (unsigned int i = 0; i < 2 * n; ++i)
      if (i < n || j < n)
        {
          const unsigned int at = 1 + i + row * j;
          file << ++element;
          for (const unsigned int first : {at, at + layer})
            for (const unsigned int node : {first, first + 1, first + row + 1, first + row})
              file << ", " << node;
          file << "\n";
        }
  for (const std::string &set : sets)
    file << set;
}

std::string plate(const std::string &fem, const std::string &adaptive)
{
  return "subsection Study\n set kind = linear static\nend\n"
         "subsection Model\n set bodies = plate\n set constraints = foot, sides\n"
         " set loads = pull\n set probes = corner\n"
         "subsection Body plate\n set mesh = file\n set file = l_plate.inp\nend\n" +
         model_text::section("Constraint foot",
                             "set nodes = foot\nset kind = displacement\nset directions = x, y\n") +
         model_text::section("Constraint sides",
                             "set nodes = sides\nset kind = displacement\nset directions = z\n") +
         model_text::section("Load pull",
                             "set nodes = end\nset kind = pressure\nset pressure = -10 MPa\n") +
         model_text::probe("corner", "10, 10, 0 mm") +
         "end\nsubsection Output\n set verbosity = quiet\n set field output interval = 0\nend\n"
         "subsection Fem\n set element type = quadratic\n" +
         fem + "end\nsubsection Linear static\n subsection Adaptive refinement\n" + adaptive +
         " end\nend\n";
}

void beside_uniform(Communicator &world)
{
  // Nine steps of the adaptive refinement, 3,918 elements; uniform meshes approach it from below:
  // 0.13040, 0.13121, 0.13151 with 3,375, 22,491 and 163,251 unknowns.
  constexpr double energy = .13168;
  const auto   uniform = run_text("l_uniform", plate(" set local refinement = all 2\n", ""), world);
  const double of_uniform = energy - uniform.at("strain energy")[0];

  run_text("l_plate", plate("", "set result = strain energy\nset tolerance = 2e-3\n"), world);
  const auto  steps  = read_columns("l_plate/adaptive_refinement.csv");
  const auto &change = steps.at("change"), &unknowns = steps.at("unknowns"),
             &value = steps.at("value"), &error = steps.at("error indicator");
  check("a row per mesh", steps.at("step").size() == 5 && steps.at("step").back() == 4);
  check_below("the last change ends it [%]", change.back(), .2);
  check_below("and none before [%]", .2, change[change.size() - 2]);
  check_close("change of the result [%]",
              change.back(),
              100 * (value[4] - value[3]) / value[4],
              1e-10);
  check_close("change by the last refinement in the summary [%]",
              read_figure("l_plate/summary.json", "/figures/change by the last refinement/value"),
              change.back(),
              1e-10);
  // Displacements are as r^0.544 at the corner, so that on uniform meshes derivatives converge
  // with h^0.544, unknowns to the power -0.18.
  check("indicators fall faster than on uniform meshes",
        std::log(error.back() / error.front()) / std::log(unknowns.back() / unknowns.front()) <
          -.4);
  const double of_uniform_mesh = 22491;
  check_below("unknowns for the error of the uniform mesh, over its own",
              unknowns[3] / of_uniform_mesh,
              1. / 3);
  check_below("their error over that of the uniform mesh", (energy - value[3]) / of_uniform, 1.);
  check_below("fields and histories are of the last mesh [mJ]",
              std::abs(read_columns("l_plate/history.csv").at("strain energy")[0] - value[4]),
              1e-12);
}

void unsettled(Communicator &world)
{
  run_text("l_corner",
           plate("",
                 "set result = corner von mises\nset tolerance = 1e-3\nset maximum steps = 2\n"),
           world);
  const auto steps = read_columns("l_corner/adaptive_refinement.csv");
  check("at most so many steps", steps.at("step").back() == 2);
  check_below("stress of a sharp corner does not settle [%]", 5., steps.at("change").back());
}

void refusals(Communicator &world)
{
  print_refusal([&] { run_text("l_refused", plate("", "set result = corner von mses\n"), world); });
  print_refusal([&] { run_text("l_refused", plate("", "set marked part = 2\n"), world); });
}

int main(int argc, char **argv)
{
  write_plate();
  run_parts<Communicator>(argc, argv, {beside_uniform, unsettled, refusals});
  return 0;
}
